// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_DECISION_WITNESS_H
#define CORRAL_DECISION_WITNESS_H

#include <corral/algebra/Triangular_zero.h>
#include <corral/polynomial/Box.h>

#include <cstddef>
#include <variant>
#include <vector>

/// \file
/// The data that proves the verdict of a closed cell, checkable with exact arithmetic alone.
namespace corral {

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
