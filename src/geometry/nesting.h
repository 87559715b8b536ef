// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_GEOMETRY_NESTING_H
#define CORRAL_SRC_GEOMETRY_NESTING_H

#include <corral/geometry/Curve_mesh.h>

namespace corral::geometry {

/// \brief Fills in the parents of the components of a mesh. \pre Its edges do not cross, and its components are known.
///
/// From the leftmost vertex of each component, the first edge to the left tells in which face of another one it lies.
/// Exact. \par Complexity  Components times edges comparisons of doubles.
void find_nesting(Curve_mesh& mesh);

} // namespace corral::geometry

#endif
