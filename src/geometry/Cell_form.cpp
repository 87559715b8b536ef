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

std::vector<double> rounded(const std::vector<Integer>& values)
{
  std::vector<double> result;
  std::vector<long> exponents;
  result.reserve(values.size());
  exponents.reserve(values.size());
  for (const Integer& value : values) {
    long exponent = 0;
    result.push_back(mpz_get_d_2exp(&exponent, value.get_mpz_t())); // cut towards zero: off by less than 2^-52
    exponents.push_back(exponent);
  }
  const long top = *std::max_element(exponents.begin(), exponents.end());
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = std::ldexp(result[i], static_cast<int>(std::max(exponents[i] - top, -2000L)));
  return result;
}

Cell_form::Cell_form(const Polynomial<Integer, 2>& f, const Rational_box<2>& cell)
{
  const auto exact = exact::bernstein_form(f, cell);
  degree_ = {exact.size[0] - 1, exact.size[1] - 1};
  values_ = rounded(exact.values);
  error_ = rounding;
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
  if (total == 1 || total == 2) {
    const std::size_t one = order[0] > 0 ? row : 1;
    const std::size_t other = order[1] > 0 ? 1 : row;
    double low = HUGE_VAL;
    double high = -HUGE_VAL;
    for (std::size_t i = 0; i + order[0] <= degree_[0]; ++i)
      for (std::size_t j = 0; j + order[1] <= degree_[1]; ++j) {
        const double* const c = &values_[i * row + j];
        double difference = c[one] - c[0];
        if (total == 2) difference = (c[one + other] - c[other]) - difference;
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

/// The bounds of sums a c + b0 [f_x] + b1 [f_y] of coefficients, where x f_x, (1 - x) f_x and so on have Bernstein
/// coefficients i (c_i - c_(i-1)) and (n - i) (c_(i+1) - c_i).
template <class Weights>
Range Cell_form::combined_range(double own, const Weights& weights) const
{
  const std::size_t row = degree_[1] + 1;
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  double heaviest = std::fabs(own);
  for (std::size_t axis = 0; axis < 2; ++axis)
    heaviest +=
        2 * static_cast<double>(degree_[axis]) * std::max(std::fabs(weights[axis][0]), std::fabs(weights[axis][1]));
  for (std::size_t i = 0; i <= degree_[0]; ++i)
    for (std::size_t j = 0; j <= degree_[1]; ++j) {
      const double* const c = &values_[i * row + j];
      double sum = own * *c;
      const auto add = [&](std::size_t k, std::size_t n, std::size_t stride, const std::array<double, 2>& w) {
        if (k > 0) sum += w[0] * (static_cast<double>(k) * (*c - *(c - stride)));
        if (k < n) sum += w[1] * (static_cast<double>(n - k) * (*(c + stride) - *c));
      };
      add(i, degree_[0], row, weights[0]);
      add(j, degree_[1], 1, weights[1]);
      low = std::min(low, sum);
      high = std::max(high, sum);
    }
  // Each product and sum rounds once; there are fewer than 16 on the way to a value.
  return widened(low, high, heaviest * (error_ + 16 * unit * largest_) * slack, 1);
}

Range Cell_form::derivative_along(const std::array<double, 2>& v) const
{
  return combined_range(0, std::array{std::array{v[0], v[0]}, std::array{v[1], v[1]}});
}

std::array<double, 2> Cell_form::mean_gradient() const
{
  std::array<double, 2> sum{};
  for (std::size_t j = 0; j <= degree_[1]; ++j) sum[0] += (*this)(degree_[0], j) - (*this)(0, j);
  for (std::size_t i = 0; i <= degree_[0]; ++i) sum[1] += (*this)(i, degree_[1]) - (*this)(i, 0);
  return {sum[0] / static_cast<double>(degree_[1] + 1), sum[1] / static_cast<double>(degree_[0] + 1)};
}

std::array<double, 3> Cell_form::mean_hessian() const
{
  const auto [n, m] = degree_;
  double xx = 0;
  double yy = 0;
  for (std::size_t j = 0; n > 0 && j <= m; ++j) xx += (*this)(n, j) - (*this)(n - 1, j) - (*this)(1, j) + (*this)(0, j);
  for (std::size_t i = 0; m > 0 && i <= n; ++i) yy += (*this)(i, m) - (*this)(i, m - 1) - (*this)(i, 1) + (*this)(i, 0);
  return {xx * static_cast<double>(n) / static_cast<double>(m + 1),
          (*this)(n, m) - (*this)(n, 0) - (*this)(0, m) + (*this)(0, 0),
          yy * static_cast<double>(m) / static_cast<double>(n + 1)};
}

std::array<double, 2> Cell_form::mean_flat_direction() const
{
  const auto [xx, xy, yy] = mean_hessian();
  const double half = (xx - yy) / 2;
  const double root = std::hypot(half, xy);
  // The eigenvector that belongs to the eigenvalue of smaller absolute value.
  const double sign = xx + yy > 0 ? 1 : -1;
  return half * sign > 0 ? std::array{-xy, half + sign * root} : std::array{sign * root - half, -xy};
}

bool Cell_form::is_surely_regular() const
{
  const auto [xx, xy, yy] = mean_hessian();
  const auto [x, y] = mean_gradient();
  const double determinant = xx * yy - xy * xy;
  const double p = 0.5 - (yy * x - xy * y) / determinant;
  const double q = 0.5 - (xx * y - xy * x) / determinant;
  if (!(std::fabs(p) < 4) || !(std::fabs(q) < 4)) return false; // any p and q would do; these are too far to help
  // (x - p) f_x = (1 - p) x f_x - p (1 - x) f_x
  return !combined_range(1, std::array{std::array{-(1 - p) / 2, p / 2}, std::array{-(1 - q) / 2, q / 2}}).has_zero();
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
