// SPDX-License-Identifier: LGPL-3.0-or-later
#include "audit/seed_faults.h"

#include "rounds.h"

#include <gtest/gtest.h>

#include <set>

namespace {

using namespace corral;
using namespace corral::audit;

/// What doc/audit.md promises of any seed.
constexpr std::uint64_t most_cases = 200;

TEST(Seed_faults, every_fault_is_found)
{
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const auto findings = seed_faults({.seed = seed, .cases = most_cases});
    EXPECT_GE(findings.size(), 25U);
    std::set<std::string> names;
    for (const auto& finding : findings) {
      EXPECT_TRUE(finding.caught) << finding.fault << ", seed " << seed << ": " << finding.description;
      EXPECT_TRUE(names.insert(finding.fault).second) << finding.fault << " is in the list twice";
    }
  }
}

TEST(Seed_faults, nothing_is_found_in_the_originals)
{
  const auto findings = seed_no_faults({.cases = static_cast<std::uint64_t>(test::rounds(300))});
  EXPECT_GE(findings.size(), 5U);
  for (const auto& finding : findings) EXPECT_FALSE(finding.caught) << finding.fault << ": " << finding.caught_by;
}

} // namespace
