// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_GEOMETRY_CELL_FORM_H
#define CORRAL_SRC_GEOMETRY_CELL_FORM_H

#include <corral/polynomial/Box.h>
#include <corral/polynomial/Polynomial.h>

#include <array>
#include <cstddef>
#include <vector>

namespace corral::geometry {

/// Bounds of a real number or of a function.
struct Range
{
  double low;
  double high;

  [[nodiscard]] bool has_zero() const { return low <= 0 && high >= 0; }
  [[nodiscard]] double magnitude() const { return low < 0 && -low > high ? -low : high < 0 ? -low : high; }
};

/// \brief The halves of the Bernstein coefficients of a univariate polynomial on the two sides of a cut, by de
/// Casteljau's rule; `upper` is overwritten, `stride` apart.
void cut_line(double* upper, double* lower, std::size_t degree, std::size_t stride, double where);

/// What cutting adds to the error of coefficients no larger than `largest`. Proof: doc/geometry.md.
[[nodiscard]] constexpr double cut_error(std::size_t degree, double largest)
{
  return 4 * static_cast<double>(degree) * 0x1p-53 * largest + 0x1p-1000;
}

/// Integers in a common unit, so that the largest is near 1; each differs from the true one by less than `rounding`.
[[nodiscard]] std::vector<double> rounded(const std::vector<Integer>& values);
inline constexpr double rounding = 0x1p-52 + 0x1p-1000;

/// \brief A positive multiple of a polynomial on a cell, by its Bernstein coefficients in the cell's own coordinates,
/// [0,1]^2, rounded: each differs from the true one by at most `error()`.
class Cell_form
{
public:
  /// The polynomial on a cell, from its exact coefficients. \pre f is not zero; the cell is not flat.
  Cell_form(const Polynomial<Integer, 2>& f, const Rational_box<2>& cell);

  [[nodiscard]] std::size_t degree(std::size_t axis) const { return degree_[axis]; }
  [[nodiscard]] double error() const { return error_; }
  /// The largest absolute value of a coefficient.
  [[nodiscard]] double largest() const { return largest_; }
  /// Coefficient j of axis 1 in row i of axis 0.
  [[nodiscard]] double operator()(std::size_t i, std::size_t j) const { return values_[i * (degree_[1] + 1) + j]; }

  /// Keeps the part above `where` in (0, 1) along an axis and returns the part below.
  [[nodiscard]] Cell_form cut(std::size_t axis, double where);

  /// Bounds of the partial derivative of order `order[k]` along axis k on the cell, in its own coordinates.
  [[nodiscard]] Range derivative(std::array<std::size_t, 2> order) const;
  /// Bounds of the derivative along v, in the cell's own coordinates.
  [[nodiscard]] Range derivative_along(const std::array<double, 2>& v) const;
  /// About the mean of the gradient.
  [[nodiscard]] std::array<double, 2> mean_gradient() const;
  /// About the means of the second derivatives: xx, xy, yy.
  [[nodiscard]] std::array<double, 3> mean_hessian() const;
  /// About the direction in which the gradient changes least, on the mean.
  [[nodiscard]] std::array<double, 2> mean_flat_direction() const;
  /// \brief Whether it is certain that the polynomial and its gradient have no common zero on the cell.
  ///
  /// Looks at f - (x - p) f_x / 2 - (y - q) f_y / 2, which is a constant for a quadratic polynomial with centre (p, q).
  [[nodiscard]] bool is_surely_regular() const;
  [[nodiscard]] Range range() const { return {least_ - error_, greatest_ + error_}; }

  /// \brief The coefficients on the side where coordinate `normal` is 0 or 1 (`upper`), of the polynomial or of its
  /// derivative along `normal` over the degree, whose error is twice as large and a little more.
  [[nodiscard]] std::vector<double> side(std::size_t normal, bool upper) const;
  [[nodiscard]] std::vector<double> slope_on_side(std::size_t normal, bool upper) const;

private:
  Cell_form() = default;
  void measure();
  template <class Weights>
  [[nodiscard]] Range combined_range(double own, const Weights& weights) const;

  std::array<std::size_t, 2> degree_{};
  std::vector<double> values_;
  double error_ = 0;
  double largest_ = 0;
  double least_ = 0;
  double greatest_ = 0;
};

} // namespace corral::geometry

#endif
