// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_AUDIT_AUDIT_NUMBER_H
#define CORRAL_AUDIT_AUDIT_NUMBER_H

#include <corral/Run_options.h>
#include <corral/audit/Audit_options.h>
#include <corral/audit/Number_audit.h>
#include <corral/internal/audit/Number_case.h>
#include <corral/number/Interval_number.h>

#include <cstdint>
#include <string>

namespace corral {

/// \brief The contract of `IntervalNumber`, checked with exact rationals: there is no tolerance, a miss is a fault.
///
/// `tightness_cases` of the options is not used. \throw Unsafe_environment as the scope of the type.
template <IntervalNumber I>
[[nodiscard]] Number_audit audit_number(const Audit_options& options = {}, const Run_options& run = {})
{
  const Arithmetic_scope<I> scope;
  Number_audit audit{std::string(Interval_traits<I>::name), 0, 0, 0, {}, false};
  for (std::uint64_t i = 0; i < options.cases; ++i) {
    if (run.progress) run.progress(static_cast<double>(i) / static_cast<double>(options.cases));
    audit.was_stopped = run.stop.stop_requested();
    if (audit.was_stopped) break;
    const detail::Number_case<I> example(options.seed, options.first_case + i);
    ++audit.cases;
    audit.checks += example.checks();
    if (!example.fault()) continue;
    ++audit.faults;
    if (!audit.first_fault) audit.first_fault = example.fault();
    if (options.stop_at_first) break;
  }
  return audit;
}

} // namespace corral

#endif
