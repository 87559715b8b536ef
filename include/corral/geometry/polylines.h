// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_GEOMETRY_POLYLINES_H
#define CORRAL_GEOMETRY_POLYLINES_H

#include <corral/geometry/Curve_mesh.h>

#include <cstddef>
#include <vector>

namespace corral {

/// \brief The lines of a mesh, as indices of its vertices: from vertices that do not have two edges, or around, until
/// the next one.
///
/// Each edge is in one line; an isolated point is a line of one vertex, a closed line ends where it began.
[[nodiscard]] std::vector<std::vector<std::size_t>> polylines(const Curve_mesh& mesh);

} // namespace corral

#endif
