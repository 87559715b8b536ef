# SPDX-License-Identifier: LGPL-3.0-or-later
target_sources(corral PRIVATE
  geometry/Algebraic_point.cpp
  geometry/Cell_form.cpp
  geometry/Curve_cells.cpp
  geometry/Curve_slant.cpp
  geometry/Curve_star.cpp
  geometry/Plane_graph.cpp
  geometry/Side_zeros.cpp
  geometry/Singular_points.cpp
  geometry/components.cpp
  geometry/isolated_points.cpp
  geometry/mesh_curve.cpp
  geometry/nesting.cpp
  geometry/polylines.cpp
  geometry/solve.cpp)
