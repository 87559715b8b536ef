// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_TEST_ALGEBRA_EXACT_VALUES_H
#define CORRAL_TEST_ALGEBRA_EXACT_VALUES_H

#include <algebra/Bernstein_form.h>
#include <algebra/Bivariate.h>

#include <corral/number/Rational.h>
#include <corral/polynomial/integer_form.h>
#include <corral/polynomial/parse.h>

#include <random>
#include <string>
#include <utility>
#include <vector>

/// \file
/// Truth for the tests of algebra, by rational arithmetic and definitions alone.
namespace truth {

using corral::Integer;
using corral::Integer_polynomial;
using corral::Polynomial;
using corral::Rational;

inline Polynomial<Integer, 2> plane(const std::string& text)
{
  return corral::integer_primitive(corral::parse_polynomial<2>(text, {"x", "y"}));
}
inline Polynomial<Integer, 3> space(const std::string& text)
{
  return corral::integer_primitive(corral::parse_polynomial<3>(text, {"x", "y", "z"}));
}

template <std::size_t D>
Polynomial<Rational, D> over_rationals(const Polynomial<Integer, D>& f)
{
  return corral::transform<Rational>(f, [](const Integer& c) { return Rational(c); });
}

inline Rational power(const Rational& x, std::size_t n)
{
  Rational result = 1;
  for (std::size_t k = 0; k < n; ++k) result *= x;
  return result;
}

/// Gaussian elimination.
inline Rational determinant(std::vector<std::vector<Rational>> rows)
{
  Rational result = 1;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    std::size_t pivot = k;
    while (pivot < rows.size() && rows[pivot][k] == 0) ++pivot;
    if (pivot == rows.size()) return 0;
    if (pivot != k) {
      std::swap(rows[pivot], rows[k]);
      result = -result;
    }
    result *= rows[k][k];
    for (std::size_t i = k + 1; i < rows.size(); ++i) {
      const Rational factor = rows[i][k] / rows[k][k];
      for (std::size_t j = k; j < rows.size(); ++j) rows[i][j] -= factor * rows[k][j];
    }
  }
  return result;
}

/// \brief The coefficient of y^i of the j-th subresultant of two polynomials in y, from the constant coefficient up: a
/// minor of the Sylvester matrix, whose last column is that of y^i. For j = i = 0 it is the resultant; where both have
/// the degree j it is the second polynomial, by convention.
inline Rational subresultant(const std::vector<Rational>& f, const std::vector<Rational>& g, std::size_t j,
                             std::size_t i)
{
  const std::size_t n = f.size() - 1;
  const std::size_t m = g.size() - 1;
  if (j == n && j == m) return g[i];
  const std::size_t size = n + m - 2 * j;
  std::vector<std::vector<Rational>> rows;
  const auto add_rows = [&](const std::vector<Rational>& p, std::size_t count) {
    for (std::size_t shift = count; shift-- > 0;) { // y^shift p
      std::vector<Rational> row;
      for (std::size_t column = 0; column < size; ++column) {
        const std::size_t y = column + 1 == size ? i : n + m - j - 1 - column;
        row.push_back(y >= shift && y - shift < p.size() ? p[y - shift] : Rational(0));
      }
      rows.push_back(std::move(row));
    }
  };
  add_rows(f, m - j);
  add_rows(g, n - j);
  return determinant(std::move(rows));
}

/// The coefficients of y^0, y^1, ... at some x.
inline std::vector<Rational> at(const corral::exact::Bivariate& f, const Rational& x)
{
  std::vector<Rational> result;
  for (const auto& c : f) result.push_back(corral::evaluate(c, x));
  return result;
}

/// The value of a Bernstein form by the definition of the basis.
template <std::size_t D>
Rational value(const corral::exact::Bernstein_form<D>& form, const std::array<Rational, D>& u)
{
  Rational sum = 0;
  for (std::size_t index = 0; index < form.values.size(); ++index) {
    Rational term = form.values[index];
    for (std::size_t axis = D, rest = index; axis-- > 0; rest /= form.size[axis]) {
      const std::size_t n = form.size[axis] - 1;
      const std::size_t k = rest % form.size[axis];
      Integer binomial;
      mpz_bin_uiui(binomial.get_mpz_t(), n, k);
      term *= binomial * power(u[axis], k) * power(1 - u[axis], n - k);
    }
    sum += term;
  }
  return sum;
}

/// Dense polynomials with coefficients of some bits.
class Random_polynomials
{
public:
  explicit Random_polynomials(unsigned seed) : numbers_(seed) {}

  Integer integer(unsigned bits)
  {
    Integer result = numbers_() % 2 == 0 ? 1 : -1;
    for (unsigned k = 0; k < bits; ++k) result = 2 * result + static_cast<long>(numbers_() % 2);
    return result;
  }
  Rational rational() { return Rational(static_cast<long>(numbers_() % 201) - 100) / (1 + numbers_() % 30); }

  template <std::size_t D>
  Polynomial<Integer, D> dense(unsigned degree, unsigned bits)
  {
    std::vector<typename Polynomial<Integer, D>::Term> terms;
    std::size_t count = 1;
    for (std::size_t k = 0; k < D; ++k) count *= degree + 1U;
    for (std::size_t index = 0; index < count; ++index) {
      corral::Exponents<D> exponents{};
      unsigned total = 0;
      for (std::size_t k = 0, rest = index; k < D; ++k, rest /= degree + 1U) {
        exponents[k] = static_cast<std::uint16_t>(rest % (degree + 1U));
        total += exponents[k];
      }
      if (total <= degree) terms.push_back({exponents, integer(bits)});
    }
    return corral::collect<Integer, D>(std::move(terms));
  }

private:
  std::mt19937 numbers_;
};

} // namespace truth

#endif
