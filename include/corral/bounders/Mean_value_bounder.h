// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_BOUNDERS_MEAN_VALUE_BOUNDER_H
#define CORRAL_BOUNDERS_MEAN_VALUE_BOUNDER_H

#include <corral/bounders/Range_bounder.h>
#include <corral/polynomial/Box.h>
#include <corral/polynomial/evaluate.h>

#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

namespace corral {

/// \brief Model of `RangeBounder`: the mean-value form f(c) + sum_i F_i(X) (X_i - c_i), where c is
/// the centre of X and F_i(X) the Horner form of the i-th derivative.
///
/// \tparam I  model of `IntervalNumber`. It does all the rounding; this class does none.
/// \par Complexity  D + 1 evaluations.
/// \par Reference  Moore, Methods and Applications of Interval Analysis, 1979. It converges
///      quadratically with the width of the box.
template <IntervalNumber I, std::size_t D>
class Mean_value_bounder
{
public:
  using Interval = I;
  using Polynomial = corral::Polynomial<I, D>;
  using Box = corral::Box<I, D>;
  static constexpr std::size_t dimension = D;
  static constexpr std::string_view name = "mean_value";

  explicit Mean_value_bounder(Polynomial f) : f_(std::move(f))
  {
    for (std::size_t axis = 0; axis < D; ++axis) gradient_[axis] = derivative(f_, axis);
  }

  /// \pre The sides of `box` are finite.
  [[nodiscard]] I bound(const Box& box) const
  {
    std::array<I, D> centre;
    Box around; // with the centre, which rounding may have put outside the box
    for (std::size_t axis = 0; axis < D; ++axis) {
      centre[axis] = midpoint(box[axis]);
      around[axis] = hull(box[axis], centre[axis]);
    }
    I sum = evaluate(f_, centre);
    for (std::size_t axis = 0; axis < D; ++axis)
      if (!gradient_[axis].is_zero()) sum += evaluate(gradient_[axis], around) * (box[axis] - centre[axis]);
    return sum;
  }

private:
  Polynomial f_;
  std::array<Polynomial, D> gradient_;
};

} // namespace corral

#endif
