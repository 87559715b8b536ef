// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_TEST_BOUNDERS_CONFORMANCE_OF_ALL_H
#define CORRAL_TEST_BOUNDERS_CONFORMANCE_OF_ALL_H

#include "conformance/bounder_conformance.h"

#include <corral/bounders/all.h>

#include <gtest/gtest.h>

namespace corral::test {

template <class... B>
struct Escape_of
{
  static std::string find(std::uint64_t seed, int cases) { return find_escape<B...>(seed, cases); }
};

/// The suite for every bounder of the list over one number type, in dimensions 1 to 4.
///
/// 256 cases of 16 points for each bounder; CORRAL_TEST_MULTIPLIER=250 makes more than a million checks of each.
template <IntervalNumber I>
void check_all_bounders(std::uint64_t seed)
{
  EXPECT_EQ((Bounders::apply<Escape_of, I, 1>::find(seed, rounds(64))), "");
  EXPECT_EQ((Bounders::apply<Escape_of, I, 2>::find(seed + 1, rounds(64))), "");
  EXPECT_EQ((Bounders::apply<Escape_of, I, 3>::find(seed + 2, rounds(64))), "");
  EXPECT_EQ((Bounders::apply<Escape_of, I, 4>::find(seed + 3, rounds(64))), "");
}

} // namespace corral::test

#endif
