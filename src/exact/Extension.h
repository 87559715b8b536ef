// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_EXACT_EXTENSION_H
#define CORRAL_EXACT_EXTENSION_H

#include <corral/verification/real_roots.h>

#include <vector>

namespace corral::exact {

/// A polynomial over the rationals, from the constant coefficient up, without vanishing leading ones.
using Rational_coefficients = std::vector<Rational>;

/// A polynomial in y over an extension, leading coefficient not zero.
using Extension_polynomial = std::vector<Rational_coefficients>;

/// \brief Q[x]/m for a square-free m, used as if it were the field Q(alpha) of one of its real roots.
///
/// m need not be irreducible. An element that is neither zero nor invertible splits m; `Split` then names the factor
/// that belongs to alpha, and the caller starts again with it.
class Extension
{
public:
  struct Split
  {
    Integer_polynomial factor;
  };

  Extension(Integer_polynomial m, Real_root alpha);

  [[nodiscard]] const Integer_polynomial& modulus() const { return m_; }
  [[nodiscard]] Rational_coefficients reduce(Rational_coefficients a) const;
  [[nodiscard]] Rational_coefficients multiply(const Rational_coefficients& a, const Rational_coefficients& b) const;
  /// \pre a is not zero. \throw Split if a has no inverse.
  [[nodiscard]] Rational_coefficients inverse(const Rational_coefficients& a) const;

  /// The monic greatest common divisor. \throw Split \pre not both zero.
  [[nodiscard]] Extension_polynomial gcd(Extension_polynomial p, Extension_polynomial q) const;
  /// The monic square-free part. \throw Split \pre p is monic.
  [[nodiscard]] Extension_polynomial square_free_part(const Extension_polynomial& p) const;

private:
  void make_monic(Extension_polynomial& p) const;
  [[nodiscard]] Extension_polynomial divide(Extension_polynomial& p, const Extension_polynomial& q) const;

  Integer_polynomial m_;
  Rational_coefficients monic_;
  Real_root alpha_;
};

/// The irreducible factor of alpha's polynomial that vanishes at alpha (FLINT). \pre alpha is not known as a rational.
[[nodiscard]] Integer_polynomial irreducible_factor(const Real_root& alpha);

} // namespace corral::exact

#endif
