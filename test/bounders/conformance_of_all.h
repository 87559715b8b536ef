// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_TEST_BOUNDERS_CONFORMANCE_OF_ALL_H
#define CORRAL_TEST_BOUNDERS_CONFORMANCE_OF_ALL_H

#include "rounds.h"

#include <corral/bounders/all.h>
#include <corral/verification/audit_bounder.h>

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

template <IntervalNumber I, std::size_t D>
void expect_no_escape(std::uint64_t seed, int cases)
{
  audit_all_bounders<I, D>(seed, cases, [](const Bounder_audit<D>& audit) {
    EXPECT_EQ(audit.escapes, 0U) << audit.bounder << " over " << audit.number << " lost a value\n"
                                 << to_string(audit.first_escape.value_or(Escape<D>()));
  });
}

/// The suite for every bounder of the list over one number type, in dimensions 1 to 4.
template <IntervalNumber I>
void check_all_bounders(std::uint64_t seed)
{
  expect_no_escape<I, 1>(seed, rounds(32));
  expect_no_escape<I, 2>(seed, rounds(32));
  expect_no_escape<I, 3>(seed, rounds(32));
  expect_no_escape<I, 4>(seed, rounds(32));
}

} // namespace corral::test

#endif
