// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/algebra/exact_range.h>
#include <corral/errors.h>
#include <corral/polynomial/evaluate.h>
#include <corral/polynomial/parse.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace corral;

const Rational fine(1, 1000000);

/// Why `range` is not the range [low, high] up to `fine`, or "".
std::string complaint(const Range_enclosure& range, const Rational& low, const Rational& high)
{
  if (range.outer.lower() > low || range.outer.upper() < high) return "outer lost a value";
  if (range.inner.lower() < low || range.inner.upper() > high) return "inner has a value that is not taken";
  if (range.outer.lower() < low - fine || range.outer.upper() > high + fine) return "outer is too wide";
  if (range.inner.lower() > low + fine || range.inner.upper() < high - fine) return "inner is too narrow";
  return "";
}

TEST(Exact_range, is_known_in_one_variable)
{
  const auto f = parse_polynomial<1>("x^3-3*x", {"x"});
  EXPECT_EQ(complaint(exact_range<1>(f, {Rational_interval(-2, 2)}, fine), -2, 2), "");
  EXPECT_EQ(complaint(exact_range<1>(f, {Rational_interval(0, 1)}, fine), -2, 0), "");
  EXPECT_EQ(
      complaint(exact_range<1>(f, {Rational_interval(Rational(1, 3))}, fine), Rational(-26, 27), Rational(-26, 27)),
      "");
  const auto bump = parse_polynomial<1>("1/3*(x^2-2)^2", {"x"}); // its minimum is taken at an irrational place
  EXPECT_EQ(complaint(exact_range<1>(bump, {Rational_interval(0, 3)}, fine), 0, Rational(49, 3)), "");
  EXPECT_EQ(complaint(exact_range<1>(parse_polynomial<1>("7/5", {"x"}), {Rational_interval(0, 3)}, fine),
                      Rational(7, 5), Rational(7, 5)),
            "");
  EXPECT_NE(complaint(exact_range<1>(f, {Rational_interval(-2, 2)}, fine), -2, Rational(21, 10)),
            ""); // negative control
}

TEST(Exact_range, is_known_in_two_and_three_variables)
{
  const Rational_interval side(-1, 2);
  const auto hill = parse_polynomial<2>("1-(3*x-1)^2-(y^2-2)^2", {"x", "y"});
  EXPECT_EQ(complaint(exact_range<2>(hill, {side, side}, fine), -28, 1), "");
  const auto saddle = parse_polynomial<3>("x*y-z^2", {"x", "y", "z"});
  EXPECT_EQ(complaint(exact_range<3>(saddle, {side, side, side}, fine), -6, 4), "");
  EXPECT_EQ(complaint(exact_range<3>(saddle, {Rational_interval(1), side, Rational_interval(Rational(1, 2))}, fine),
                      Rational(-5, 4), Rational(7, 4)),
            "");
}

TEST(Exact_range, contains_sampled_values_and_is_reached)
{
  std::mt19937_64 random(23);
  for (int round = 0; round < 20; ++round) {
    std::vector<Polynomial<Rational, 2>::Term> terms;
    for (std::uint16_t i = 0; i <= 3; ++i)
      for (std::uint16_t j = 0; j <= 3; ++j) {
        Rational c(static_cast<long>(random() % 2001) - 1000, 997);
        c.canonicalize();
        terms.push_back({{i, j}, c});
      }
    const auto f = collect<Rational, 2>(std::move(terms));
    const Rational_interval side(Rational(-2, 3), Rational(1, 2));
    const auto range = exact_range<2>(f, {side, side}, Rational(1, 100));
    EXPECT_LE(range.outer.upper() - range.inner.upper(), Rational(1, 100));
    EXPECT_LE(range.inner.lower() - range.outer.lower(), Rational(1, 100));
    for (int sample = 0; sample < 50; ++sample) {
      const auto coordinate = [&] {
        Rational t(static_cast<unsigned long>(random() % 1001), 1000UL);
        t.canonicalize();
        return Rational(side.lower() + (side.upper() - side.lower()) * t);
      };
      EXPECT_TRUE(contains(range.outer, evaluate(f, {coordinate(), coordinate()})));
    }
  }
}

TEST(Exact_range, refuses_a_tolerance_that_is_not_positive)
{
  EXPECT_THROW((void)exact_range<1>(parse_polynomial<1>("x", {"x"}), {Rational_interval(0, 1)}, 0), Invalid_input);
}

} // namespace
