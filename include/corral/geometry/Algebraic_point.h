// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_GEOMETRY_ALGEBRAIC_POINT_H
#define CORRAL_GEOMETRY_ALGEBRAIC_POINT_H

#include <corral/algebra/real_roots.h>
#include <corral/polynomial/Box.h>
#include <corral/polynomial/Polynomial.h>

#include <compare>
#include <memory>
#include <optional>

namespace corral {

/// \brief A point of the plane that is a common zero of two coprime polynomials, known exactly.
///
/// A copy shares what has been found out with the original; not safe for several threads at once.
class Algebraic_point
{
public:
  class Representation; ///< of the library
  explicit Algebraic_point(std::shared_ptr<Representation> representation);

  /// A box that contains the point. Boxes of the points that one call of `solve` returned do not meet.
  [[nodiscard]] const Rational_box<2>& box() const;
  /// Makes the sides of the box no longer than `width`. \pre width > 0. \par Complexity  Quadratic convergence.
  void refine_to(const Rational& width);
  /// The multiplicity of the intersection of the two polynomials here, at least 1.
  [[nodiscard]] unsigned multiplicity() const;
  /// The point, if both coordinates are rational.
  [[nodiscard]] std::optional<Rational_point<2>> rational() const;
  /// The exact sign of a polynomial here. \par Complexity  intervals if it is not zero; else one univariate
  /// polynomial of the product of the degrees.
  [[nodiscard]] int sign_of(const Polynomial<Rational, 2>& q) const;
  /// The coordinates as roots of univariate polynomials. \par Complexity  a resultant, at the first call for an axis
  /// of any point of the same system.
  [[nodiscard]] Real_root coordinate(std::size_t axis) const;

  /// By x, then by y, exactly.
  friend std::strong_ordering operator<=>(const Algebraic_point& a, const Algebraic_point& b);
  friend bool operator==(const Algebraic_point& a, const Algebraic_point& b) { return (a <=> b) == 0; }

private:
  std::shared_ptr<Representation> representation_;
};

} // namespace corral

#endif
