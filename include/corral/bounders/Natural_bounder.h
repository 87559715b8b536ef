// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_BOUNDERS_NATURAL_BOUNDER_H
#define CORRAL_BOUNDERS_NATURAL_BOUNDER_H

#include <corral/bounders/Range_bounder.h>
#include <corral/polynomial/Box.h>
#include <corral/polynomial/Polynomial.h>

#include <array>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

namespace corral {

/// \brief Model of `RangeBounder`: the natural interval extension of the power form.
///
/// Every term is bounded by its own powers, each of them exactly (an odd power is monotone), and
/// the terms are added up. Tight only where the terms grow and shrink together.
///
/// \tparam I  model of `IntervalNumber`. It does all the rounding; this class does none.
/// \par Complexity  2 log2(n) multiplications for each power that occurs, one for each factor of
///      each term.
/// \par Reference  Moore, Interval Analysis, 1966.
template <IntervalNumber I, std::size_t D>
class Natural_bounder
{
public:
  using Interval = I;
  using Polynomial = corral::Polynomial<I, D>;
  using Box = corral::Box<I, D>;
  static constexpr std::size_t dimension = D;
  static constexpr std::string_view name = "natural";

  explicit Natural_bounder(Polynomial f) : f_(std::move(f))
  {
    for (std::size_t axis = 0; axis < D; ++axis) {
      is_used_[axis].resize(f_.degree(axis) + 1);
      for (const auto& term : f_.terms()) is_used_[axis][term.exponents[axis]] = true;
    }
  }

  /// \pre The sides of `box` are finite.
  [[nodiscard]] I bound(const Box& box) const
  {
    std::array<std::vector<I>, D> powers;
    for (std::size_t axis = 0; axis < D; ++axis) {
      powers[axis].resize(is_used_[axis].size());
      for (unsigned n = 1; n < powers[axis].size(); ++n)
        if (is_used_[axis][n]) powers[axis][n] = range_of_power(box[axis], n);
    }
    I sum(0);
    bool is_first = true;
    for (const auto& term : f_.terms()) {
      I product = term.coefficient;
      for (std::size_t axis = 0; axis < D; ++axis)
        if (const auto n = term.exponents[axis]; n > 0) product *= powers[axis][n];
      if (std::exchange(is_first, false))
        sum = std::move(product);
      else
        sum += product;
    }
    return sum;
  }

private:
  static I range_of_power(const I& x, unsigned n)
  {
    if (n == 1) return x;
    CORRAL_PRECONDITION(exact_lower(x) && exact_upper(x),
                        "natural: given a box with an infinite side; expected finite ones");
    return n % 2 == 0 ? power(x, n) : hull(power(lower(x), n), power(upper(x), n));
  }

  Polynomial f_;
  std::array<std::vector<bool>, D> is_used_;
};

} // namespace corral

#endif
