// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_GEOMETRY_MESH_CURVE_H
#define CORRAL_GEOMETRY_MESH_CURVE_H

#include <corral/algebra/Checkpoint.h>
#include <corral/geometry/Curve_mesh.h>
#include <corral/polynomial/Polynomial.h>

#include <cstddef>

namespace corral {

/// How finely to mesh a curve, and how long to try.
struct Mesh_options
{
  /// The Hausdorff distance between the curve and the mesh, both ways, in the units of the box. Positive.
  Rational tolerance{1, 1000};
  /// What is not certain when so many cells were looked at stays uncertified.
  std::size_t max_cells = std::size_t{1} << 21;
  Checkpoint checkpoint{};
};

/// \brief The real zero set of f in a closed box as a straight-line graph: isotopic to it within the box, and within
/// the tolerance of it.
///
/// Any curve is ordinary input: multiple components, singular and isolated points, lines along an axis, curves that
/// touch the box or pass through its corners. Cells are cut by doubles with proved bounds; singular points are found
/// exactly. Proof: doc/geometry.md.
/// \throw Invalid_input if f is zero, a side of the box is a point or the tolerance is not positive; Budget_exceeded if
///      factors do not fit in memory; whatever `options.checkpoint` throws.
/// \par Complexity  A few bounds of n^2 coefficients for each cell, in degree n; cells as many as the tolerance wants,
///      and some dozens around each singular point. The resultant of f and a derivative if a singular point is not
///      a simple rational one.
/// \par Reference  Plantinga and Vegter 2004; Burr, Choi, Galehouse and Yap 2008, "Complete subdivision algorithms II";
///      Teissier 1973 (multiplicities of discriminants).
[[nodiscard]] Curve_mesh mesh_curve(const Polynomial<Rational, 2>& f, const Rational_box<2>& box,
                                    const Mesh_options& options = {});

} // namespace corral

#endif
