// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/errors.h>
#include <corral/number/Mpfr_interval.h>
#include <corral/number/format.h>

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace {

using namespace corral;

TEST(Mpfr_interval, has_the_precision_of_the_scope)
{
  EXPECT_EQ(Mpfr_interval(1).precision(), 128);
  const Rational third(1, 3);
  for (const long bits : {53, 64, 113, 256, 1000, 4096}) {
    const Mpfr_precision_scope scope(bits);
    const auto x = enclose<Mpfr_interval>(third);
    EXPECT_EQ(x.precision(), bits);
    const Rational width = *exact_upper(x) - *exact_lower(x);
    EXPECT_EQ(width, parse_rational("0x1p" + std::to_string(-bits - 1))); // one unit in the last place
    EXPECT_TRUE(contains(x, third));
  }
  EXPECT_EQ(Mpfr_interval(1).precision(), 128);
}

TEST(Mpfr_interval, restores_the_precision_around_exceptions)
{
  const Mpfr_precision_scope outer(200);
  try {
    const Mpfr_precision_scope inner(300);
    throw std::runtime_error("stop");
  } catch (const std::runtime_error&) {
  }
  EXPECT_EQ(Mpfr_precision_scope::bits(), 200);
  EXPECT_THROW(Mpfr_precision_scope(52), Invalid_input);
  EXPECT_THROW(Mpfr_precision_scope(-1), Invalid_input);
  EXPECT_THROW(Mpfr_precision_scope(1L << 40), Invalid_input);
  EXPECT_EQ(Mpfr_precision_scope::bits(), 200);
}

TEST(Mpfr_interval, results_have_the_greater_precision)
{
  const Mpfr_interval coarse = enclose<Mpfr_interval>(Rational(1, 3));
  const Mpfr_precision_scope scope(300);
  const Mpfr_interval fine = enclose<Mpfr_interval>(Rational(1, 7));
  EXPECT_EQ((coarse + fine).precision(), 300);
  EXPECT_EQ((fine * coarse).precision(), 300);
  EXPECT_EQ(hull(coarse, fine).precision(), 300);
  Mpfr_interval x = coarse;
  EXPECT_EQ((x -= fine).precision(), 300);
  EXPECT_TRUE(contains(x, Rational(4, 21)));
  std::thread([&] { EXPECT_EQ((fine * Mpfr_interval(3)).precision(), 300); }).join();
}

TEST(Mpfr_interval, copies_and_moves)
{
  std::vector<Mpfr_interval> values;
  for (int i = 0; i < 20; ++i) values.push_back(Mpfr_interval(i));
  Mpfr_interval moved = std::move(values[7]);
  values[7] = Mpfr_interval(70);
  values[8] = values[7];
  const auto& self = values[8];
  values[8] = self;
  EXPECT_TRUE(contains(moved, 7) && contains(values[7], 70) && contains(values[8], 70) && contains(values[19], 19));
}

TEST(Mpfr_interval, converts_huge_and_tiny_rationals)
{
  for (const char* text : {"1e100000", "-1e100000", "1e-100000", "-3.7e-99999", "0x1.8p400000"}) {
    const Rational value = parse_rational(text);
    const auto x = enclose<Mpfr_interval>(value);
    EXPECT_TRUE(contains(x, value)) << text;
    EXPECT_TRUE(contains(square(x), value * value)) << text;
    EXPECT_EQ(parse_rational(to_hex_float(*exact_lower(x))), *exact_lower(x));
  }
}

TEST(Mpfr_interval, encloses_beyond_its_own_range)
{
  Mpfr_interval huge = enclose<Mpfr_interval>(parse_rational("0x1p400000"));
  for (int i = 0; i < 13; ++i) huge = square(huge);
  EXPECT_FALSE(exact_upper(huge).has_value());
  EXPECT_EQ(strict_sign(huge), 1);
  EXPECT_EQ(strict_sign(huge * Mpfr_interval(0)), 0);
  EXPECT_EQ(strict_sign(huge - huge), 0);
  Mpfr_interval tiny = enclose<Mpfr_interval>(parse_rational("-0x1p-400000"));
  for (int i = 0; i < 13; ++i) tiny *= tiny;
  EXPECT_EQ(Interval_traits<Mpfr_interval>::lower_sign(tiny), 0);
  EXPECT_EQ(Interval_traits<Mpfr_interval>::upper_sign(tiny), 1);
}

TEST(Mpfr_interval, scope_widens_a_narrowed_range_and_restores_it)
{
  const auto least = mpfr_get_emin();
  const auto greatest = mpfr_get_emax();
  mpfr_set_emin(-1073); // the range of doubles, as some programs emulate it
  mpfr_set_emax(1024);
  try {
    const Arithmetic_scope<Mpfr_interval> scope;
    const auto x = enclose<Mpfr_interval>(parse_rational("1e-1000"));
    EXPECT_EQ(strict_sign(x * x), 1);
    throw std::runtime_error("stop");
  } catch (const std::runtime_error&) {
  }
  EXPECT_EQ(mpfr_get_emin(), -1073);
  EXPECT_EQ(mpfr_get_emax(), 1024);
  mpfr_set_emin(least);
  mpfr_set_emax(greatest);
}

} // namespace
