// SPDX-License-Identifier: LGPL-3.0-or-later
#include "rounds.h"

#include "geometry/Side_zeros.h"

#include <corral/algebra/real_roots.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace corral {
namespace {

constexpr geometry::Segment unit{0, 0.0, 0.0, 1.0};

/// The polynomial with these Bernstein coefficients on [0, 1].
Integer_polynomial from_bernstein(const std::vector<Integer>& b)
{
  const std::size_t n = b.size() - 1;
  std::vector<Integer> power(n + 1);
  std::vector<Integer> difference = b; // c_k = C(n, k) (k-th difference at 0)
  Integer binomial = 1;
  for (std::size_t k = 0; k <= n; ++k) {
    power[k] = binomial * difference[0];
    for (std::size_t i = 0; i + 1 < difference.size(); ++i) difference[i] = difference[i + 1] - difference[i];
    if (difference.size() > 1) difference.pop_back();
    binomial = binomial * static_cast<unsigned long>(n - k) / static_cast<unsigned long>(k + 1);
  }
  return Integer_polynomial(std::move(power));
}

// Whatever true polynomial the doubles stand for: what `isolate` says of it holds.
TEST(isolate, is_right_for_every_polynomial_within_the_error)
{
  std::mt19937 random(9);
  const auto pick = [&](long size) {
    return static_cast<long>(random() % static_cast<unsigned long>(2 * size + 1)) - size;
  };
  int told = 0;
  for (int round = 0; round < test::rounds(3000); ++round) {
    const std::size_t n = 2 + random() % 5;
    const long error = 1L << (random() % 12);
    std::vector<Integer> truth;
    std::vector<double> seen;
    for (std::size_t i = 0; i <= n; ++i) {
      const long value = pick(random() % 3 == 0 ? 4 : 1000);
      truth.emplace_back(value);
      seen.push_back(static_cast<double>(value + pick(error)));
    }
    const auto p = from_bernstein(truth);
    if (p.is_zero() || truth.front() == 0 || truth.back() == 0) continue;
    const std::array<int, 2> ends{sgn(truth.front()), sgn(truth.back())};
    const auto found = geometry::isolate(seen, static_cast<double>(error), ends, unit, 0x1p-4);
    if (!found) continue;
    ++told;
    const auto roots = isolate_real_roots(p, Rational_interval(0, 1));
    ASSERT_EQ(found->zeros.size(), roots.size()) << "round " << round;
    for (std::size_t k = 0; k < roots.size(); ++k)
      EXPECT_EQ(count_real_roots(p, {Rational(found->zeros[k].low), Rational(found->zeros[k].high)}), 1U);
  }
  EXPECT_GT(told, test::rounds(3000) / 10);
}

// Both middle coefficients may change sign: one zero or three.
TEST(isolate, does_not_count_over_two_doubtful_coefficients)
{
  EXPECT_FALSE(geometry::isolate({1e-3, 0, 0, -1e-3}, 1e-2, {1, -1}, unit, 1));
  EXPECT_TRUE(geometry::isolate({1, 0, -1}, 1e-2, {1, -1}, unit, 1));
}

} // namespace
} // namespace corral
