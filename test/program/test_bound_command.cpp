// SPDX-License-Identifier: LGPL-3.0-or-later
#include "run_program.h"

#include <corral/bounders/all.h>
#include <corral/number/all.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace {

using namespace corral;
using namespace corral::test;
using Words = std::vector<std::string>;

// The end points that a line of the answer shows.
Rational_interval ends(const std::string& out, const std::string& label)
{
  const auto start = out.find('[', out.find(label)) + 1;
  const auto comma = out.find(", ", start);
  return {parse_rational(out.substr(start, comma - start)),
          parse_rational(out.substr(comma + 2, out.find(']', comma) - comma - 2))};
}

Program_run bound(Words more)
{
  more.insert(more.begin(), "bound");
  return run_program(more);
}

bool is_inside(const Rational_interval& a, const Rational_interval& b)
{
  return b.lower() <= a.lower() && a.upper() <= b.upper();
}

TEST(Bound_command, prints_the_interval_exactly_and_rounded_outward)
{
  const Program_run run = bound({"x^2 - 1/3", "--box", "0:1", "--number", "rational", "--bounder", "natural"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.out,
            "polynomial: x^2 - 1/3\nexact:   [-1/3, 2/3]\ndecimal: [-0.33333333333333334, 0.66666666666666667]\n");
  const Program_run hex = bound({"x + 1/2", "--box", "1:3", "--number", "double_outward", "--bounder", "horner"});
  EXPECT_NE(hex.out.find("0x"), std::string::npos) << hex.out;
  EXPECT_TRUE(is_inside({Rational(3, 2), Rational(7, 2)}, ends(hex.out, "exact:")));
  EXPECT_TRUE(is_inside(ends(hex.out, "exact:"), ends(hex.out, "decimal:")));
}

// f = x y - t / 7 + z over a box with a flat side: the range is exact, taken at corners.
TEST(Bound_command, encloses_with_every_bounder_and_number_type)
{
  Bounders::for_each<Rational_interval, 1>([](auto bounder) {
    Number_types::for_each([&]<class I>(std::type_identity<I>) {
      const Program_run run =
          bound({"x*y - t/7 + z", "--box", "0:1,1/3:1/3,-1:1,5:6", "--number", std::string(Interval_traits<I>::name),
                 "--bounder", std::string(decltype(bounder)::type::name)});
      ASSERT_EQ(run.exit_code, 0) << run.err;
      const Rational_interval range(Rational(5) - Rational(1, 3) - Rational(1, 7), Rational(6) + Rational(1, 3));
      const bool encloses = is_inside(range, ends(run.out, "exact:"));
      EXPECT_TRUE(encloses || !is_guaranteed<I>) << Interval_traits<I>::name << '\n' << run.out;
      EXPECT_TRUE(is_inside(ends(run.out, "exact:"), ends(run.out, "decimal:"))) << run.out;
      EXPECT_EQ(run.out.find("not guaranteed") != std::string::npos, !is_guaranteed<I>) << run.out;
    });
  });
}

TEST(Bound_command, takes_a_point_and_a_precision)
{
  const Words words{"x^3 - y", "--box", "1/3:1/3,0:0", "--number", "mpfr", "--precision", "1000"};
  const Rational_interval fine = ends(bound(words).out, "exact:");
  EXPECT_TRUE(is_inside(Rational_interval(Rational(1, 27)), fine));
  EXPECT_LT(fine.upper() - fine.lower(), parse_rational("1e-290"));
  EXPECT_GT(fine.upper(), fine.lower()); // 1/27 is no binary number
}

TEST(Bound_command, counts_where_asked)
{
  const std::string out = bound({"x^2 + x", "--box", "0:1", "--number", "counted"}).out;
  EXPECT_NE(out.find("counted: "), std::string::npos) << out;
}

TEST(List_command, names_every_bounder_and_number_type)
{
  std::istringstream lines(run_program({"list"}).out);
  std::vector<std::string> first;
  for (std::string line, word; std::getline(lines, line);)
    if (std::istringstream(line) >> word) first.push_back(word);
  const auto expect = [&](std::string_view name) {
    EXPECT_NE(std::find(first.begin(), first.end(), name), first.end()) << name;
  };
  Bounders::for_each<Rational_interval, 1>([&](auto bounder) { expect(decltype(bounder)::type::name); });
  Number_types::for_each([&]<class I>(std::type_identity<I>) { expect(Interval_traits<I>::name); });
}

} // namespace
