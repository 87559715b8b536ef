// SPDX-License-Identifier: LGPL-3.0-or-later
#include "seed_faults.h"

#include "fault_harness.h"

#include <utility>

namespace corral::audit {
namespace {

std::vector<Fault_finding> look_for_all(std::vector<Fault_finding> findings,
                                        const std::vector<std::vector<Planted_bounder>>& lists,
                                        const Audit_options& options)
{
  for (const auto& list : lists)
    for (const auto& bounder : list) findings.push_back(look_for(bounder, options));
  return findings;
}

} // namespace

std::vector<Fault_finding> seed_faults(const Audit_options& options)
{
  return look_for_all(seed_number_faults(options), {expansion_faults(), method_faults(), taylor_form_faults()},
                      options);
}

std::vector<Fault_finding> seed_no_faults(const Audit_options& options)
{
  return look_for_all(seed_no_number_fault(options), {sound_expansions(), sound_methods(), sound_taylor_forms()},
                      options);
}

} // namespace corral::audit
