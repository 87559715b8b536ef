// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_GEOMETRY_POINT_REPRESENTATION_H
#define CORRAL_SRC_GEOMETRY_POINT_REPRESENTATION_H

#include "../algebra/Projected_zeros.h"

#include <corral/geometry/Algebraic_point.h>

#include <array>
#include <memory>
#include <utility>

namespace corral {

namespace geometry {

/// Two coprime polynomials, and what their zeros share: polynomials with the coordinates as roots.
class Plane_pair
{
public:
  Plane_pair(Polynomial<Integer, 2> f, Polynomial<Integer, 2> g) : f_(std::move(f)), g_(std::move(g)) {}
  /// A square-free polynomial that vanishes at coordinate `axis` of every common zero.
  [[nodiscard]] const std::shared_ptr<const Integer_polynomial>& projection(std::size_t axis);

private:
  Polynomial<Integer, 2> f_;
  Polynomial<Integer, 2> g_;
  std::array<std::shared_ptr<const Integer_polynomial>, 2> projections_;
};

} // namespace geometry

class Algebraic_point::Representation
{
public:
  Representation(exact::Projected_zero projected, std::shared_ptr<geometry::Plane_pair> system)
      : zero(std::move(projected)), pair(std::move(system))
  {}

  exact::Projected_zero zero;
  std::shared_ptr<geometry::Plane_pair> pair;
  Rational_box<2> box;
  std::array<std::optional<Real_root>, 2> coordinates{};
};

} // namespace corral

#endif
