// SPDX-License-Identifier: LGPL-3.0-or-later
#include "rounds.h"

#include <corral/audit/Trouble_source.h>
#include <corral/number/Cgal_interval.h>
#include <corral/number/Nearest_interval.h>
#include <corral/number/Outward_interval.h>
#include <corral/number/format.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace {

using namespace corral;
using test::rounds;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = std::numeric_limits<double>::denorm_min();

/// Whether `x` is the smallest interval of doubles that contains `exact`.
template <class I>
bool is_tightest(const I& x, const Rational_interval& exact)
{
  return x.lower() == bracket(exact.lower()).below && x.upper() == bracket(exact.upper()).above;
}

/// The first operation that is not rounded correctly, or "". Correct rounding implies inclusion, and that exact
/// operations stay exact.
template <class I>
std::string find_looseness(std::uint64_t seed, int number_of_rounds)
{
  const Arithmetic_scope<I> scope;
  Trouble_source random(seed);
  const auto operand = [&random] {
    for (;;)
      if (const auto x = random.interval(); std::isfinite(enclose<I>(x.lower(), x.upper()).lower())
                                            && std::isfinite(enclose<I>(x.lower(), x.upper()).upper()))
        return enclose<I>(x.lower(), x.upper());
  };
  for (int round = 0; round < number_of_rounds; ++round) {
    const I x = operand();
    const I y = operand();
    const Rational_interval exact_x(x.lower(), x.upper());
    const Rational_interval exact_y(y.lower(), y.upper());
    const char* wrong = !is_tightest<I>(x + y, exact_x + exact_y)     ? "sum"
                        : !is_tightest<I>(x - y, exact_x - exact_y)   ? "difference"
                        : !is_tightest<I>(x * y, exact_x * exact_y)   ? "product"
                        : !is_tightest<I>(square(x), square(exact_x)) ? "square"
                                                                      : nullptr;
    if (wrong != nullptr) return wrong + (": x = " + exact_text(x)) + ", y = " + exact_text(y);
  }
  return "";
}

TEST(Double_interval, outward_operations_are_correctly_rounded)
{
  EXPECT_EQ(find_looseness<Outward_interval>(11, rounds(20000)), "");
}
TEST(Double_interval, cgal_operations_are_correctly_rounded)
{
  EXPECT_EQ(find_looseness<Cgal_interval>(12, rounds(5000)), "");
}
TEST(Double_interval, negative_control_nearest_is_not_rounded_outward)
{
  EXPECT_NE(find_looseness<Nearest_interval>(13, 100), "");
}

TEST(Double_interval, ends_of_the_range)
{
  using I = Outward_interval;
  const auto is = [](const I& x, double low, double high) { return x.lower() == low && x.upper() == high; };
  EXPECT_TRUE(is(I(largest) + I(largest), largest, infinity));
  EXPECT_TRUE(is(I(-largest) - I(largest), -infinity, -largest));
  EXPECT_TRUE(is(I(largest) * I(2), largest, infinity));
  EXPECT_TRUE(is(I(largest) * I(-2), -infinity, -largest));
  EXPECT_TRUE(is(I(largest) + I(smallest), largest, infinity));
  EXPECT_TRUE(is(I(-largest) - I(smallest), -infinity, -largest));
  EXPECT_TRUE(is(I(largest) - I(smallest), std::nextafter(largest, 0), largest));
  EXPECT_TRUE(is(I(smallest) * I(0.5), 0, smallest));
  EXPECT_TRUE(is(I(-smallest) * I(0.5), -smallest, 0));
  EXPECT_TRUE(is(I(smallest) * I(smallest), 0, smallest));
  EXPECT_TRUE(is(square(I(-smallest, smallest)), 0, smallest));
  EXPECT_TRUE(is(I(0x1p-1060) * I(0x1p-14), smallest, smallest));       // exact
  EXPECT_TRUE(is(I(0x1p-1060) * I(0x1p-15), 0, smallest));              // a tie
  EXPECT_TRUE(is(I(0x1.8p-1060) * I(0x1p-14), smallest, 2 * smallest)); // a tie, not to zero
  EXPECT_TRUE(is(I(0) * I(-infinity, infinity), 0, 0));
  EXPECT_TRUE(is(I(0, 1) * I(-infinity, infinity), -infinity, infinity));
  EXPECT_TRUE(is(I(-infinity, -2) * I(3, infinity), -infinity, -6));
  EXPECT_TRUE(is(I(-infinity, 1) + I(2, infinity), -infinity, infinity));
  EXPECT_TRUE(is(square(I(-infinity, -2)), 4, infinity));
  EXPECT_TRUE(is(I(-0.0) * I(5), 0, 0));
  EXPECT_TRUE(is(I(0.1) + I(0), 0.1, 0.1));
  EXPECT_TRUE(is(I(0.1) * I(-8), -0.8, -0.8));
}

TEST(Bracket, surrounds_every_rational)
{
  EXPECT_EQ(bracket(Rational(1, 3)).below, 0x1.5555555555555p-2);
  EXPECT_EQ(bracket(Rational(1, 3)).above, 0x1.5555555555556p-2);
  const Rational half_of_smallest = Rational(smallest) / 2;
  EXPECT_EQ(bracket(half_of_smallest).nearest, 0); // a tie, to even
  EXPECT_EQ(bracket(half_of_smallest * 3).nearest, 2 * smallest);
  EXPECT_EQ(bracket(Rational(largest) + 1).below, largest);
  EXPECT_EQ(bracket(Rational(largest) + 1).nearest, largest);
  EXPECT_EQ(bracket(parse_rational("0x1p1024")).below, largest);
  EXPECT_EQ(bracket(parse_rational("-0x1p1024")).nearest, -infinity);
  EXPECT_EQ(bracket(parse_rational("-1e-100000")).below, -smallest);
  EXPECT_EQ(bracket(parse_rational("1e100000")).above, infinity);
  Trouble_source random(14);
  for (int round = 0; round < rounds(5000); ++round) {
    const Rational value = random.trouble();
    const auto doubles = bracket(value);
    EXPECT_TRUE(std::isinf(doubles.below) || Rational(doubles.below) <= value) << value;
    EXPECT_TRUE(std::isinf(doubles.above) || value <= Rational(doubles.above)) << value;
    const bool exact = std::isfinite(doubles.below) && Rational(doubles.below) == value;
    EXPECT_EQ(doubles.above, exact ? doubles.below : std::nextafter(doubles.below, infinity)) << value;
    if (std::isfinite(doubles.below) && std::isfinite(doubles.above)) {
      EXPECT_EQ(doubles.nearest == doubles.below || doubles.nearest == doubles.above, true) << value;
      EXPECT_LE(abs(value - Rational(doubles.nearest)) * 2, Rational(doubles.above) - Rational(doubles.below)) << value;
    }
  }
}

TEST(Bracket, does_not_depend_on_the_rounding_mode)
{
  const Cgal_scope upward;
  const auto third = bracket(Rational(1, 3));
  EXPECT_EQ(third.below, 0x1.5555555555555p-2);
  EXPECT_EQ(third.above, 0x1.5555555555556p-2);
  EXPECT_EQ(bracket(Rational(smallest) / 3).below, 0);
}

} // namespace
