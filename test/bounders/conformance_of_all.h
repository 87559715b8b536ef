// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_TEST_BOUNDERS_CONFORMANCE_OF_ALL_H
#define CORRAL_TEST_BOUNDERS_CONFORMANCE_OF_ALL_H

#include "rounds.h"

#include <corral/audit/audit_bounder.h>
#include <corral/bounders/all.h>

#include <gtest/gtest.h>

namespace corral::test {

/// Every bounder of the list over one number type on generated cases; calls `check(audit)` with what came out.
template <IntervalNumber I, std::size_t D, class Check>
void audit_all_bounders(std::uint64_t seed, int cases, const Check& check)
{
  Bounders::for_each<I, D>([&](auto bounder) {
    using B = typename decltype(bounder)::type;
    check(audit_bounder<B>({.seed = seed, .cases = static_cast<std::uint64_t>(cases)}));
  });
}

/// As `audit_all_bounders`, for recursive Taylor expansion of the other orders.
template <IntervalNumber I, std::size_t D, class Check>
void audit_all_orders(std::uint64_t seed, int cases, const Check& check)
{
  for (const unsigned order : {1U, 3U, 4U})
    check(audit_bounder<I, D>(
        [order](const Polynomial<I, D>& f) { return Recursive_taylor_bounder<I, D>(f, {.order = order}); },
        {.seed = seed, .cases = static_cast<std::uint64_t>(cases)}));
}

/// Returns how many exact checks each bounder passed.
template <IntervalNumber I, std::size_t D>
std::uint64_t expect_no_escape(std::uint64_t seed, int cases)
{
  std::uint64_t checks = 0;
  const auto expect_none = [&](const Bounder_audit<D>& audit) {
    EXPECT_EQ(audit.escapes, 0U) << audit.bounder << " over " << audit.number << " lost a value\n"
                                 << to_string(audit.first_escape.value_or(Escape<D>()));
    checks = audit.checks;
  };
  audit_all_bounders<I, D>(seed, cases, expect_none);
  audit_all_orders<I, D>(seed, cases, expect_none);
  return checks;
}

/// \brief The suite for every bounder of the list over one number type, in dimensions 1 to 4.
///
/// Some 6000 exact checks of each bounder; CORRAL_TEST_MULTIPLIER=200 makes more than a million.
template <IntervalNumber I>
void check_all_bounders(std::uint64_t seed)
{
  const std::uint64_t checks = expect_no_escape<I, 1>(seed, rounds(32)) + expect_no_escape<I, 2>(seed, rounds(32))
                               + expect_no_escape<I, 3>(seed, rounds(32)) + expect_no_escape<I, 4>(seed, rounds(32));
  ::testing::Test::RecordProperty("checks_of_each_bounder", std::to_string(checks));
}

} // namespace corral::test

#endif
