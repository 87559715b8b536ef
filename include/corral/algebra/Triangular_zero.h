// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_ALGEBRA_TRIANGULAR_ZERO_H
#define CORRAL_ALGEBRA_TRIANGULAR_ZERO_H

#include <corral/polynomial/Box.h>
#include <corral/polynomial/Polynomial.h>

#include <array>
#include <cstddef>

namespace corral {

/// \brief One exact algebraic point of a closed cell where g vanishes: the witness of a `hit`.
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

} // namespace corral

#endif
