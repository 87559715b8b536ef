// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_TEST_GEOMETRY_CGAL_TOPOLOGY_H
#define CORRAL_TEST_GEOMETRY_CGAL_TOPOLOGY_H

#include <corral/polynomial/Polynomial.h>

#include <cstddef>
#include <string>

namespace corral::test {

/// What CGAL's analysis says of the real points of a curve in the whole plane.
struct Plane_topology
{
  std::size_t components = 0;
  std::size_t closed = 0;   ///< bounded components
  std::size_t isolated = 0; ///< components that are a point
  std::size_t ends = 0;     ///< of branches, at infinity
  long euler = 0;           ///< the Euler characteristic, with a point at each end

  friend bool operator==(const Plane_topology&, const Plane_topology&) = default;
};

[[nodiscard]] std::string to_string(const Plane_topology& topology);

/// \brief The topology of f = 0 by CGAL's `Algebraic_kernel_d_2` and union-find over its arcs. Shares nothing with
/// `mesh_curve`. \pre f is square-free and not constant. \par Reference  Eigenwillig, Kerber and Wolpert 2007.
[[nodiscard]] Plane_topology cgal_topology(const Polynomial<Integer, 2>& f);

/// \brief A number R so large that the part of the curve in [-R, R]^2 has the topology of the whole.
///
/// It is above |x| and |y| at all critical points of both projections, and on both diagonals: outside the box the
/// greater of |x| and |y| is then monotone on every arc, so each goes from the border to infinity.
/// \pre as above.
[[nodiscard]] Integer cgal_reach(const Polynomial<Integer, 2>& f);

} // namespace corral::test

#endif
