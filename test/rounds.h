// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_TEST_ROUNDS_H
#define CORRAL_TEST_ROUNDS_H

#include <algorithm>
#include <cstdlib>

namespace corral::test {

/// `base` rounds, times the environment variable CORRAL_TEST_MULTIPLIER.
inline int rounds(int base)
{
  const char* multiplier = std::getenv("CORRAL_TEST_MULTIPLIER");
  return base * std::max(1, multiplier == nullptr ? 1 : std::atoi(multiplier));
}

} // namespace corral::test

#endif
