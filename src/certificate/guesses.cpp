// SPDX-License-Identifier: LGPL-3.0-or-later
#include "guesses.h"

#include "Float_form.h"

#include <corral/polynomial/evaluate.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace corral::certificate {
namespace {

template <std::size_t D>
using Point = std::array<double, D>;

/// The points of a regular grid in the unit box, with `count` of them along each axis.
template <std::size_t D>
std::vector<Point<D>> regular_points(std::size_t count)
{
  std::vector<Point<D>> result(1);
  for (std::size_t axis = 0; axis < D; ++axis) {
    std::vector<Point<D>> next;
    for (const auto& point : result)
      for (std::size_t i = 0; i < count; ++i) {
        next.push_back(point);
        next.back()[axis] = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
      }
    result = std::move(next);
  }
  return result;
}

/// The nearest number with so many bits.
Rational rounded(const Rational& value, long bit_count)
{
  if (value == 0) return value;
  const long size = static_cast<long>(bits(value.get_num())) - static_cast<long>(bits(value.get_den()));
  const long shift = bit_count - size;
  Rational scaled;
  if (shift >= 0)
    mpq_mul_2exp(scaled.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(shift));
  else
    mpq_div_2exp(scaled.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(-shift));
  Rational result = Integer(scaled.get_num() / scaled.get_den());
  if (shift >= 0)
    mpq_div_2exp(result.get_mpq_t(), result.get_mpq_t(), static_cast<mp_bitcnt_t>(shift));
  else
    mpq_mul_2exp(result.get_mpq_t(), result.get_mpq_t(), static_cast<mp_bitcnt_t>(-shift));
  return result;
}

/// The inverse of the Jacobian of two forms along two axes; empty if it looks singular.
template <std::size_t D>
std::vector<std::vector<double>> inverse_jacobian(const std::vector<Float_form<D>>& forms,
                                                  const std::array<std::size_t, 2>& axes, const Point<D>& u)
{
  std::vector<std::vector<double>> result(2, std::vector<double>(2));
  for (std::size_t column = 0; column < 2; ++column) {
    std::array<std::array<double, 3>, 2> rows{};
    for (std::size_t r = 0; r < 2; ++r)
      rows[r] = {forms[r].slope(u, axes[0]), forms[r].slope(u, axes[1]), r == column ? 1.0 : 0.0};
    if (!solve<2>(rows)) return {};
    for (std::size_t r = 0; r < 2; ++r) result[r][column] = rows[r][2];
  }
  const bool is_finite = std::all_of(result.begin(), result.end(),
                                     [](const auto& row) { return std::isfinite(row[0]) && std::isfinite(row[1]); });
  return is_finite ? result : std::vector<std::vector<double>>{};
}

/// The form in doubles over the polynomial, about.
template <std::size_t D>
Rational scale_of(const Float_form<D>& form, const Polynomial<Rational, D>& g, const Rational_box<D>& cell)
{
  for (unsigned corner = 0; corner < 1U << D; ++corner) {
    Point<D> u{};
    Rational_point<D> x;
    for (std::size_t axis = 0; axis < D; ++axis) {
      const bool is_upper = (corner >> axis & 1) != 0;
      u[axis] = is_upper ? 1 : 0;
      x[axis] = is_upper ? cell[axis].upper() : cell[axis].lower();
    }
    const double value = form.value(u);
    const Rational exact = evaluate(g, x);
    if (std::abs(value) > 1e-200 && exact != 0) return abs(Rational(value) / exact);
  }
  return 1;
}

/// Boxes of several sizes around a point, flat along the axes that are not given.
template <std::size_t D>
std::vector<Rational_box<D>> boxes_around(const Point<D>& u, const std::array<std::size_t, 2>& axes,
                                          const Rational_box<D>& cell)
{
  constexpr std::array<int, 5> exponents = {-6, -12, -18, -26, -34};
  constexpr double unit = 4398046511104.0; // 2^42
  std::vector<Rational_box<D>> result;
  for (const int exponent : exponents) {
    Rational_box<D> box;
    const Rational radius(std::ldexp(1.0, exponent));
    for (std::size_t axis = 0; axis < D; ++axis) {
      const Rational centre(std::round(u[axis] * unit) / unit);
      const bool is_flat = std::find(axes.begin(), axes.end(), axis) == axes.end();
      const Rational lower = is_flat ? centre : Rational(std::max(Rational(centre - radius), Rational(0)));
      const Rational upper = is_flat ? centre : Rational(std::min(Rational(centre + radius), Rational(1)));
      const Rational width = cell[axis].upper() - cell[axis].lower();
      box[axis] = Rational_interval(cell[axis].lower() + lower * width, cell[axis].lower() + upper * width);
    }
    result.push_back(std::move(box));
  }
  return result;
}

} // namespace

