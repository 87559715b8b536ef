// SPDX-License-Identifier: LGPL-3.0-or-later
#include "root_cases.h"

#include <corral/algebra/real_roots.h>
#include <corral/errors.h>

#include <gtest/gtest.h>

namespace {

using namespace corral;

/// Why `roots` is not the list of all `expected` real roots of p, or "".
std::string complaint(const Integer_polynomial& p, const std::vector<Real_root>& roots, std::size_t expected)
{
  if (roots.size() != expected) return std::to_string(roots.size()) + " roots, expected " + std::to_string(expected);
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const auto& r = roots[i];
    if (i > 0 && roots[i - 1].upper() > r.lower()) return "not in order";
    if (r.is_point() ? sign_at(p, r.lower()) != 0
                     : sign_at(r.polynomial(), r.lower()) * sign_at(r.polynomial(), r.upper()) >= 0)
      return "interval " + std::to_string(i) + " proves no root";
    Integer_polynomial power = {1};
    for (unsigned k = 0; k < r.multiplicity(); ++k) power = multiply(power, r.polynomial());
    if (!r.is_point() && !divides(power, p)) return "multiplicity " + std::to_string(i) + " too high";
  }
  return "";
}

TEST(Real_roots, finds_all_roots_of_products_of_linear_factors)
{
  EXPECT_EQ(complaint(root_cases::wilkinson(20), isolate_real_roots(root_cases::wilkinson(20)), 20), "");
  EXPECT_EQ(complaint(root_cases::wilkinson(100), isolate_real_roots(root_cases::wilkinson(100)), 100), "");
  auto lost = isolate_real_roots(root_cases::wilkinson(20));
  lost.pop_back(); // negative control: an isolator that drops the last root
  EXPECT_NE(complaint(root_cases::wilkinson(20), lost, 20), "");
}

TEST(Real_roots, knows_the_roots_of_chebyshev_polynomials)
{
  for (const unsigned n : {1U, 2U, 5U, 32U, 100U}) {
    const auto p = root_cases::chebyshev(n);
    EXPECT_EQ(complaint(p, isolate_real_roots(p), n), "");
    EXPECT_EQ(count_real_roots(p, {-1, 1}), n);
    EXPECT_EQ(count_real_roots(p, {1, 5}), 0U);
  }
}

TEST(Real_roots, separates_roots_that_are_2_to_the_minus_200_apart)
{
  const auto p = root_cases::mignotte(18, Integer(1) << 20);
  auto roots = isolate_real_roots(p);
  ASSERT_EQ(complaint(p, roots, 4), "");
  Rational gap(1);
  mpq_div_2exp(gap.get_mpq_t(), gap.get_mpq_t(), 199);
  EXPECT_LT(roots[2].lower() - roots[1].upper(), gap);
  for (auto& root : roots) {
    root.refine_to(gap / 1000);
    EXPECT_LE(root.upper() - root.lower(), gap / 1000);
  }
  EXPECT_EQ(complaint(p, roots, 4), "");
}

TEST(Real_roots, gives_multiplicities)
{
  const auto p = multiply(multiply(root_cases::power({-1, 1}, 7), root_cases::power({-2, 0, 1}, 3)),
                          multiply(root_cases::power({5, 3}, 2), root_cases::power({0, 1}, 4)));
  const auto roots = isolate_real_roots(p);
  ASSERT_EQ(complaint(p, roots, 5), "");
  const unsigned expected[] = {2, 3, 4, 7, 3};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(roots[i].multiplicity(), expected[i]);
}

TEST(Real_roots, counts_the_ends_of_a_closed_interval)
{
  const auto p = root_cases::wilkinson(5);
  EXPECT_EQ(count_real_roots(p, {1, 5}), 5U);
  EXPECT_EQ(count_real_roots(p, {Rational(11, 10), 5}), 4U);
  EXPECT_EQ(count_real_roots(p, {2, 3}), 2U);
  EXPECT_EQ(count_real_roots(p, {2, 2}), 1U);
  EXPECT_EQ(count_real_roots(p, {Rational(3, 2), Rational(3, 2)}), 0U);
  EXPECT_EQ(count_real_roots({0, 0, 1}, {0, 1}), 1U);
}

