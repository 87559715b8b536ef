// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_GEOMETRY_SOLVE_H
#define CORRAL_GEOMETRY_SOLVE_H

#include <corral/Run_options.h>
#include <corral/geometry/Algebraic_point.h>

#include <optional>
#include <vector>

/// \file
/// Real zeros of polynomials as points, all of them and exactly.
namespace corral {

/// The common zeros of two polynomials in the plane.
struct Plane_zeros
{
  /// Those that do not lie on `common_curve`, by x and then by y.
  std::vector<Algebraic_point> points;
  /// The greatest common divisor of the polynomials; constant if there is no common curve.
  Polynomial<Integer, 2> common_curve;
};

/// \brief All common real zeros of f and g in a closed box, or in the whole plane.
///
/// The resultant along a direction that tells the zeros apart, its real roots, and the linear subresultant; a vanishing
/// one is replaced by a greatest common divisor over the root's field. Proof: doc/geometry.md.
/// \throw Invalid_input if one of the polynomials is zero; Budget_exceeded if a common divisor does not fit in memory;
///      Cancelled if it is stopped.
/// \par Complexity  For degrees n and m one resultant of degree n m modulo a few primes, and the isolation of its
/// roots. \par Reference  Collins 1971; Gonzalez-Vega and El Kahoui 1996 (curves in generic position).
[[nodiscard]] Plane_zeros solve(const Polynomial<Rational, 2>& f, const Polynomial<Rational, 2>& g,
                                const std::optional<Rational_box<2>>& box = std::nullopt, const Run_options& run = {});

/// \brief All real zeros of f in an interval, or on the whole line, with multiplicities, in increasing order.
/// \throw Invalid_input if f is zero; Cancelled if it is stopped.
[[nodiscard]] std::vector<Real_root> solve(const Polynomial<Rational, 1>& f,
                                           const std::optional<Rational_interval>& interval = std::nullopt,
                                           const Run_options& run = {});

/// A singular point of a curve f = 0.
struct Singular_point
{
  Algebraic_point point;
  unsigned order; ///< of f there: some partial derivative of this order does not vanish, and all of lower ones do
};

/// \brief The points where f and both its partial derivatives vanish, of the square-free part of f.
/// \throw as `solve`.
[[nodiscard]] std::vector<Singular_point> singular_points(const Polynomial<Rational, 2>& f,
                                                          const std::optional<Rational_box<2>>& box = std::nullopt,
                                                          const Run_options& run = {});

/// \brief The points of the curve f = 0 that are alone in a neighbourhood.
/// \throw as `solve`, and Budget_exceeded if a mesh of the curve leaves uncertain which they are.
/// \par Complexity  `singular_points`, and a coarse mesh of the curve around them.
[[nodiscard]] std::vector<Algebraic_point> isolated_points(const Polynomial<Rational, 2>& f,
                                                           const std::optional<Rational_box<2>>& box = std::nullopt,
                                                           const Run_options& run = {});

/// \brief The smooth points of the curve f = 0 whose tangent is parallel to an axis (0: horizontal, 1: vertical), of
/// the square-free part of f. Lines parallel to the axis are left out. \throw as `solve`.
[[nodiscard]] std::vector<Algebraic_point> tangent_points(const Polynomial<Rational, 2>& f, std::size_t axis,
                                                          const std::optional<Rational_box<2>>& box = std::nullopt,
                                                          const Run_options& run = {});

} // namespace corral

#endif
