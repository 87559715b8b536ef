// SPDX-License-Identifier: LGPL-3.0-or-later
#include "exact_values.h"

#include <algebra/cofactors.h>
#include <algebra/multivariate.h>

#include <corral/polynomial/Box.h>
#include <corral/polynomial/arithmetic.h>
#include <corral/polynomial/evaluate.h>

#include <gtest/gtest.h>

namespace {

using namespace corral;
using namespace corral::exact;

/// Whether an elimination is what the determinants of the definition say at some values of x.
bool agrees(const Elimination& elimination, const Bivariate& f, const Bivariate& g)
{
  for (const Rational& x : {Rational(0), Rational(-3), Rational(5, 7), Rational(1, 1000003)}) {
    const auto a = truth::at(f, x);
    const auto b = truth::at(g, x);
    if (evaluate(elimination.resultant, x) != truth::subresultant(a, b, 0, 0)) return false;
    if (elimination.s1.is_zero() && elimination.s0.is_zero()) continue;
    if (evaluate(elimination.s1, x) != truth::subresultant(a, b, 1, 1)
        || evaluate(elimination.s0, x) != truth::subresultant(a, b, 1, 0))
      return false;
  }
  return true;
}

TEST(Elimination, is_the_determinant_of_its_definition)
{
  truth::Random_polynomials random(11);
  for (unsigned n = 1; n <= 5; ++n)
    for (unsigned m = 1; m <= 5; ++m) {
      const auto f = bivariate(random.dense<2>(n, 53), 1);
      const auto g = bivariate(random.dense<2>(m, 53), 1);
      auto elimination = eliminate(f, g);
      EXPECT_TRUE(agrees(elimination, f, g)) << n << ' ' << m;
      // Negative controls: the other sign, and one coefficient off by one.
      const auto& resultant = elimination.resultant;
      elimination.resultant = multiply(resultant, {-1});
      EXPECT_FALSE(agrees(elimination, f, g));
      auto coefficients = multiply(resultant, {-1}).coefficients();
      for (Integer& c : coefficients) c = -c;
      coefficients.back() += 1;
      elimination.resultant = Integer_polynomial(coefficients);
      EXPECT_FALSE(agrees(elimination, f, g));
    }
}

TEST(Elimination, is_zero_for_a_common_factor_and_only_then)
{
  truth::Random_polynomials random(12);
  for (unsigned n = 1; n <= 3; ++n) {
    const auto f = random.dense<2>(n, 40);
    const auto g = random.dense<2>(n + 1, 40);
    const auto common = random.dense<2>(1, 40);
    EXPECT_FALSE(eliminate(bivariate(f, 1), bivariate(g, 1)).resultant.is_zero());
    const auto both = eliminate(bivariate(common * f, 1), bivariate(common * g, 1));
    EXPECT_TRUE(both.resultant.is_zero());
  }
}

TEST(Elimination, has_cofactors_that_give_it)
{
  truth::Random_polynomials random(13);
  for (unsigned n = 2; n <= 5; ++n)
    for (const std::size_t axis : {0U, 1U}) {
      const auto f = random.dense<2>(n, 53);
      const auto g = random.dense<2>(n - 1, 53);
      const auto found = cofactors(f, g, axis);
      ASSERT_TRUE(found);
      EXPECT_EQ(found->a * f + found->b * g, found->combination);
      EXPECT_FALSE(found->combination.is_zero());
      EXPECT_EQ(found->combination.degree(axis), 0U);
    }
  const auto line = truth::plane("x + 2*y - 3");
  EXPECT_FALSE(cofactors(line * truth::plane("x - y"), line * truth::plane("x + y"), 1));
}

TEST(Common_divisor, is_the_factor_that_was_put_in)
{
  truth::Random_polynomials random(14);
  for (unsigned n = 1; n <= 3; ++n) {
    const auto common = random.dense<3>(n, 40);
    const auto f = random.dense<3>(2, 40);
    const auto g = random.dense<3>(n, 40);
    const auto found = common_factor(common * f, common * g);
    EXPECT_EQ(found.divisor * found.f, common * f);
    EXPECT_EQ(found.divisor * found.g, common * g);
    EXPECT_EQ(found.divisor.total_degree(), common.total_degree()); // f and g, dense and random, are coprime
  }
}

TEST(Common_divisor, in_one_variable_leaves_coprime_cofactors)
{
  truth::Random_polynomials random(15);
  const auto some = [&](std::size_t degree) {
    std::vector<Integer> c;
    for (std::size_t k = 0; k <= degree; ++k) c.push_back(random.integer(70));
    return Integer_polynomial(c);
  };
  const auto over_rationals = [](const Integer_polynomial& p) { return std::vector<Rational>(p.begin(), p.end()); };
  for (std::size_t n = 1; n <= 8; ++n) {
    const auto common = some(n);
    const auto p = multiply(common, some(3));
    const auto q = multiply(common, some(n));
    const auto divisor = greatest_common_divisor(p, q);
    ASSERT_TRUE(divides(divisor, p));
    ASSERT_TRUE(divides(divisor, q));
    const auto f = over_rationals(exact_quotient(normalized(p), divisor));
    const auto g = over_rationals(exact_quotient(normalized(q), divisor));
    EXPECT_NE(truth::subresultant(f, g, 0, 0), 0);
    EXPECT_EQ(truth::subresultant(over_rationals(p), over_rationals(q), 0, 0), 0); // negative control
  }
}

TEST(Resultant, of_surfaces_vanishes_below_their_common_points)
{
  // The curve (t, t^2, t^3) lies on both.
  const auto below = resultant(truth::space("z - x*y"), truth::space("z^2 - y^3"));
  EXPECT_FALSE(below.is_zero());
  for (const int t : {-3, -1, 2, 5})
    EXPECT_EQ(evaluate(truth::over_rationals(below), Rational_point<2>{Rational(t), Rational(t * t)}), 0);
  EXPECT_NE(evaluate(truth::over_rationals(below), Rational_point<2>{Rational(2), Rational(3)}), 0);
}

} // namespace
