// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/polynomial/arithmetic.h>

#include "random_polynomial.h"

#include <gtest/gtest.h>

namespace {

using namespace corral;
using namespace corral::test;

// Values at a random point, by the definition, tell two different polynomials apart.
template <std::size_t D>
void check_ring_operations(std::uint64_t seed)
{
  Generator generator(seed);
  for (int round = 0; round < 60; ++round) {
    const auto f = random_polynomial<D>(generator, 12, 6);
    const auto g = round % 5 == 0 ? -f : random_polynomial<D>(generator, 12, 6);
    const auto x = random_point<D>(generator);
    const Rational a = value_by_definition(f, x);
    const Rational b = value_by_definition(g, x);
    const Rational c = random_rational(generator);
    const auto n = static_cast<unsigned>(generator() % 5);
    Rational a_to_n = 1;
    for (unsigned k = 0; k < n; ++k) a_to_n *= a;
    const auto check = [&](const Polynomial<Rational, D>& result, const Rational& expected) {
      EXPECT_EQ(value_by_definition(result, x), expected) << "round " << round;
      EXPECT_TRUE(is_canonical(result)) << "round " << round;
    };
    check(f + g, a + b);
    check(f - g, a - b);
    check(f * g, a * b);
    check(-f, -a);
    check(c * f, c * a);
    check(f * c, c * a);
    check(power(f, n), a_to_n);
    EXPECT_NE(value_by_definition(f + g, x), a + b + 1) << "the comparison itself must be able to fail";
  }
}

TEST(Arithmetic, agrees_with_values_in_every_dimension)
{
  check_ring_operations<1>(1);
  check_ring_operations<2>(2);
  check_ring_operations<3>(3);
  check_ring_operations<5>(4);
}

TEST(Arithmetic, dense_and_sparse_products_agree)
{
  Generator generator(7);
  for (int round = 0; round < 20; ++round) {
    const auto f = integer_form(random_polynomial<3>(generator, 40, 3)).numerator;
    const auto g = integer_form(random_polynomial<3>(generator, 40, 3)).numerator;
    EXPECT_EQ(detail::dense_product(f, g), detail::sparse_product(f, g));
  }
}

TEST(Arithmetic, expands_the_binomial_theorem)
{
  const auto sum = variable<Rational, 2>(0) + variable<Rational, 2>(1);
  const auto f = power(sum, 200);
  ASSERT_EQ(f.terms().size(), 201U);
  for (unsigned k = 0; k <= 200; ++k) {
    Integer binomial;
    mpz_bin_uiui(binomial.get_mpz_t(), 200, k);
    EXPECT_EQ(f.terms()[k].coefficient, binomial);
    EXPECT_EQ(f.terms()[k].exponents[0], k);
  }
}

TEST(Arithmetic, multiplies_twenty_linear_factors)
{
  Generator generator(11);
  auto product = constant<Rational, 3>(1);
  const auto x = random_point<3>(generator);
  Rational expected = 1;
  for (int i = 0; i < 20; ++i) {
    auto factor = constant<Rational, 3>(random_rational(generator));
    for (std::size_t axis = 0; axis < 3; ++axis)
      factor = factor + random_rational(generator) * variable<Rational, 3>(axis);
    product = product * factor;
    expected *= value_by_definition(factor, x);
  }
  EXPECT_EQ(product.terms().size(), 1771U);
  EXPECT_EQ(value_by_definition(product, x), expected);
}

TEST(Arithmetic, refuses_a_product_beyond_the_budget)
{
  const auto x = variable<Rational, 4>(0);
  auto f = constant<Rational, 4>(1);
  for (std::size_t axis = 0; axis < 4; ++axis) f = f + variable<Rational, 4>(axis);
  EXPECT_THROW((void)power(f, 200), Budget_exceeded);
  EXPECT_THROW((void)power(x, 65536), Budget_exceeded);
  EXPECT_THROW((void)power(constant<Rational, 4>(3), 4000000000U), Budget_exceeded);
  EXPECT_EQ(power(x, 65535).degree(0), 65535U);
}

TEST(Integer_form, keeps_the_sign_and_divides_by_the_content)
{
  const auto x = variable<Rational, 1>(0);
  const auto f = Rational(-4, 3) * x * x + constant<Rational, 1>(Rational(-2, 5));
  const auto g = integer_primitive(f);
  ASSERT_EQ(g.terms().size(), 2U);
  EXPECT_EQ(g.terms()[0].coefficient, -3);
  EXPECT_EQ(g.terms()[1].coefficient, -10);
  EXPECT_EQ(to_rational(integer_form(f)), f);
  EXPECT_TRUE(integer_primitive(Polynomial<Rational, 1>()).is_zero());
}

} // namespace