template <std::size_t D>
std::vector<Rational_point<D>> guess_other_sign(const Counted_form<D>& form)
{
  constexpr std::size_t max_starts = 4;
  const Float_form<D> g(form.form);
  const int sign = sgn(form.form.corner(0));
  std::vector<Float_form<D>> gradient;
  std::array<std::size_t, D> axes{};
  for (std::size_t axis = 0; axis < D; ++axis) {
    if (!form.is_free(axis)) return {};
    gradient.emplace_back(exact::derivative(form.form, axis));
    axes[axis] = axis;
  }
  std::vector<std::pair<double, Point<D>>> starts;
  for (const auto& u : regular_points<D>(5)) starts.emplace_back(sign * g.value(u), u);
  std::sort(starts.begin(), starts.end());
  starts.resize(std::min(starts.size(), max_starts));
  std::vector<Rational_point<D>> result;
  for (const auto& [value, start] : starts) {
    const auto found = newton<D, D>(gradient, axes, start);
    Rational_point<D> point;
    for (std::size_t axis = 0; axis < D; ++axis) point[axis] = Rational((found ? *found : start)[axis]);
    if (std::find(result.begin(), result.end(), point) == result.end()) result.push_back(point);
  }
  return result;
}

template <std::size_t D>
std::vector<Miranda_zero<D>> guess_common_zeros(const std::vector<Counted_form<D>>& forms,
                                                const std::vector<Polynomial<Rational, D>>& polynomials,
                                                const Rational_box<D>& cell)
{
  constexpr long matrix_bits = 20;
  std::vector<Float_form<D>> floats;
  for (const auto& form : forms) floats.emplace_back(form.form);
  std::vector<Miranda_zero<D>> result;
  for (std::size_t first = 0; first < D; ++first)
    for (std::size_t second = first + 1; second < D; ++second)
      for (const auto& start : regular_points<D>(D == 2 ? 3 : 1)) {
        const std::array<std::size_t, 2> axes = {first, second};
        const auto u = newton<2, D>(floats, axes, start);
        if (!u) continue;
        const auto inverse = inverse_jacobian(floats, axes, *u);
        if (inverse.empty()) continue;
        std::vector<std::vector<Rational>> matrix(2, std::vector<Rational>(2));
        for (std::size_t j = 0; j < 2; ++j) {
          const Rational scale = scale_of(floats[j], polynomials[j], cell);
          for (std::size_t r = 0; r < 2; ++r) matrix[r][j] = rounded(Rational(inverse[r][j]) * scale, matrix_bits);
        }
        if (matrix[0][0] * matrix[1][1] == matrix[0][1] * matrix[1][0]) continue;
        for (auto& box : boxes_around(*u, axes, cell)) result.push_back({std::move(box), matrix});
        if (D == 2) return result; // another start would find the same zero, as a rule
      }
  return result;
}

template std::vector<Rational_point<1>> guess_other_sign(const Counted_form<1>&);
template std::vector<Rational_point<2>> guess_other_sign(const Counted_form<2>&);
template std::vector<Rational_point<3>> guess_other_sign(const Counted_form<3>&);
template std::vector<Miranda_zero<2>> guess_common_zeros(const std::vector<Counted_form<2>>&,
                                                         const std::vector<Polynomial<Rational, 2>>&,
                                                         const Rational_box<2>&);
template std::vector<Miranda_zero<3>> guess_common_zeros(const std::vector<Counted_form<3>>&,
                                                         const std::vector<Polynomial<Rational, 3>>&,
                                                         const Rational_box<3>&);

} // namespace corral::certificate
