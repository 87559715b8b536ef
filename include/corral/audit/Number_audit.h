// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_AUDIT_NUMBER_AUDIT_H
#define CORRAL_AUDIT_NUMBER_AUDIT_H

#include <cstdint>
#include <optional>
#include <string>

namespace corral {

/// A counterexample to the contract of `IntervalNumber`.
struct Number_fault
{
  std::uint64_t case_number = 0;
  std::string operation; ///< what went wrong, such as "sum"
  std::string text;      ///< the whole counterexample on several lines, every number exactly
};

/// What an audit of a number type saw.
struct Number_audit
{
  std::string number;
  std::uint64_t cases = 0;  ///< pairs of operands
  std::uint64_t checks = 0; ///< exact values looked for in results
  std::uint64_t faults = 0; ///< pairs of operands with a wrong result
  std::optional<Number_fault> first_fault;
  bool was_stopped = false; ///< before all cases were tried
};

} // namespace corral

#endif
