// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_ALGEBRA_EXTENSION_H
#define CORRAL_SRC_ALGEBRA_EXTENSION_H

#include "Field_polynomial.h"

#include <corral/algebra/real_roots.h>

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
  using Element = Rational_coefficients;
  struct Split
  {
    Integer_polynomial factor;
  };

  Extension(Integer_polynomial m, Real_root alpha);

  [[nodiscard]] const Integer_polynomial& modulus() const { return m_; }
  [[nodiscard]] const Real_root& alpha() const { return alpha_; }
  [[nodiscard]] Element reduce(Element a) const;

  [[nodiscard]] static Element one() { return {1}; }
  [[nodiscard]] static Element negative(Element a);
  [[nodiscard]] static Element times(Element a, unsigned long factor);
  static void subtract(Element& a, const Element& b);
  [[nodiscard]] Element multiply(const Element& a, const Element& b) const;
  /// \pre a is not zero. \throw Split if a has no inverse.
  [[nodiscard]] Element inverse(const Element& a) const;

private:
  Integer_polynomial m_;
  Rational_coefficients monic_;
  Real_root alpha_;
};

/// \brief Q(alpha)[y]/h for a square-free h, used as if it were the field Q(alpha, beta) of one real root beta of h.
///
/// As `Extension`, one floor up: an element that is neither zero nor invertible splits h.
class Tower
{
public:
  using Element = Extension_polynomial;
  struct Split
  {
    Extension_polynomial factor; ///< monic, with the root beta
  };

  /// \param h  monic and square-free over `base`; beta is its one root in the interval, and h changes sign over it,
  ///           or h is y - beta.
  Tower(Extension base, Extension_polynomial h, Rational_interval beta);

  [[nodiscard]] Element reduce(Element a) const;

  [[nodiscard]] static Element one() { return {Extension::one()}; }
  [[nodiscard]] static Element negative(Element a);
  [[nodiscard]] static Element times(Element a, unsigned long factor);
  static void subtract(Element& a, const Element& b);
  [[nodiscard]] Element multiply(const Element& a, const Element& b) const;
  /// \pre a is not zero. \throw Split if a has no inverse; Extension::Split.
  [[nodiscard]] Element inverse(const Element& a) const;

private:
  Extension base_;
  Extension_polynomial h_;
  Rational_interval beta_;
};

/// h(x, y) at a rational y: a polynomial in x, times a positive integer.
[[nodiscard]] Integer_polynomial value_at(const Extension_polynomial& h, const Rational& y);

/// The irreducible factor of alpha's polynomial that vanishes at alpha (FLINT). \pre alpha is not known as a rational.
[[nodiscard]] Integer_polynomial irreducible_factor(const Real_root& alpha);

} // namespace corral::exact

#endif
