// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_TEST_GEOMETRY_RANDOM_CURVES_H
#define CORRAL_TEST_GEOMETRY_RANDOM_CURVES_H

#include <corral/polynomial/arithmetic.h>
#include <corral/polynomial/square_free.h>

#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace corral::test {

/// Random plane curves of the kinds that have singular, isolated and nearly singular points.
class Random_curves
{
public:
  using Curve = Polynomial<Rational, 2>;

  explicit Random_curves(std::mt19937::result_type seed) : random_(seed) {}

  /// A square-free polynomial, not constant.
  [[nodiscard]] Polynomial<Integer, 2> next()
  {
    for (;;) {
      auto f = square_free_part(any());
      if (!f.is_constant()) return f;
    }
  }

private:
  Curve any()
  {
    switch (random_() % 6) {
    case 0:
      return product();
    case 1:
      return sum_of_squares();
    case 2:
      return moved(sum_of_squares());
    case 3:
      return moved(product());
    case 4:
      return projection(2, 2);
    default:
      return projection(2, 3);
    }
  }

  Rational number(long largest, long denominator)
  {
    return {static_cast<long>(random_() % static_cast<unsigned long>(2 * largest + 1)) - largest, denominator};
  }
  Rational small()
  {
    Rational result = number(8, 4);
    result.canonicalize();
    return result;
  }

  /// All terms of degrees up to n.
  Curve dense(unsigned n)
  {
    std::vector<Curve::Term> terms;
    for (unsigned i = 0; i <= n; ++i)
      for (unsigned j = 0; i + j <= n; ++j)
        terms.push_back({{static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(j)}, small()});
    return collect<Rational, 2>(std::move(terms));
  }
  Curve circle()
  {
    return collect<Rational, 2>({{{2, 0}, 1}, {{0, 2}, 1}, {{1, 0}, small()}, {{0, 1}, small()}, {{0, 0}, small()}});
  }
  Curve product()
  {
    Curve f = constant<Rational, 2>(1);
    for (std::size_t factors = 2 + random_() % 2; factors > 0; --factors) {
      const auto kind = random_() % 3;
      f = f * (kind == 0 ? circle() : dense(static_cast<unsigned>(kind)));
    }
    return f;
  }
  Curve sum_of_squares()
  {
    const Curve a = dense(1 + random_() % 2);
    const Curve b = random_() % 2 == 0 ? circle() : dense(2);
    const Curve sum = a * a + b * b;
    return random_() % 3 == 0 ? sum * dense(1) : sum;
  }
  Curve moved(const Curve& f) { return f + constant<Rational, 2>(number(1, 1 + static_cast<long>(random_() % 2000))); }

  /// The image of the intersection of a sphere-like quadric and another surface: nodes and isolated points.
  Curve projection(unsigned n, unsigned m)
  {
    std::vector<Curve> f{circle(), dense(1), constant<Rational, 2>(1)};
    std::vector<Curve> g;
    for (unsigned k = 0; k <= m; ++k) g.push_back(dense(m == 3 ? (m - k + 1) / 2 : m - k));
    return sylvester_determinant(f, g, n + m);
  }
  static Curve sylvester_determinant(const std::vector<Curve>& f, const std::vector<Curve>& g, std::size_t size)
  {
    std::vector<std::vector<Curve>> rows;
    for (std::size_t k = 0; k + 1 < g.size(); ++k) rows.push_back(shifted(f, k, size));
    for (std::size_t k = 0; k + 1 < f.size(); ++k) rows.push_back(shifted(g, k, size));
    return determinant(rows);
  }
  static std::vector<Curve> shifted(const std::vector<Curve>& f, std::size_t shift, std::size_t size)
  {
    std::vector<Curve> row(size);
    for (std::size_t k = 0; k < f.size(); ++k) row[k + shift] = f[k];
    return row;
  }
  /// By the first row.
  static Curve determinant(const std::vector<std::vector<Curve>>& rows)
  {
    if (rows.empty()) return constant<Rational, 2>(1);
    Curve sum;
    for (std::size_t column = 0; column < rows.size(); ++column) {
      if (rows[0][column].is_zero()) continue;
      std::vector<std::vector<Curve>> minor;
      for (std::size_t k = 1; k < rows.size(); ++k) {
        minor.push_back(rows[k]);
        minor.back().erase(minor.back().begin() + static_cast<std::ptrdiff_t>(column));
      }
      const Curve part = rows[0][column] * determinant(minor);
      sum = column % 2 == 0 ? sum + part : sum - part;
    }
    return sum;
  }

  std::mt19937 random_;
};

} // namespace corral::test

#endif
