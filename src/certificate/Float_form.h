// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_CERTIFICATE_FLOAT_FORM_H
#define CORRAL_SRC_CERTIFICATE_FLOAT_FORM_H

#include "../algebra/Bernstein_form.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

/// \file
/// Guesses by doubles. Nothing is proved here: exact arithmetic decides what a guess is worth.
namespace corral::certificate {

/// A Bernstein form in doubles, times some power of two, with its derivatives.
template <std::size_t D>
class Float_form
{
public:
  using Point = std::array<double, D>;

  explicit Float_form(const exact::Bernstein_form<D>& form) : value_(rounded(form, exponent_of(form)))
  {
    const long exponent = exponent_of(form);
    for (std::size_t axis = 0; axis < D; ++axis)
      if (form.size[axis] > 1) {
        slopes_[axis] = rounded(exact::derivative(form, axis), exponent);
        for (double& c : slopes_[axis].values) c *= static_cast<double>(form.size[axis] - 1);
      }
  }

  /// Near to g(u) times a positive number, which is the same for the derivatives.
  [[nodiscard]] double value(const Point& u) const { return evaluate(value_, u); }
  [[nodiscard]] double slope(const Point& u, std::size_t axis) const { return evaluate(slopes_[axis], u); }

private:
  struct Array
  {
    std::array<std::size_t, D> size{};
    std::vector<double> values;
  };

  static long exponent_of(const exact::Bernstein_form<D>& form)
  {
    std::size_t bits = 1;
    for (const Integer& c : form.values) bits = std::max(bits, mpz_sizeinbase(c.get_mpz_t(), 2));
    return static_cast<long>(bits);
  }

  static Array rounded(const exact::Bernstein_form<D>& form, long exponent)
  {
    Array result{form.size, {}};
    for (const Integer& c : form.values) {
      long shift = 0;
      const double mantissa = mpz_get_d_2exp(&shift, c.get_mpz_t());
      result.values.push_back(std::ldexp(mantissa, static_cast<int>(std::max(shift - exponent, -2000L))));
    }
    return result;
  }

  /// Sums the basis functions axis by axis, the last one first.
  static double evaluate(const Array& array, const Point& u)
  {
    if (array.values.empty()) return 0;
    std::vector<double> values = array.values;
    for (std::size_t axis = D; axis-- > 0;) {
      const std::size_t n = array.size[axis];
      for (std::size_t line = 0; line * n < values.size(); ++line) {
        double* c = &values[line * n];
        for (std::size_t step = n; step-- > 1;)
          for (std::size_t i = 0; i < step; ++i) c[i] += u[axis] * (c[i + 1] - c[i]);
        values[line] = c[0];
      }
      values.resize(values.size() / n);
    }
    return values[0];
  }

  Array value_;
  std::array<Array, D> slopes_{};
};

/// Solves the linear system with the augmented rows; false if it looks singular. The solution is the last column.
template <std::size_t M>
bool solve(std::array<std::array<double, M + 1>, M>& rows)
{
  for (std::size_t column = 0; column < M; ++column) {
    std::size_t pivot = column;
    for (std::size_t row = column; row < M; ++row)
      if (std::abs(rows[row][column]) > std::abs(rows[pivot][column])) pivot = row;
    if (!(std::abs(rows[pivot][column]) > 1e-300)) return false;
    std::swap(rows[pivot], rows[column]);
    for (std::size_t row = 0; row < M; ++row) {
      if (row == column) continue;
      const double factor = rows[row][column] / rows[column][column];
      for (std::size_t k = column; k <= M; ++k) rows[row][k] -= factor * rows[column][k];
    }
  }
  for (std::size_t row = 0; row < M; ++row) rows[row][M] /= rows[row][row];
  return true;
}

/// \brief Newton's method for M forms along M axes. A point of the unit box where the steps have become small; nothing
/// if they leave it for long.
template <std::size_t M, std::size_t D>
[[nodiscard]] std::optional<std::array<double, D>>
newton(const std::vector<Float_form<D>>& forms, const std::array<std::size_t, M>& axes, std::array<double, D> u)
{
  constexpr int max_steps = 40;
  constexpr double small = 1e-13;
  constexpr double margin = 0.5; // outside of the box, on the way
  for (int step = 0; step < max_steps; ++step) {
    std::array<std::array<double, M + 1>, M> rows{};
    for (std::size_t r = 0; r < M; ++r) {
      for (std::size_t k = 0; k < M; ++k) rows[r][k] = forms[r].slope(u, axes[k]);
      rows[r][M] = forms[r].value(u);
    }
    if (!solve<M>(rows)) return std::nullopt;
    double length = 0;
    for (std::size_t k = 0; k < M; ++k) {
      u[axes[k]] -= rows[k][M];
      length = std::max(length, std::abs(rows[k][M]));
      if (!(u[axes[k]] >= -margin && u[axes[k]] <= 1 + margin)) return std::nullopt;
    }
    if (length < small) break;
  }
  for (const double coordinate : u)
    if (!(coordinate >= 0 && coordinate <= 1)) return std::nullopt;
  return u;
}

} // namespace corral::certificate

#endif
