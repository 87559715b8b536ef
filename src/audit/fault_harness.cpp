// SPDX-License-Identifier: LGPL-3.0-or-later
#include "fault_harness.h"

#include <corral/audit/audit_bounder.h>

namespace corral::audit {
namespace {

/// The exact coefficients behind point intervals.
Exact_polynomial without_intervals(const Polynomial<Rational_interval, 2>& f)
{
  return transform<Rational>(f, [](const Rational_interval& c) { return c.lower(); });
}

} // namespace

Fault_finding look_for(const Planted_bounder& bounder, const Audit_options& options)
{
  Audit_options until_first = options;
  until_first.stop_at_first = true;
  const auto audit = audit_bounder<Rational_interval, 2>(
      [&](const Polynomial<Rational_interval, 2>& f) { return bounder.make(without_intervals(f)); }, until_first);
  const bool caught = audit.first_escape.has_value();
  return {bounder.name, bounder.description, caught ? "bounder audit" : "", audit.cases, caught};
}

} // namespace corral::audit
