// SPDX-License-Identifier: LGPL-3.0-or-later
#include "rounds.h"

#include <corral/audit/Trouble_source.h>
#include <corral/errors.h>
#include <corral/number/Rational.h>

#include <gtest/gtest.h>

#include <string>

namespace {

using corral::Integer;
using corral::parse_rational;
using corral::Rational;
using corral::to_string;

TEST(Parse_rational, reads_every_kind_of_number_exactly)
{
  EXPECT_EQ(parse_rational("0"), 0);
  EXPECT_EQ(parse_rational("-0.000"), 0);
  EXPECT_EQ(parse_rational("+42"), 42);
  EXPECT_EQ(parse_rational("007"), 7);
  EXPECT_EQ(parse_rational("15/4"), Rational(15, 4));
  EXPECT_EQ(parse_rational("-6/4"), Rational(-3, 2));
  EXPECT_EQ(parse_rational("-1.5e-3"), Rational(-3, 2000));
  EXPECT_EQ(parse_rational(".5"), Rational(1, 2));
  EXPECT_EQ(parse_rational("5."), 5);
  EXPECT_EQ(parse_rational("1E2"), 100);
  EXPECT_EQ(parse_rational("1e+0002"), 100);
  EXPECT_EQ(parse_rational("0x1.8p-3"), Rational(3, 16));
  EXPECT_EQ(parse_rational("-0XfFp1"), -510);
  EXPECT_EQ(parse_rational("0x1p-1074"), Rational(5e-324));
  EXPECT_NE(parse_rational("0.1"), Rational(0.1)); // no double in between
}

TEST(Parse_rational, refuses_anything_else_and_says_where)
{
  const std::pair<const char*, std::size_t> bad[] = {{"", 0},       {"-", 1},          {"x", 0},
                                                     {"1x", 1},     {"1 ", 1},         {" 1", 0},
                                                     {".", 1},      {"1/0", 2},        {"1/00", 2},
                                                     {"1/", 2},     {"1/-2", 2},       {"1.5/2", 3},
                                                     {"1/2.5", 3},  {"1e", 2},         {"1e+", 3},
                                                     {"0x", 2},     {"0x1p", 4},       {"--1", 1},
                                                     {"inf", 0},    {"nan", 0},        {"1e100001", 2},
                                                     {"0x1e5/", 5}, {"1,5", 1},        {"\xff", 0},
                                                     {"1\n", 1},    {"0x1p400001", 4}, {"1e99999999999999999999", 2}};
  for (const auto& [text, position] : bad) try {
      (void)parse_rational(text);
      ADD_FAILURE() << text;
    } catch (const corral::Parse_error& error) {
      EXPECT_EQ(error.position, position) << text;
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
  EXPECT_THROW((void)parse_rational(std::string("1\0", 2)), corral::Parse_error);
  EXPECT_THROW((void)parse_rational(std::string(1000000, 'a')), corral::Parse_error);
}

TEST(Parse_rational, takes_long_numbers)
{
  const std::string digits(100000, '7');
  EXPECT_EQ(parse_rational(digits).get_num(), Integer(digits));
  EXPECT_EQ(parse_rational("0." + digits) * parse_rational("1e100000"), Integer(digits));
  EXPECT_EQ(to_string(parse_rational(digits + "/" + digits + "1")), digits + "/" + digits + "1");
  EXPECT_EQ(parse_rational("1e100000") * parse_rational("1e-100000"), 1);
}

TEST(Rational, text_gives_the_same_number_back)
{
  corral::Trouble_source random(7);
  for (int round = 0; round < corral::test::rounds(1000); ++round) {
    const Rational value = random.trouble();
    EXPECT_EQ(parse_rational(to_string(value)), value);
  }
}

} // namespace
