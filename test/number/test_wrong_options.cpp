// SPDX-License-Identifier: LGPL-3.0-or-later
// Compiled with options that break the arithmetic, to see that its guard notices.
#include <corral/errors.h>
#include <corral/number/Environment.h>

#include <gtest/gtest.h>

#include <string>

TEST(Environment_compiled_wrongly, is_refused)
{
#if defined __x86_64__
  if (__builtin_cpu_supports("fma") == 0) GTEST_SKIP() << "this processor cannot contract";
#endif
  const auto expected = corral::Environment_fault::CORRAL_EXPECTED_FAULT;
  EXPECT_EQ(corral::find_environment_fault(), expected);
  try {
    const corral::Nearest_scope scope;
    FAIL();
  } catch (const corral::Unsafe_environment& error) {
    EXPECT_NE(std::string(error.what()).find(corral::to_string(expected)), std::string::npos);
  }
}
