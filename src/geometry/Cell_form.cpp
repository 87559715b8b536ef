// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Cell_form.h"

#include "../algebra/on_box.h"

#include <algorithm>
#include <cmath>

namespace corral::geometry {

namespace {

constexpr double unit = 0x1p-53;
constexpr double slack = 1 + 0x1p-40; // more than the rounding errors of a dozen operations

/// The range of doubles close to true values, each no further than `error`, times a positive number.
Range widened(double low, double high, double error, double factor)
{
  low = (low - error) * factor;
  high = (high + error) * factor;
  return {low > 0 ? low / slack : low * slack - 0x1p-1000, high > 0 ? high * slack + 0x1p-1000 : high / slack};
}

} // namespace

void cut_line(double* upper, double* lower, std::size_t degree, std::size_t stride, double where)
{
  for (std::size_t k = 0; k <= degree; ++k) {
    lower[k * stride] = upper[0];
    for (std::size_t i = 0; i + k < degree; ++i)
      upper[i * stride] = (1 - where) * upper[i * stride] + where * upper[(i + 1) * stride];
  }
}

Cell_form::Cell_form(const Polynomial<Integer, 2>& f, const Rational_box<2>& cell)
{
  const auto exact = exact::bernstein_form(f, cell);
  degree_ = {exact.size[0] - 1, exact.size[1] - 1};
  values_.reserve(exact.values.size());
  std::vector<long> exponents;
  exponents.reserve(exact.values.size());
  for (const Integer& value : exact.values) {
    long exponent = 0;
    values_.push_back(mpz_get_d_2exp(&exponent, value.get_mpz_t())); // cut towards zero: off by less than 2^-52
    exponents.push_back(exponent);
  }
  const long top = *std::max_element(exponents.begin(), exponents.end());
  for (std::size_t i = 0; i < values_.size(); ++i)
    values_[i] = std::ldexp(values_[i], static_cast<int>(std::max(exponents[i] - top, -2000L)));
  error_ = 0x1p-52 + 0x1p-1000;
  measure();
}

void Cell_form::measure()
{
  const auto [least, greatest] = std::minmax_element(values_.begin(), values_.end());
  least_ = *least;
  greatest_ = *greatest;
  largest_ = std::max(-least_, greatest_);
}

Cell_form Cell_form::cut(std::size_t axis, double where)
{
  Cell_form lower;
  lower.degree_ = degree_;
  lower.values_.resize(values_.size());
  const std::size_t n = degree_[axis];
  const std::size_t row = degree_[1] + 1;
  if (axis == 1) {
    for (std::size_t first = 0; first < values_.size(); first += row)
      cut_line(&values_[first], &lower.values_[first], n, 1, where);
  } else {
    for (std::size_t k = 0; k <= n; ++k) {
      std::copy_n(values_.begin(), row, lower.values_.begin() + static_cast<std::ptrdiff_t>(k * row));
      double* const v = values_.data();
      for (std::size_t i = 0; i < (n - k) * row; ++i) v[i] = (1 - where) * v[i] + where * v[i + row];
    }
  }
  error_ += cut_error(n, largest_);
  lower.error_ = error_;
  measure();
  lower.measure();
  return lower;
}

Range Cell_form::derivative(std::array<std::size_t, 2> order) const
{
  if (order[0] > degree_[0] || order[1] > degree_[1]) return {0, 0};
  const std::size_t total = order[0] + order[1];
  double factor = 1;
  for (std::size_t axis = 0; axis < 2; ++axis)
    for (std::size_t k = 0; k < order[axis]; ++k) factor *= static_cast<double>(degree_[axis] - k);
  const double power = std::ldexp(1.0, static_cast<int>(total));
  const double error = power * (error_ + 2 * static_cast<double>(total) * unit * largest_) * slack;
  const std::size_t row = degree_[1] + 1;
  if (total == 1) {
    const std::size_t step = order[0] == 1 ? row : 1;
    double low = values_[step] - values_[0];
    double high = low;
    for (std::size_t i = 0; i + order[0] <= degree_[0]; ++i)
      for (std::size_t j = 0; j + order[1] <= degree_[1]; ++j) {
        const double difference = values_[i * row + j + step] - values_[i * row + j];
        low = std::min(low, difference);
        high = std::max(high, difference);
      }
    return widened(low, high, error, factor);
  }
  std::vector<double> v = values_;
  std::size_t rows = degree_[0] + 1;
  for (std::size_t k = 0; k < order[0]; ++k, --rows)
    for (std::size_t i = 0; i + row < rows * row; ++i) v[i] = v[i + row] - v[i];
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  for (std::size_t i = 0; i < rows; ++i) {
    double* const line = &v[i * row];
    for (std::size_t k = 0; k < order[1]; ++k)
      for (std::size_t j = 0; j + k + 1 < row; ++j) line[j] = line[j + 1] - line[j];
    for (std::size_t j = 0; j + order[1] < row; ++j) {
      low = std::min(low, line[j]);
      high = std::max(high, line[j]);
    }
  }
  return widened(low, high, error, factor);
}

std::vector<double> Cell_form::side(std::size_t normal, bool upper) const
{
  const std::size_t fixed = upper ? degree_[normal] : 0;
  std::vector<double> result;
  for (std::size_t k = 0; k <= degree_[1 - normal]; ++k)
    result.push_back(normal == 0 ? (*this)(fixed, k) : (*this)(k, fixed));
  return result;
}

std::vector<double> Cell_form::slope_on_side(std::size_t normal, bool upper) const
{
  if (degree_[normal] == 0) return {0};
  const std::size_t fixed = upper ? degree_[normal] - 1 : 0;
  std::vector<double> result;
  for (std::size_t k = 0; k <= degree_[1 - normal]; ++k)
    result.push_back(normal == 0 ? (*this)(fixed + 1, k) - (*this)(fixed, k)
                                 : (*this)(k, fixed + 1) - (*this)(k, fixed));
  return result;
}

} // namespace corral::geometry
