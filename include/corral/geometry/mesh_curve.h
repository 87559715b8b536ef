// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_GEOMETRY_MESH_CURVE_H
#define CORRAL_GEOMETRY_MESH_CURVE_H

#include <corral/Run_options.h>
#include <corral/geometry/Curve_mesh.h>
#include <corral/polynomial/Polynomial.h>

namespace corral {

/// \brief The real zero set of f in a closed box as a straight-line graph: isotopic to it within the box, and within
/// the tolerance of it.
///
/// Any curve is ordinary input: multiple components, singular and isolated points, lines along an axis, curves that
/// touch the box or pass through its corners. Cells are cut by doubles with proved bounds; singular points are found
/// exactly. Proof: doc/geometry.md. What is not certain when it is stopped, or when `run.cell_budget` cells (2^21 by
/// default) were looked at, stays uncertified. It works in one thread.
/// \param tolerance  the Hausdorff distance between the curve and the mesh, both ways, in the units of the box.
/// Positive.
/// \throw Invalid_input if f is zero, a side of the box is a point or the tolerance is not positive; Budget_exceeded if
///      factors do not fit in memory.
/// \par Complexity  A few bounds of n^2 coefficients for each cell, in degree n; cells as many as the tolerance wants,
///      and some dozens around each singular point. The resultant of f and a derivative if a singular point is not
///      a simple rational one.
/// \par Reference  Plantinga and Vegter 2004; Burr, Choi, Galehouse and Yap 2008, "Complete subdivision algorithms II";
///      Teissier 1973 (multiplicities of discriminants).
[[nodiscard]] Curve_mesh mesh_curve(const Polynomial<Rational, 2>& f, const Rational_box<2>& box,
                                    const Rational& tolerance = Rational(1, 1000), const Run_options& run = {});

} // namespace corral

#endif