TEST(Real_roots, decides_signs_and_rationality_at_roots)
{
  auto roots = isolate_real_roots({-2, 0, 1});
  ASSERT_EQ(roots.size(), 2U);
  auto& root = roots[1]; // sqrt(2)
  EXPECT_FALSE(root.make_rational());
  EXPECT_EQ(root.sign_of({-2, 0, 1}), 0);
  EXPECT_EQ(root.sign_of({-4, 0, 0, 0, 1}), 0);
  EXPECT_EQ(root.sign_of({-3, 2}), -1);
  EXPECT_EQ(root.sign_of({Integer("-141421356237309504880168872420969807856967187537694"),
                          Integer("100000000000000000000000000000000000000000000000000")}),
            1);
  EXPECT_EQ(root.compare(Rational(3, 2)), -1);
  EXPECT_EQ(root.compare(Rational(7, 5)), 1);
  auto third = isolate_real_roots({-1, 3}, {0, 1});
  ASSERT_EQ(third.size(), 1U);
  EXPECT_TRUE(third[0].make_rational());
  EXPECT_EQ(third[0].lower(), Rational(1, 3));
}

TEST(Real_roots, holds_together_on_products_of_random_polynomials)
{
  std::mt19937_64 random(11);
  for (unsigned round = 0; round < 60; ++round) {
    const auto p = root_cases::random_polynomial(random, 1 + round % 12, 1 + 13 * (round % 7));
    const auto q = root_cases::random_polynomial(random, 1 + round % 5, 40);
    const auto product = multiply(multiply(p, p), q);
    const auto expected = count_real_roots(p, {-100, 100}) + count_real_roots(q, {-100, 100});
    EXPECT_EQ(complaint(product, isolate_real_roots(product, {-100, 100}), expected), "") << round;
  }
}

TEST(Real_roots, finds_the_simplest_rational)
{
  EXPECT_EQ(simplest_rational({Rational(3, 10), Rational(4, 10)}), Rational(1, 3));
  EXPECT_EQ(simplest_rational({Rational(-4, 10), Rational(-3, 10)}), Rational(-1, 3));
  EXPECT_EQ(simplest_rational({Rational(22, 10), Rational(51, 10)}), 3);
  EXPECT_EQ(simplest_rational({Rational(314, 100), Rational(315, 100)}), Rational(22, 7));
  EXPECT_EQ(simplest_rational({-1, 2}), 0);
  EXPECT_EQ(simplest_rational({Rational(7, 3), Rational(7, 3)}), Rational(7, 3));
}

TEST(Real_roots, refuses_the_zero_polynomial_and_can_be_stopped)
{
  EXPECT_THROW((void)isolate_real_roots({}), Invalid_input);
  int calls = 0;
  const Checkpoint stop = [&] {
    if (++calls > 3) throw Cancelled("enough");
  };
  EXPECT_THROW((void)isolate_real_roots(root_cases::wilkinson(20), stop), Cancelled);
}

TEST(Integer_polynomial, greatest_common_divisors_are_exact)
{
  std::mt19937_64 random(5);
  for (unsigned round = 0; round < 50; ++round) {
    const auto common = normalized(root_cases::random_polynomial(random, 1 + round % 6, 90));
    const auto p = multiply(common, root_cases::random_polynomial(random, 5, 200));
    const auto q = multiply(common, root_cases::random_polynomial(random, 7, 20));
    EXPECT_EQ(greatest_common_divisor(p, q), common) << round; // random cofactors are coprime
  }
}

TEST(Integer_polynomial, encloses_values_of_high_degree_with_rounding)
{
  std::vector<Integer> coefficients(200);
  for (std::size_t i = 0; i < coefficients.size(); ++i)
    coefficients[i] = Integer((static_cast<long>(i * i) % 1009 - 500)) * (Integer(1) << (i % 90)) + 1;
  const Integer_polynomial p(std::move(coefficients));
  for (const Rational& middle : {Rational(1, 3), Rational(-7, 5), Rational(13, 10), Rational(-100, 7)}) {
    Rational last_width = 0;
    for (unsigned digits = 10; digits <= 60; digits += 10) {
      Integer power;
      mpz_ui_pow_ui(power.get_mpz_t(), 10, digits);
      const Rational radius = Rational(1) / power;
      const auto enclosure = evaluate(p, Rational_interval(middle - radius, middle + radius));
      for (const Rational& x :
           {Rational(middle - radius), middle, Rational(middle + radius), Rational(middle + radius / 3)})
        EXPECT_TRUE(contains(enclosure, evaluate(p, x)));
      const Rational width = enclosure.upper() - enclosure.lower();
      if (digits > 10) {
        EXPECT_LT(width * 1000000, last_width); // ten digits more bring at least six
      }
      last_width = width;
    }
    // Negative control: a value outside of the interval is not in it.
    EXPECT_FALSE(contains(evaluate(p, Rational_interval(middle, middle + Rational(1) / (Integer(1) << 200))),
                          evaluate(p, Rational(middle + Rational(1, 1000)))));
  }
}

} // namespace
