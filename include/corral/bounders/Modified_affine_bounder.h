// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_BOUNDERS_MODIFIED_AFFINE_BOUNDER_H
#define CORRAL_BOUNDERS_MODIFIED_AFFINE_BOUNDER_H

#include <corral/bounders/Range_bounder.h>
#include <corral/internal/bounders/Scaled_taylor.h>
#include <corral/internal/bounders/centred_range.h>
#include <corral/polynomial/Box.h>

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace corral {

/// \brief Model of `RangeBounder`: modified affine arithmetic (MAA), the centred form with the even/odd rule.
///
/// With g_k u^k the terms of f in the coordinates u in [-1, 1]^D of the box, every value of f lies in
///     g_0 + sum_{k != 0} g_k e_k,   e_k = [0, 1] where every exponent is even, else [-1, 1].
///
/// \tparam I  model of `IntervalNumber`. It does all the rounding; this class does none.
/// \par Complexity  That of `Scaled_taylor::expand`, and one multiplication and addition a term.
/// \par Reference  Shou, Martin, Voiculescu, Bowyer, Wang, "Affine arithmetic in matrix form for polynomial
///      evaluation and algebraic curve drawing", Progress in Natural Science 12 (2002).
template <IntervalNumber I, std::size_t D>
class Modified_affine_bounder
{
public:
  using Interval = I;
  using Polynomial = corral::Polynomial<I, D>;
  using Box = corral::Box<I, D>;
  static constexpr std::size_t dimension = D;
  static constexpr std::string_view name = "maa";

  explicit Modified_affine_bounder(const Polynomial& f) : taylor_(f) {}

  /// \pre The sides of `box` are finite.
  [[nodiscard]] I bound(const Box& box) const
  {
    return centred_range(taylor_.expand(box), [](const Exponents<D>& exponents, const I& c) {
      const bool is_even = std::none_of(exponents.begin(), exponents.end(), [](auto e) { return e % 2 != 0; });
      return is_even ? hull_with_zero(c) : symmetric_hull(c);
    });
  }

private:
  Scaled_taylor<I, D> taylor_;
};

} // namespace corral

#endif
