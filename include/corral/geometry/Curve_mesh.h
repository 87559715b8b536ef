// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_GEOMETRY_CURVE_MESH_H
#define CORRAL_GEOMETRY_CURVE_MESH_H

#include <corral/polynomial/Box.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace corral {

/// A vertex of a curve's mesh.
struct Curve_vertex
{
  Rational_point<2> point; ///< where the mesh has it
  Rational_box<2> box; ///< holds the zero that the vertex stands for, and no other one on the cut or side it lies on
  bool is_singular = false;
  bool is_on_boundary = false; ///< of the box that was meshed
  std::size_t branches = 0;    ///< edges that end here
  std::size_t component = 0;
};

/// A connected component of the part of a curve in a box.
struct Curve_component
{
  std::size_t first_vertex = 0;
  std::size_t vertices = 0;
  std::size_t edges = 0;
  bool is_closed = true; ///< does not meet the boundary of the box
  /// The component of which it lies in a bounded face, the innermost; none if it lies in no such face.
  std::optional<std::size_t> parent{};
  [[nodiscard]] bool is_point() const { return edges == 0; }
};

/// A part of the box of which the mesh says nothing, and why.
struct Uncertified_region
{
  Rational_box<2> box;
  std::string reason;
};

/// \brief A straight-line plane graph that is isotopic within a box to the part of a plane curve in it.
///
/// Unless there are uncertified regions, in which nothing is claimed.
struct Curve_mesh
{
  Rational_box<2> box;
  std::vector<Curve_vertex> vertices;
  std::vector<std::array<std::size_t, 2>> edges; ///< indices of vertices
  std::vector<Curve_component> components;
  std::vector<Uncertified_region> uncertified;
  std::size_t cells = 0; ///< that were looked at

  [[nodiscard]] bool is_certified() const { return uncertified.empty(); }
  /// Components that do not meet the boundary of the box.
  [[nodiscard]] std::size_t closed_components() const;
  /// Components that are a single point.
  [[nodiscard]] std::size_t isolated_points() const;
  [[nodiscard]] std::size_t singular_points() const;
  [[nodiscard]] std::size_t boundary_points() const;
  /// Vertices minus edges.
  [[nodiscard]] long euler_characteristic() const;
};

} // namespace corral

#endif
