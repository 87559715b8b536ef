// SPDX-License-Identifier: LGPL-3.0-or-later
#include "rounds.h"

#include <corral/audit/audit_number.h>
#include <corral/number/all.h>

#include <gtest/gtest.h>

namespace {

using namespace corral;
using namespace corral::test;

/// The first counterexample to the contract of `IntervalNumber`, or "" if none was found.
template <IntervalNumber I>
std::string find_number_fault(std::uint64_t seed, int cases = rounds(1000))
{
  const auto audit = audit_number<I>({.seed = seed, .cases = static_cast<std::uint64_t>(cases)});
  return audit.first_fault ? audit.first_fault->text : "";
}

static_assert(IntervalNumber<Nearest_interval> && IntervalNumber<Outward_interval>);
static_assert(IntervalNumber<Rational_interval> && IntervalNumber<Counted<Outward_interval>>);
static_assert(!IntervalNumber<int> && !IntervalNumber<double> && !IntervalNumber<Rational>);
static_assert(!is_guaranteed<Nearest_interval> && is_guaranteed<Counted<Outward_interval>>);

TEST(Number_conformance, of_every_guaranteed_type_of_the_list)
{
  std::uint64_t seed = 1;
  Number_types::for_each([&]<class I>(std::type_identity<I>) {
    if (!is_guaranteed<I>) return;
    EXPECT_EQ(find_number_fault<I>(seed++), "") << Interval_traits<I>::name;
  });
}
TEST(Number_conformance, mpfr)
{
  for (const long bits : {53, 64, 113, 256, 1000, 4096}) {
    const Mpfr_precision_scope precision(bits);
    EXPECT_EQ(find_number_fault<Mpfr_interval>(6, rounds(300)), "") << bits << " bits";
  }
}
TEST(Number_conformance, counted_rational) { EXPECT_EQ(find_number_fault<Counted<Rational_interval>>(4), ""); }

TEST(Number_conformance, negative_control_nearest) { EXPECT_NE(find_number_fault<Nearest_interval>(5), ""); }

} // namespace
