// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_TEST_BENCHMARK_CASES_H
#define CORRAL_TEST_BENCHMARK_CASES_H

#include "localization/paper_polynomials.h"

#include <corral/polynomial/arithmetic.h>

#include <random>
#include <string>
#include <vector>

/// \file
/// The problems that are timed.
namespace corral::benchmark {

template <std::size_t D>
struct Problem
{
  std::string name;
  Polynomial<Rational, D> f;
  int lower; ///< of every side of the box; the upper end is 1
};

template <std::size_t D>
Grid<D> grid_of(const Problem<D>& problem, std::uint32_t resolution)
{
  Rational_box<D> box;
  box.fill(Rational_interval(problem.lower, 1));
  Resolution<D> cells;
  cells.fill(resolution);
  return {box, cells};
}

inline std::vector<Problem<2>> curves()
{
  std::vector<Problem<2>> result;
  for (std::size_t k = 0; k < 10; ++k) result.push_back({"curve " + std::to_string(k + 1), test::paper_curve(k), 0});
  return result;
}

inline std::vector<Problem<3>> surfaces()
{
  std::vector<Problem<3>> result;
  for (std::size_t k = 0; k < 10; ++k)
    result.push_back({"surface " + std::to_string(k + 11), test::paper_surface(k), -1});
  return result;
}

/// All terms up to a total degree, with coefficients that fill the mantissa.
inline Problem<2> dense_curve(unsigned degree)
{
  std::mt19937_64 generator(degree);
  std::vector<Polynomial<Rational, 2>::Term> terms;
  for (unsigned i = 0; i <= degree; ++i)
    for (unsigned j = 0; i + j <= degree; ++j) {
      const auto mantissa = static_cast<double>(static_cast<std::int64_t>(generator()) >> 11);
      terms.push_back({{static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(j)}, Rational(mantissa * 0x1p-52)});
    }
  return {"dense " + std::to_string(degree), collect<Rational, 2>(std::move(terms)), -1};
}

/// The Chebyshev polynomial of one variable.
inline Polynomial<Rational, 2> chebyshev(unsigned degree, std::size_t axis)
{
  auto previous = constant<Rational, 2>(1);
  auto current = variable<Rational, 2>(axis);
  const auto twice = constant<Rational, 2>(2) * current;
  for (unsigned k = 1; k < degree; ++k) {
    auto next = twice * current - previous;
    previous = std::move(current);
    current = std::move(next);
  }
  return current;
}

inline std::vector<Problem<2>> hard_curves()
{
  auto lines = constant<Rational, 2>(1);
  for (int k = 1; k <= 12; ++k) {
    const Rational a(7 * k % 13 - 6, 5);
    const Rational b(5 * k % 11 - 5, 7);
    const Rational c(3 * k % 17 - 8, 19);
    lines = lines
            * (constant<Rational, 2>(a) * variable<Rational, 2>(0) + constant<Rational, 2>(b) * variable<Rational, 2>(1)
               + constant<Rational, 2>(c));
  }
  return {{"T_12(x) = T_9(y)", chebyshev(12, 0) - chebyshev(9, 1), -1},
          {"12 lines", lines, -1},
          {"near-tangent ovals", parse_polynomial<2>("(x^2 + 4*y^2 - 1/2)*(4*x^2 + y^2 - 1/2) + 1/100000", {"x", "y"}),
           -1}};
}

} // namespace corral::benchmark

#endif
