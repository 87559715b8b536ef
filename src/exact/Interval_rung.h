// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_EXACT_INTERVAL_RUNG_H
#define CORRAL_EXACT_INTERVAL_RUNG_H

#include "Bernstein_form.h"

#include <corral/localization/Grid.h>
#include <corral/number/Interval_number.h>
#include <corral/verification/Cell_decision.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace corral::exact {

/// \brief The first two steps of the exact decision, signs of corners and of coefficients, over an interval number.
///
/// It decides a cell if rounding leaves the signs clear. \tparam I  a guaranteed model of `IntervalNumber`.
template <IntervalNumber I, std::size_t D>
class Interval_rung
{
  static_assert(is_guaranteed<I>, "a verdict needs guaranteed intervals");

public:
  /// \param power  power coefficients in grid coordinates.
  explicit Interval_rung(const Bernstein_form<D>& power) : size_(power.size)
  {
    const Arithmetic_scope<I> scope;
    for (const Integer& c : power.values) coefficients_.push_back(enclose<I>(Rational(c)));
    for (std::size_t k = D; k-- > 0;) stride_[k] = k + 1 == D ? 1 : stride_[k + 1] * size_[k + 1];
  }

  /// The verdict on one cell with a witness, or nothing.
  [[nodiscard]] std::optional<Cell_decision<D>> decide(const Grid<D>& grid, const Cell<D>& cell, Rung rung) const
  {
    const Arithmetic_scope<I> scope;
    auto c = coefficients_;
    for (std::size_t axis = 0; axis < D; ++axis) to_cell(c, axis, cell[axis]);
    int seen = strict_sign(corner(c, 0));
    if (seen == 0) return std::nullopt;
    for (unsigned other = 1; other < 1U << D; ++other)
      if (strict_sign(corner(c, other)) == -seen)
        return Cell_decision<D>{Verdict::hit, rung, Sign_change<D>{point(grid, cell, 0), point(grid, cell, other)}, {}};
    if (std::any_of(c.begin(), c.end(), [&](const I& value) { return strict_sign(value) != seen; }))
      return std::nullopt;
    return Cell_decision<D>{Verdict::empty, rung, Bounded_away{}, {}};
  }

private:
  /// Power coefficients become Bernstein coefficients on the cell along one axis, times binomials.
  void to_cell(std::vector<I>& values, std::size_t axis, std::uint32_t index) const
  {
    const std::size_t stride = stride_[axis];
    const std::size_t n = size_[axis] - 1;
    const I offset = enclose<I>(Rational(index));
    for (std::size_t outer = 0; outer < values.size(); outer += stride * size_[axis])
      for (std::size_t first = outer; first < outer + stride; ++first) {
        I* c = &values[first];
        if (index != 0)
          for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = n; j-- > i;) c[j * stride] += c[(j + 1) * stride] * offset;
        for (std::size_t i = 0; i < n; ++i)
          for (std::size_t j = 1; j + i <= n; ++j) c[j * stride] += c[(j - 1) * stride];
      }
  }

  [[nodiscard]] const I& corner(const std::vector<I>& values, unsigned corner) const
  {
    std::size_t index = 0;
    for (std::size_t k = 0; k < D; ++k) index += (corner >> k & 1) != 0 ? stride_[k] * (size_[k] - 1) : 0;
    return values[index];
  }

  [[nodiscard]] static Rational_point<D> point(const Grid<D>& grid, const Cell<D>& cell, unsigned corner)
  {
    Rational_point<D> result;
    for (std::size_t k = 0; k < D; ++k) result[k] = grid.line(k, cell[k] + (corner >> k & 1));
    return result;
  }

  std::array<std::size_t, D> size_;
  std::array<std::size_t, D> stride_{};
  std::vector<I> coefficients_;
};

} // namespace corral::exact

#endif
