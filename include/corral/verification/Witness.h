// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_VERIFICATION_WITNESS_H
#define CORRAL_VERIFICATION_WITNESS_H

#include <corral/polynomial/Box.h>
#include <corral/polynomial/Polynomial.h>

#include <array>
#include <cstddef>
#include <variant>
#include <vector>

/// \file
/// The data that proves the verdict of a closed cell, checkable with exact arithmetic alone.
namespace corral {

/// A point with rational coordinates.
template <std::size_t D>
using Rational_point = std::array<Rational, D>;

/// \brief `hit`: two points of the closed cell where g has opposite signs, or one where it vanishes.
///
/// The cell is connected, so g has a zero between the two. An exact zero is given twice.
/// To check: both points lie in the closed cell and g(first) * g(second) <= 0.
template <std::size_t D>
struct Sign_change
{
  Rational_point<D> first{};
  Rational_point<D> second{};
};

/// \brief `hit`: one exact algebraic point of the closed cell where g vanishes.
///
/// With o = `order`, `chain[k]` has variables o[0] to o[k] only and is monic in o[k]. To check:
///  1. `box` lies in the closed cell;
///  2. for each k, either side o[k] of `box` is a point q and chain[k] is exactly x_{o[k]} - q, or the signs of
///     chain[k] at the lower and the upper end of that side are opposite and not zero, whatever values the
///     variables o[0] to o[k-1] take in their sides of `box` (evaluate over intervals);
///  3. g reduces to zero: divided with remainder by chain[D-1] with respect to variable o[D-1], then by chain[D-2]
///     with respect to o[D-2], down to chain[0], nothing remains.
/// By 2 and the intermediate value theorem, used once for each variable, the chain has a common zero in `box`; by 3 g
/// vanishes there, because it is a combination of the chain. Nothing is assumed of the chain: it need not be
/// irreducible, nor the zero unique.
template <std::size_t D>
struct Triangular_zero
{
  std::array<std::size_t, D> order{};
  std::array<Polynomial<Rational, D>, D> chain{};
  Rational_box<D> box{};
};

/// \brief `empty`: g has no zero on the boundary of the cell, and no point of the closed cell can be the end of a
/// piece of the zero set in direction `axis`.
///
/// To check: the facets have no zero (by subdivision and bounds, or recursively by a witness of this kind), and no
/// point of the cell has both g = 0 and dg/dx_axis = 0: the cell is covered by `boxes`, on each of which a bound keeps
/// g or dg/dx_axis away from zero. A piece of the zero set inside the cell would be compact, so it would reach a
/// largest value of every other coordinate, and there dg/dx_axis = 0.
template <std::size_t D>
struct No_piece_inside
{
  std::size_t axis = 0;
  std::vector<Rational_box<D>> boxes;
};

/// \brief `empty`: an exact bound of g over the cell, cut into halves as often as needed, keeps away from zero.
/// To check: subdivide and bound, with any inclusion method.
struct Bounded_away
{
};

/// \brief What proves a verdict on g, the square-free part of the polynomial that was asked for. `std::monostate`: no
/// simple witness (the verdict rests on an elimination that the decision has made itself).
template <std::size_t D>
using Witness = std::variant<std::monostate, Sign_change<D>, Triangular_zero<D>, Bounded_away, No_piece_inside<D>>;

} // namespace corral

#endif
