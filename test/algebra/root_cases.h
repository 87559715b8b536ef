// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_TEST_ALGEBRA_ROOT_CASES_H
#define CORRAL_TEST_ALGEBRA_ROOT_CASES_H

#include <corral/algebra/Integer_polynomial.h>

#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

/// \file
/// Polynomials that are hard for root isolators, and random ones.
namespace root_cases {

using corral::Integer;
using corral::Integer_polynomial;

struct Case
{
  std::string name;
  Integer_polynomial polynomial;
};

inline Integer_polynomial power(const Integer_polynomial& p, unsigned n)
{
  Integer_polynomial result = {1};
  for (unsigned i = 0; i < n; ++i) result = corral::multiply(result, p);
  return result;
}

inline Integer_polynomial wilkinson(unsigned n)
{
  Integer_polynomial result = {1};
  for (unsigned i = 1; i <= n; ++i) result = corral::multiply(result, {-static_cast<long>(i), 1});
  return result;
}

/// x^n - 2 (a x - 1)^2: two roots near 1/a, about a^(-n/2-1) apart.
inline Integer_polynomial mignotte(unsigned n, const Integer& a)
{
  std::vector<Integer> result(n + 1);
  result[n] = 1;
  result[0] -= 2;
  result[1] += 4 * a;
  result[2] -= 2 * a * a;
  return Integer_polynomial(std::move(result));
}

inline Integer_polynomial chebyshev(unsigned n)
{
  Integer_polynomial last = {1};
  Integer_polynomial current = {0, 1};
  for (unsigned i = 1; i < n; ++i) {
    auto next = corral::multiply(current, {0, 2}).coefficients();
    for (std::size_t j = 0; j < last.size(); ++j) next[j] -= last[j];
    last = std::move(current);
    current = Integer_polynomial(std::move(next));
  }
  return current;
}

inline Integer_polynomial random_polynomial(std::mt19937_64& random, unsigned degree, unsigned bits)
{
  std::vector<Integer> p(degree + 1);
  for (Integer& c : p) {
    c = 0;
    for (unsigned b = 0; b < bits; b += 32) c = (c << 32) + static_cast<unsigned long>(random() & 0xffffffffU);
    c >>= (bits + 31) / 32 * 32 - bits;
    if ((random() & 1) != 0) c = -c;
  }
  if (p.back() == 0) p.back() = 1;
  return Integer_polynomial(std::move(p));
}

inline std::vector<Case> hard_cases()
{
  const Integer big = Integer(1) << 1000;
  const auto cluster = corral::multiply(corral::multiply({-1000000000, 1000000000}, {-1000000001, 1000000000}),
                                        {-1000000002, 1000000000});
  return {
      {"wilkinson 20", wilkinson(20)},
      {"wilkinson 60", wilkinson(60)},
      {"mignotte, roots 2^-200 apart", mignotte(18, Integer(1) << 20)},
      {"mignotte 31", mignotte(31, 123456789)},
      {"chebyshev 40", chebyshev(40)},
      {"chebyshev 64", chebyshev(64)},
      {"cluster near 1", corral::multiply(cluster, {3, 0, 1})},
      {"cluster squared", corral::multiply(power(cluster, 2), {-2, 0, 1})},
      {"multiple: (x-1)^7 (x^2-2)^3 (3x+5)^2 x^4",
       corral::multiply(corral::multiply(power({-1, 1}, 7), power({-2, 0, 1}, 3)),
                        corral::multiply(power({5, 3}, 2), power({0, 1}, 4)))},
      {"no real root", {1, 0, 1, 0, 1}},
      {"only zero, four times", {0, 0, 0, 0, 7}},
      {"huge coefficients", {Integer(-big * big + 1), 0, 3, big}},
      {"linear with huge coefficients", {Integer(big + 1), Integer(-3 * big)}},
      {"constant", {5}},
      {"two roots 2^-1000 from each other", corral::multiply({-1, Integer(big)}, {-2, Integer(big)})},
  };
}

} // namespace root_cases

#endif
