// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/polynomial/evaluate.h>

#include <corral/number/Rational_interval.h>
#include <corral/polynomial/arithmetic.h>

#include "random_polynomial.h"

#include <gtest/gtest.h>

namespace {

using namespace corral;
using namespace corral::test;

/// A number that counts what is done with it.
struct Counting
{
  Rational value;
  inline static int additions = 0;
  inline static int multiplications = 0;
  Counting() = default;
  Counting(Rational v) : value(std::move(v)) {}
  Counting(int v) : value(v) {}
  Counting& operator+=(const Counting& b)
  {
    ++additions;
    value += b.value;
    return *this;
  }
  Counting& operator*=(const Counting& b)
  {
    ++multiplications;
    value *= b.value;
    return *this;
  }
  friend Counting operator*(Counting a, const Counting& b) { return a *= b; }
};

template <std::size_t D>
void check_values(std::uint64_t seed)
{
  Generator generator(seed);
  for (int round = 0; round < 100; ++round) {
    const auto f = random_polynomial<D>(generator, 20, 9);
    const auto x = random_point<D>(generator);
    EXPECT_EQ(evaluate(f, x), value_by_definition(f, x));
    EXPECT_NE(evaluate(f + constant<Rational, D>(1), x), value_by_definition(f, x)); // a difference is seen
  }
}

TEST(Evaluate, agrees_with_the_definition)
{
  check_values<1>(1);
  check_values<2>(2);
  check_values<3>(3);
  check_values<4>(4);
}

TEST(Evaluate, runs_over_doubles_integers_and_intervals)
{
  const auto f = Polynomial<double, 2>({{{0, 0}, -1.0}, {{0, 2}, 1.0}, {{2, 0}, 1.0}});
  EXPECT_EQ(evaluate(f, {3.0, 4.0}), 24.0);
  const auto g = transform<Integer>(f, [](double c) { return Integer(c); });
  EXPECT_EQ(evaluate(g, {Integer(3), Integer(4)}), 24);
  const auto h = transform<Rational_interval>(f, [](double c) { return Rational_interval(Rational(c)); });
  const auto range = evaluate(h, {Rational_interval(-1, 2), Rational_interval(0, 1)});
  EXPECT_EQ(range.lower(), -1); // x^2 is squared, not multiplied, so that it is never negative
  EXPECT_EQ(range.upper(), 4);
  EXPECT_EQ(evaluate(Polynomial<Rational, 2>(), {Rational(3), Rational(4)}), 0);
}

void expect_count(const Polynomial<Rational, 2>& f, int additions, int multiplications)
{
  Counting::additions = Counting::multiplications = 0;
  (void)evaluate(transform<Counting>(f, [](const Rational& c) { return Counting(c); }),
                 std::array<Counting, 2>{Rational(3), Rational(5)});
  EXPECT_EQ(Counting::additions, additions);
  EXPECT_EQ(Counting::multiplications, multiplications);
}

TEST(Evaluate, does_no_work_for_absent_terms)
{
  const auto x = variable<Rational, 2>(0);
  const auto y = variable<Rational, 2>(1);
  expect_count(constant<Rational, 2>(7), 0, 0);
  expect_count(x, 0, 1);
  expect_count(power(x, 16), 0, 5);
  expect_count(power(x + constant<Rational, 2>(1), 9), 9, 9);
  expect_count(power(x + y, 3), 3, 3 + (1 + 2 + 3)); // x^3 + 3 x^2 y + 3 x y^2 + y^3
}

} // namespace
