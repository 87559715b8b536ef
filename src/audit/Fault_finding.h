// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_AUDIT_FAULT_FINDING_H
#define CORRAL_AUDIT_FAULT_FINDING_H

#include <cstdint>
#include <string>

namespace corral::audit {

/// What became of one planted fault.
struct Fault_finding
{
  std::string fault;       ///< its name
  std::string description; ///< what is wrong, in one line
  std::string caught_by;   ///< which audit found it, and where; empty if none did
  std::uint64_t cases = 0; ///< how many cases that audit took, the one that showed the fault included; all if none did
  bool caught = false;
};

} // namespace corral::audit

#endif
