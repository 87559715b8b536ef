// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_BOUNDERS_CENTRED_BOUNDER_H
#define CORRAL_BOUNDERS_CENTRED_BOUNDER_H

#include <corral/bounders/Range_bounder.h>
#include <corral/internal/bounders/Scaled_taylor.h>
#include <corral/internal/bounders/centred_range.h>
#include <corral/polynomial/Box.h>

#include <cstddef>
#include <string_view>

namespace corral {

/// \brief Model of `RangeBounder`: the centred form g_0 + sum_{k != 0} |g_k| [-1, 1], where
/// g_k u^k are the terms of f in the coordinates u in [-1, 1]^D of the box.
///
/// The modified affine form is this with [0, 1] for the terms that are never negative.
///
/// \tparam I  model of `IntervalNumber`. It does all the rounding; this class does none.
/// \par Complexity  That of `Scaled_taylor::expand`, and one multiplication and addition a term.
/// \par Reference  Taubin, "Rasterizing algebraic curves and surfaces", IEEE Computer Graphics and
///      Applications 14 (1994).
template <IntervalNumber I, std::size_t D>
class Centred_bounder
{
public:
  using Interval = I;
  using Polynomial = corral::Polynomial<I, D>;
  using Box = corral::Box<I, D>;
  static constexpr std::size_t dimension = D;
  static constexpr std::string_view name = "centred";

  explicit Centred_bounder(const Polynomial& f) : taylor_(f) {}

  /// \pre The sides of `box` are finite.
  [[nodiscard]] I bound(const Box& box) const
  {
    return centred_range(taylor_.expand(box), [](const Exponents<D>&, const I& c) { return symmetric_hull(c); });
  }

private:
  Scaled_taylor<I, D> taylor_;
};

} // namespace corral

#endif
