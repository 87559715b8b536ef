// SPDX-License-Identifier: LGPL-3.0-or-later
#include "rounds.h"

#include <corral/audit/Trouble_source.h>
#include <corral/number/Outward_interval.h>
#include <corral/number/Rational_interval.h>
#include <corral/number/format.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using namespace corral;

TEST(Format, hex_floats_are_exact)
{
  EXPECT_EQ(to_hex_float(0), "0x0p+0");
  EXPECT_EQ(to_hex_float(1), "0x1p+0");
  EXPECT_EQ(to_hex_float(Rational(-3, 2)), "-0x1.8p+0");
  EXPECT_EQ(to_hex_float(Rational(0.1)), "0x1.999999999999ap-4");
  EXPECT_EQ(to_hex_float(Rational(5e-324)), "0x1p-1074");
  EXPECT_EQ(to_hex_float(std::numeric_limits<double>::max()), "0x1.fffffffffffffp+1023");
  Trouble_source random(8);
  for (int round = 0; round < test::rounds(1000); ++round)
    for (const auto end : {bracket(random.trouble()).below, bracket(random.trouble()).above})
      if (std::isfinite(end)) {
        EXPECT_EQ(parse_rational(to_hex_float(end)), Rational(end));
      }
}

TEST(Format, decimals_enclose)
{
  EXPECT_EQ(decimal_below(Rational(1, 3), 4), "0.3333");
  EXPECT_EQ(decimal_above(Rational(1, 3), 4), "0.3334");
  EXPECT_EQ(decimal_below(Rational(-1, 3), 4), "-0.3334");
  EXPECT_EQ(decimal_above(Rational(-1, 3), 4), "-0.3333");
  EXPECT_EQ(decimal_above(Rational(9999, 10), 3), "1000");
  EXPECT_EQ(decimal_below(Rational(5, 4), 10), "1.25");
  EXPECT_EQ(decimal_below(Rational(1, 1024), 3), "0.000976");
  EXPECT_EQ(decimal_above(parse_rational("1e30"), 3), "1e30");
  EXPECT_EQ(decimal_above(parse_rational("1.2341e-30"), 4), "1.235e-30");
  EXPECT_EQ(decimal_below(120, 1), "100");
  Trouble_source random(9);
  for (int round = 0; round < test::rounds(1000); ++round) {
    const Rational value = random.trouble();
    const int digits = static_cast<int>(random.integer(1, 40));
    const Rational below = parse_rational(decimal_below(value, digits));
    const Rational above = parse_rational(decimal_above(value, digits));
    EXPECT_LE(below, value);
    EXPECT_LE(value, above);
    EXPECT_LE((above - below) * parse_rational("1e" + std::to_string(digits - 1)), abs(value));
  }
}

TEST(Format, intervals)
{
  EXPECT_EQ(exact_text(Outward_interval(1, std::numeric_limits<double>::infinity())), "[0x1p+0, inf]");
  EXPECT_EQ(exact_text(Rational_interval(Rational(1, 3), 2)), "[1/3, 2]");
  EXPECT_EQ(decimal_text(enclose<Outward_interval>(Rational(1, 3)), 4), "[0.3333, 0.3334]");
}

} // namespace
