// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_BOUNDERS_STRANGER_BOUNDER_H
#define CORRAL_BOUNDERS_STRANGER_BOUNDER_H

#include <corral/bounders/Range_bounder.h>

#include <cstddef>
#include <string_view>
#include <utility>

namespace corral {

/// The crudest of all bounds: every variable is as large as it can be, of either sign.
template <IntervalNumber I, std::size_t D>
class Stranger_bounder
{
public:
  using Interval = I;
  using Polynomial = corral::Polynomial<I, D>;
  using Box = corral::Box<I, D>;
  static constexpr std::size_t dimension = D;
  static constexpr std::string_view name = "stranger";

  explicit Stranger_bounder(Polynomial f) : f_(std::move(f)) {}

  [[nodiscard]] I bound(const Box& box) const
  {
    I sum = 0;
    for (const auto& term : f_.terms()) {
      I product = term.coefficient;
      for (std::size_t axis = 0; axis < D; ++axis) product *= power(symmetric_hull(box[axis]), term.exponents[axis]);
      sum += product;
    }
    return sum;
  }

private:
  Polynomial f_;
};

} // namespace corral

#endif
