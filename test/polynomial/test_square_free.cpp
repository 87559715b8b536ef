// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/polynomial/arithmetic.h>
#include <corral/polynomial/square_free.h>

#include "random_polynomial.h"

#include <gtest/gtest.h>

namespace {

using namespace corral;
using namespace corral::test;

template <std::size_t D>
Polynomial<Rational, D> random_factor(Generator& generator)
{
  auto f = constant<Rational, D>(random_rational(generator));
  for (std::size_t axis = 0; axis < D; ++axis)
    f = f + random_rational(generator) * power(variable<Rational, D>(axis), 1 + generator() % 2);
  return f;
}

/// f with a positive leading coefficient.
template <std::size_t D>
Polynomial<Integer, D> positive(const Polynomial<Integer, D>& f)
{
  return f.is_zero() || f.terms().back().coefficient > 0 ? f : -f;
}

// Random factors have no common factor, so that each must be left once and nothing else.
template <std::size_t D>
void check_products(std::uint64_t seed)
{
  Generator generator(seed);
  for (int round = 0; round < 20; ++round) {
    auto product = constant<Rational, D>(random_rational(generator) + 1);
    auto distinct = constant<Rational, D>(1);
    bool repeats = false;
    for (int i = 0; i < 3; ++i) {
      const auto factor = random_factor<D>(generator);
      const auto multiplicity = static_cast<unsigned>(1 + generator() % 3);
      repeats = repeats || multiplicity > 1;
      product = product * power(factor, multiplicity);
      distinct = distinct * factor;
    }
    const auto result = square_free_part(product);
    EXPECT_EQ(positive(result), positive(integer_primitive(distinct)));
    EXPECT_EQ(content(result), 1);
    if (repeats) { // negative control: the comparison tells the input from its square-free part
      EXPECT_NE(positive(result), positive(integer_primitive(product)));
    }
    EXPECT_EQ(square_free_part(result), result);
  }
}

TEST(Square_free, leaves_every_factor_once)
{
  check_products<1>(1);
  check_products<2>(2);
  check_products<3>(3);
  check_products<4>(4);
}

TEST(Square_free, handles_factors_of_some_variables_only)
{
  const auto x = variable<Rational, 3>(0);
  const auto y = variable<Rational, 3>(1);
  const auto z = variable<Rational, 3>(2);
  EXPECT_EQ(square_free_part(power(x, 5) * power(y, 2) * z), integer_primitive(x * y * z));
  EXPECT_EQ(square_free_part(power(y, 200)), integer_primitive(y));
  EXPECT_EQ(square_free_part(power(y, 2) * (x + z)), integer_primitive(y * (x + z)));
}

TEST(Square_free, circle_twice_and_a_line)
{
  const auto x = variable<Rational, 2>(0);
  const auto y = variable<Rational, 2>(1);
  const auto circle = x * x + y * y - constant<Rational, 2>(1);
  EXPECT_EQ(square_free_part(circle * circle * (x - y)), integer_primitive(circle * (x - y)));
}

TEST(Square_free, leaves_a_constant_of_the_same_sign)
{
  EXPECT_TRUE(square_free_part(Polynomial<Rational, 2>()).is_zero());
  EXPECT_EQ(square_free_part(constant<Rational, 2>(Rational(-7, 3))), (constant<Integer, 2>(-1)));
  EXPECT_EQ(square_free_part(constant<Rational, 2>(12)), (constant<Integer, 2>(1)));
}

template <std::size_t D>
void check_quick_test(std::uint64_t seed)
{
  Generator generator(seed);
  for (int round = 0; round < 50; ++round) {
    const auto f = random_factor<D>(generator);
    const auto g = random_factor<D>(generator);
    EXPECT_EQ(is_surely_square_free(f * g), square_free_part(f * g) == integer_primitive(f * g));
    EXPECT_FALSE(is_surely_square_free(f * g * g));
  }
}

TEST(Square_free, quick_test_finds_repeated_factors)
{
  check_quick_test<1>(11);
  check_quick_test<2>(12);
  check_quick_test<3>(13);
  const auto x = variable<Rational, 2>(0);
  const auto y = variable<Rational, 2>(1);
  EXPECT_TRUE(is_surely_square_free(x * y));
  EXPECT_TRUE(is_surely_square_free(constant<Rational, 2>(Rational(-3, 7))));
  EXPECT_FALSE(is_surely_square_free(x * y * y)); // of one variable only
  EXPECT_TRUE(is_surely_square_free(y * y - x * x * x));
}

TEST(Square_free, is_quick_on_large_inputs)
{
  Generator generator(9);
  std::vector<Polynomial<Rational, 3>::Term> terms;
  for (std::uint16_t i = 0; i <= 20; ++i)
    for (std::uint16_t j = 0; i + j <= 20; ++j)
      for (std::uint16_t k = 0; i + j + k <= 20; ++k) terms.push_back({{i, j, k}, random_rational(generator)});
  const Polynomial<Rational, 3> dense(std::move(terms));
  EXPECT_EQ(square_free_part(dense), integer_primitive(dense));
  auto lines = constant<Rational, 2>(1);
  for (int i = 0; i < 10; ++i) lines = lines * random_factor<2>(generator);
  EXPECT_EQ(square_free_part(lines * lines), positive(integer_primitive(lines)));
}

} // namespace
