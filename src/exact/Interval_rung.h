// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_EXACT_INTERVAL_RUNG_H
#define CORRAL_EXACT_INTERVAL_RUNG_H

#include "Bernstein_form.h"

#include <corral/localization/Grid.h>
#include <corral/number/Interval_number.h>
#include <corral/verification/Cell_decision.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace corral::exact {

/// \brief The first steps of the exact decision, signs of corners and of Bernstein coefficients, over an interval
/// number.
///
/// A cell is cut a few times if need be. It is decided if rounding leaves the signs clear.
/// \tparam I  a guaranteed model of `IntervalNumber`.
template <IntervalNumber I, std::size_t D>
class Interval_rung
{
  static_assert(is_guaranteed<I>, "a verdict needs guaranteed intervals");

public:
  /// \param power  power coefficients in coordinates where each cell is a unit cube with integer corners.
  explicit Interval_rung(const Bernstein_form<D>& power) : size_(power.size)
  {
    const Arithmetic_scope<I> scope;
    for (const Integer& c : power.values) coefficients_.push_back(enclose<I>(Rational(c)));
    for (std::size_t k = D; k-- > 0;) {
      stride_[k] = k + 1 == D ? 1 : stride_[k + 1] * size_[k + 1];
      Integer binomial = 1;
      for (std::size_t i = 0; i < size_[k]; binomial = binomial * (size_[k] - 1 - i) / (i + 1), ++i)
        weights_[k].push_back(enclose<I>(Rational(1, binomial)));
    }
  }

  /// The verdict on one cell with a witness, or nothing. \param origin  the cell in the coordinates of the polynomial.
  [[nodiscard]] std::optional<Cell_decision<D>> decide(const Grid<D>& grid, const Cell<D>& cell, const Cell<D>& origin,
                                                       Rung rung) const
  {
    constexpr unsigned most_depth = 3;
    const Arithmetic_scope<I> scope;
    std::vector<Part> parts(1);
    parts[0].values = coefficients_;
    for (std::size_t axis = 0; axis < D; ++axis) to_cell(parts[0].values, axis, origin[axis]);
    std::optional<Rational_point<D>> seen[2]; // a point where the polynomial is negative, one where it is positive
    while (!parts.empty()) {
      Part part = std::move(parts.back());
      parts.pop_back();
      for (unsigned corner = 0; corner < 1U << D; ++corner)
        if (const int sign = strict_sign(value_at(part, corner)); sign != 0 && !seen[sign > 0])
          seen[sign > 0] = point(grid, cell, part, corner);
      if (seen[0] && seen[1]) return Cell_decision<D>{Verdict::hit, rung, Sign_change<D>{*seen[0], *seen[1]}, {}};
      const int sign = strict_sign(part.values.front());
      if (sign != 0 && std::all_of(part.values.begin(), part.values.end(), [&](const I& value) {
            return strict_sign(value) == sign;
          }))
        continue;
      if (part.depth[D - 1] == most_depth) return std::nullopt; // the last axis is cut last: a zero is near, or nearly
      parts.push_back(halve(part));
      parts.push_back(std::move(part));
    }
    return Cell_decision<D>{Verdict::empty, rung, Bounded_away{}, {}};
  }

private:
  /// The Bernstein coefficients on a box of 2^-depth[k] of the cell along each axis, the index[k]-th.
  struct Part
  {
    std::vector<I> values;
    std::array<unsigned, D> depth{};
    std::array<unsigned, D> index{};
  };

  /// Power coefficients become Bernstein coefficients on the cell along one axis.
  void to_cell(std::vector<I>& values, std::size_t axis, std::uint32_t index) const
  {
    const std::size_t stride = stride_[axis];
    const std::size_t n = size_[axis] - 1;
    const I offset = enclose<I>(Rational(index));
    using Traits = Interval_traits<I>;
    const auto is_zero = [](const I& value) {
      return Traits::lower_sign(value) == 0 && Traits::upper_sign(value) == 0;
    };
    for_each_line(axis, [&](std::size_t first) {
      I* c = &values[first];
      std::size_t top = n; // degree of the line
      while (top > 0 && is_zero(c[top * stride])) --top;
      if (index != 0)
        for (std::size_t i = 0; i < top; ++i)
          for (std::size_t j = top; j-- > i;) c[j * stride] += c[(j + 1) * stride] * offset;
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 1; j + i <= n; ++j) c[j * stride] += c[(j - 1) * stride];
      for (std::size_t j = 1; j < n; ++j) c[j * stride] *= weights_[axis][j];
    });
  }

  /// de Casteljau at 1/2 along the axis cut least often: `part` becomes the upper half, the lower one is returned.
  [[nodiscard]] Part halve(Part& part) const
  {
    const auto axis =
        static_cast<std::size_t>(std::min_element(part.depth.begin(), part.depth.end()) - part.depth.begin());
    const std::size_t stride = stride_[axis];
    const std::size_t n = size_[axis] - 1;
    const I half = enclose<I>(Rational(1, 2));
    ++part.depth[axis];
    part.index[axis] *= 2;
    Part lower = part;
    ++part.index[axis];
    for_each_line(axis, [&](std::size_t first) {
      I* c = &part.values[first];
      for (std::size_t k = 1; k <= n; ++k) {
        for (std::size_t i = 0; i + k <= n; ++i) c[i * stride] = (c[i * stride] + c[(i + 1) * stride]) * half;
        lower.values[first + k * stride] = c[0];
      }
    });
    return lower;
  }

  template <class Function>
  void for_each_line(std::size_t axis, const Function& function) const
  {
    const std::size_t length = stride_[axis] * size_[axis];
    for (std::size_t outer = 0; outer < coefficients_.size(); outer += length)
      for (std::size_t first = outer; first < outer + stride_[axis]; ++first) function(first);
  }

  [[nodiscard]] const I& value_at(const Part& part, unsigned corner) const
  {
    std::size_t index = 0;
    for (std::size_t k = 0; k < D; ++k) index += (corner >> k & 1) != 0 ? stride_[k] * (size_[k] - 1) : 0;
    return part.values[index];
  }

  [[nodiscard]] static Rational_point<D> point(const Grid<D>& grid, const Cell<D>& cell, const Part& part,
                                               unsigned corner)
  {
    Rational_point<D> result;
    for (std::size_t k = 0; k < D; ++k) {
      Rational offset = part.index[k] + (corner >> k & 1);
      mpq_div_2exp(offset.get_mpq_t(), offset.get_mpq_t(), part.depth[k]);
      result[k] = grid.line(k, cell[k]) + grid.step(k) * offset;
    }
    return result;
  }

  std::array<std::size_t, D> size_;
  std::array<std::size_t, D> stride_{};
  std::vector<I> coefficients_;
  std::array<std::vector<I>, D> weights_; ///< 1 / C(n, k)
};

} // namespace corral::exact

#endif
