// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_AUDIT_AUDIT_OPTIONS_H
#define CORRAL_AUDIT_AUDIT_OPTIONS_H

#include <cstdint>

namespace corral {

/// Among which cases an audit looks for a counterexample.
struct Audit_options
{
  std::uint64_t seed = 1;
  /// The number of the first case. A case follows from the seed and its number alone, so that the case of an escape can
  /// be replayed without those before it.
  std::uint64_t first_case = 0;
  std::uint64_t cases = 1000;
  std::uint64_t tightness_cases = 0; ///< boxes on which bounds are compared with the exact range (D <= 3)
  bool stop_at_first = false;        ///< end with the first case that shows a fault
};

} // namespace corral

#endif
