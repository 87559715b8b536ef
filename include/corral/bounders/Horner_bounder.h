// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_BOUNDERS_HORNER_BOUNDER_H
#define CORRAL_BOUNDERS_HORNER_BOUNDER_H

#include <corral/bounders/Range_bounder.h>
#include <corral/polynomial/Box.h>
#include <corral/polynomial/evaluate.h>

#include <cstddef>
#include <string_view>
#include <utility>

namespace corral {

/// \brief Model of `RangeBounder`: the natural interval extension of the Horner form, variable by
/// variable from variable 0 outside to the last inside.
///
/// Fewer operations than the power form, and tighter as a rule; but x*(x + a) forgets that both
/// factors are the same x, where x^2 in the power form does not.
///
/// \tparam I  model of `IntervalNumber`. It does all the rounding; this class does none.
/// \par Complexity  That of `evaluate`.
/// \par Reference  Martin, Shou, Voiculescu, Bowyer, Wang, "Comparison of interval methods for
///      plotting algebraic curves", Computer Aided Geometric Design 19 (2002).
template <IntervalNumber I, std::size_t D>
class Horner_bounder
{
public:
  using Interval = I;
  using Polynomial = corral::Polynomial<I, D>;
  using Box = corral::Box<I, D>;
  static constexpr std::size_t dimension = D;
  static constexpr std::string_view name = "horner";

  explicit Horner_bounder(Polynomial f) : f_(std::move(f)) {}

  [[nodiscard]] I bound(const Box& box) const { return evaluate(f_, box); }

private:
  Polynomial f_;
};

} // namespace corral

#endif
