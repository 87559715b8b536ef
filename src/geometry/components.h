// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_GEOMETRY_COMPONENTS_H
#define CORRAL_SRC_GEOMETRY_COMPONENTS_H

#include <corral/geometry/Curve_mesh.h>

namespace corral::geometry {

/// Fills in the components of a mesh and what its vertices say of edges and components.
void find_components(Curve_mesh& mesh);

} // namespace corral::geometry

#endif
