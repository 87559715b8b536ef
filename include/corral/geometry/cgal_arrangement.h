// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_GEOMETRY_CGAL_ARRANGEMENT_H
#define CORRAL_GEOMETRY_CGAL_ARRANGEMENT_H

#include <corral/geometry/polylines.h>

#include <CGAL/Arrangement_2.h>
#include <CGAL/Gmpq.h>

#include <concepts>
#include <vector>

/// \file
/// Meshes of curves as points, polylines and arrangements of CGAL. Costs nothing unless it is included.
namespace corral {

/// \brief A point of a CGAL kernel. \tparam Kernel  exact if the point is to be; its `FT` is made from a `Rational` or
/// a `CGAL::Gmpq`.
template <class Kernel>
[[nodiscard]] typename Kernel::Point_2 to_cgal_point(const Rational_point<2>& point)
{
  using Number = typename Kernel::FT;
  const auto number = [](const Rational& q) {
    if constexpr (std::constructible_from<Number, const Rational&>)
      return Number(q);
    else
      return Number(CGAL::Gmpq(q.get_mpq_t()));
  };
  return {number(point[0]), number(point[1])};
}

/// The lines of a mesh as in `polylines`, as points of a CGAL kernel, such as `CGAL::draw` and triangulations take.
template <class Kernel>
[[nodiscard]] std::vector<std::vector<typename Kernel::Point_2>> cgal_polylines(const Curve_mesh& mesh)
{
  std::vector<std::vector<typename Kernel::Point_2>> result;
  for (const auto& line : polylines(mesh)) {
    auto& points = result.emplace_back();
    for (const std::size_t v : line) points.push_back(to_cgal_point<Kernel>(mesh.vertices[v].point));
  }
  return result;
}

/// \brief The arrangement of the edges and isolated points of a mesh; its bounded faces are those that the curve makes.
/// \tparam Arrangement  a `CGAL::Arrangement_2` of segments over an exact kernel, as by `CGAL::Arr_segment_traits_2`.
/// \par Complexity  n log n for n edges, since no two cross.
template <class Arrangement>
[[nodiscard]] Arrangement cgal_arrangement(const Curve_mesh& mesh)
{
  using Traits = typename Arrangement::Geometry_traits_2;
  using Segment = typename Traits::X_monotone_curve_2;
  using Kernel = typename Traits::Kernel;
  std::vector<Segment> segments;
  segments.reserve(mesh.edges.size());
  for (const auto& [a, b] : mesh.edges)
    segments.emplace_back(to_cgal_point<Kernel>(mesh.vertices[a].point), to_cgal_point<Kernel>(mesh.vertices[b].point));
  Arrangement arrangement;
  CGAL::insert_non_intersecting_curves(arrangement, segments.begin(), segments.end());
  for (const auto& vertex : mesh.vertices)
    if (vertex.branches == 0) CGAL::insert_point(arrangement, to_cgal_point<Kernel>(vertex.point));
  return arrangement;
}

} // namespace corral

#endif
