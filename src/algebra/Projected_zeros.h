// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_ALGEBRA_PROJECTED_ZEROS_H
#define CORRAL_SRC_ALGEBRA_PROJECTED_ZEROS_H

#include "Bivariate.h"

#include <corral/polynomial/Box.h>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace corral::exact {

/// \brief A real point of the plane by one algebraic number: with u = x + shear * y a root of a polynomial,
/// y = -s0(u) / s1(u).
class Projected_zero
{
public:
  using Shared_polynomial = std::shared_ptr<const Integer_polynomial>;

  /// \pre s1 is not zero at u.
  Projected_zero(Real_root u, Shared_polynomial s1, Shared_polynomial s0, long shear, unsigned fibre_degree);

  /// The multiplicity of the intersection of the two polynomials whose common zero this is.
  [[nodiscard]] unsigned multiplicity() const { return u_.multiplicity(); }
  /// The degree in y of the greatest common divisor of the two on the line x + shear * y = u.
  [[nodiscard]] unsigned fibre_degree() const { return fibre_degree_; }
  [[nodiscard]] long shear() const { return shear_; }
  [[nodiscard]] const Real_root& u() const { return u_; }

  /// A box that contains the point, no wider than `width` in both directions. \pre width > 0.
  [[nodiscard]] Rational_box<2> box(const Rational& width);
  /// The point if its u is rational, and so it is.
  [[nodiscard]] std::optional<Rational_point<2>> rational();
  /// The exact sign of a x + b y + c.
  [[nodiscard]] int sign_of_linear(const Rational& a, const Rational& b, const Rational& c);
  /// The exact sign of q. \par Complexity  if q vanishes, one univariate polynomial of degree deg(q) deg(s1).
  [[nodiscard]] int sign_of(const Polynomial<Integer, 2>& q);
  [[nodiscard]] bool equals(const Rational_point<2>& point);
  /// \pre The shears are equal.
  [[nodiscard]] bool equals(Projected_zero& other);
  /// Whether it lies in a closed box.
  [[nodiscard]] bool is_in(const Rational_box<2>& box);

private:
  [[nodiscard]] std::optional<Rational_interval> y() const;

  Real_root u_;
  Shared_polynomial s1_;
  Shared_polynomial s0_;
  long shear_;
  unsigned fibre_degree_;
};

/// Whether two real roots are the same number.
[[nodiscard]] bool same(Real_root a, Real_root b);

/// The common zeros of two polynomials in one direction.
struct Projection_result
{
  std::vector<Projected_zero> zeros;
  /// Square-free polynomials that vanish at u for every common zero, complex ones included.
  std::vector<std::shared_ptr<const Integer_polynomial>> factors;
};

/// f(u - shear * y, y), with u in the place of x.
[[nodiscard]] Polynomial<Integer, 2> sheared(const Polynomial<Integer, 2>& f, long shear);

/// Slopes of projections in the order in which to try them. Few curves have two of the points sought on one such line.
inline constexpr std::array<long, 10> shears{3, -5, 7, -11, 17, -23, 31, -43, 61, -97};

/// \brief The common real zeros of two polynomials along the lines x + shear * y = const; nothing if two of them, or
/// the multiplicities at infinity, cannot be told apart in this direction.
///
/// The resultant of f(u - shear y, y) and g(u - shear y, y) with respect to y has the roots u, each as often as the
/// multiplicity of the intersection. Where the linear subresultant s1 y + s0 has s1(u) != 0, it gives y; elsewhere the
/// greatest common divisor over Q(u) does.
/// \param least_multiplicity  zeros of lower multiplicity are left out.
/// \pre f and g are coprime and not zero. \throw whatever `checkpoint` throws.
[[nodiscard]] std::optional<Projection_result>
projected_zeros(const Polynomial<Integer, 2>& f, const Polynomial<Integer, 2>& g, long shear,
                const std::optional<Rational_box<2>>& box, unsigned least_multiplicity, const Checkpoint& checkpoint);

} // namespace corral::exact

#endif
