// SPDX-License-Identifier: LGPL-3.0-or-later
#include "../decision/check_witness.h"
#include "exact_values.h"

#include <algebra/Extension.h>
#include <algebra/Fibre.h>

#include <corral/number/Rational_interval.h>

#include <gtest/gtest.h>

#include <memory>

namespace {

using namespace corral;
using namespace corral::exact;

Real_root root_of(const Integer_polynomial& p, const Rational& lower, const Rational& upper)
{
  return {std::make_shared<const Integer_polynomial>(p), Rational_interval(lower, upper), 1};
}

/// The fields that the suite below runs over: the laws of a field, checked on products and inverses.
template <class Field>
void expect_field(const Field& field, const std::vector<typename Field::Element>& elements)
{
  for (const auto& a : elements) {
    EXPECT_EQ(field.multiply(a, Field::one()), a);
    auto nothing = a;
    Field::subtract(nothing, a);
    EXPECT_TRUE(nothing.empty());
    EXPECT_EQ(field.multiply(a, field.inverse(a)), Field::one());
    auto twice = Field::times(a, 2);
    Field::subtract(twice, a);
    EXPECT_EQ(twice, a);
    for (const auto& b : elements) {
      EXPECT_EQ(field.multiply(a, b), field.multiply(b, a));
      for (const auto& c : elements) { // a (b - c) = a b - a c
        auto difference = b;
        Field::subtract(difference, c);
        auto expanded = field.multiply(a, b);
        Field::subtract(expanded, field.multiply(a, c));
        EXPECT_EQ(field.multiply(a, difference), expanded);
      }
    }
  }
}

TEST(Extension, is_a_field_where_its_modulus_is_irreducible)
{
  const Extension field({-2, 0, 0, 1}, root_of({-2, 0, 0, 1}, 1, 2)); // the cube root of 2
  expect_field(field, {{3}, {0, 1}, {Rational(1, 3), -2}, {5, Rational(7, 2), Rational(-9, 11)}});
  EXPECT_EQ(field.reduce({0, 0, 0, 1}), Rational_coefficients{2});
  EXPECT_NE(field.reduce({0, 0, 0, 1}), Rational_coefficients{3}); // negative control
}

TEST(Extension, splits_its_modulus_by_the_factor_of_the_root)
{
  const Integer_polynomial product{6, 0, -5, 0, 1}; // (x^2 - 2) (x^2 - 3)
  const Extension field(product, root_of(product, Rational(7, 5), Rational(3, 2)));
  for (const Rational_coefficients& divisor : {Rational_coefficients{-2, 0, 1}, Rational_coefficients{-3, 0, 1}}) try {
      (void)field.inverse(divisor);
      ADD_FAILURE() << "a divisor of zero has an inverse";
    } catch (const Extension::Split& split) {
      EXPECT_EQ(split.factor, (Integer_polynomial{-2, 0, 1}));
    }
  EXPECT_EQ(irreducible_factor(field.alpha()), (Integer_polynomial{-2, 0, 1}));
}

TEST(Tower, is_a_field_over_a_field)
{
  const Extension base({-2, 0, 1}, root_of({-2, 0, 1}, 1, 2));
  const Tower field(base, {{-3}, {}, {1}}, Rational_interval(1, 2)); // y^2 = 3
  expect_field(field, {{{5}}, {{0, 1}}, {{}, {1}}, {{1, 2}, {Rational(3, 7), -4}}});
  EXPECT_EQ(field.multiply({{}, {1}}, {{}, {1}}), Extension_polynomial{{3}});
}

TEST(Tower, splits_by_the_factor_of_the_root)
{
  const Extension base({-2, 0, 1}, root_of({-2, 0, 1}, 1, 2));
  for (const bool is_positive : {true, false}) { // y^2 - 2 = (y - x) (y + x)
    const auto beta = is_positive ? Rational_interval(1, 2) : Rational_interval(-2, -1);
    const Tower field(base, {{-2}, {}, {1}}, beta);
    try {
      (void)field.inverse({{0, -1}, {1}});
      ADD_FAILURE() << "a divisor of zero has an inverse";
    } catch (const Tower::Split& split) {
      EXPECT_EQ(split.factor, (Extension_polynomial{{0, is_positive ? -1 : 1}, {1}}));
    }
  }
}

/// The point (sqrt 2, sqrt 3).
Triangular_zero<2> roots_of_2_and_3()
{
  Triangular_zero<2> point;
  point.order = {0, 1};
  point.chain = {parse_polynomial<2>("x^2 - 2", {"x", "y"}), parse_polynomial<2>("y^2 - 3", {"x", "y"})};
  point.box = {Rational_interval(1, 2), Rational_interval(1, 2)};
  return point;
}

TEST(Fibre, finds_the_zeros_above_a_point_and_proves_them)
{
  struct Case
  {
    const char* first;
    const char* second;
    Rational lower;
    Rational upper;
    bool has_zero;
  };
  // x*y is the root of 6, whose square root is 1.565.
  const std::vector<Case> cases = {
      {"z^2 - x*y", "z^2 - x*y", 1, 2, true},
      {"z^2 - x*y", "z^2 - x*y", 2, 3, false},
      {"z^2 - x*y", "z^2 - x*y", Rational(1565, 1000), Rational(1566, 1000), true},
      {"z^2 - x*y", "z^4 - 6", 1, 2, true},
      {"z^2 - x*y", "z^4 - 6 + x^2 - 2", 1, 2, true},
      {"z^2 - x*y", "z^2 - x - 1/1000000", 1, 2, false},
      {"(z - x)^3*(z - 9)", "(z - x)*(z - y)", 1, Rational(3, 2), true},
      {"(z - x)^3*(z - 9)", "(z - x)*(z - y)", Rational(3, 2), 2, false}, // y is a zero of the second alone
      {"x^2*z - 2*z", "(z - y)*(z + 5)", Rational(3, 2), 2, true},        // the first is zero above the point
  };
  for (const auto& given : cases) {
    SCOPED_TRACE(std::string(given.first) + ", " + given.second + " from " + given.lower.get_str());
    const std::vector<Polynomial<Integer, 3>> system{truth::space(given.first), truth::space(given.second)};
    const Rational_interval side(given.lower, given.upper);
    const auto zero = Fibre(roots_of_2_and_3()).zero_in(system, side, {});
    ASSERT_EQ(zero.has_value(), given.has_zero);
    if (!zero) continue;
    const Rational_box<3> box{Rational_interval(1, 2), Rational_interval(1, 2), side};
    for (const auto& f : system) EXPECT_EQ(check::complaint<3>(*zero, truth::over_rationals(f), box), "");
    // Negative control: the chain proves no zero of another polynomial.
    EXPECT_NE(check::complaint<3>(*zero, truth::over_rationals(truth::space("z - 17/12")), box), "");
  }
}

} // namespace
