// SPDX-License-Identifier: LGPL-3.0-or-later
#include "seed_faults.h"

#include "fault_harness.h"

#include <utility>

namespace corral::audit {
namespace {

std::vector<Fault_finding> look_for_all(std::vector<Fault_finding> findings,
                                        const std::vector<std::vector<Planted_bounder>>& lists,
                                        const Audit_options& options, const Run_options& run)
{
  for (const auto& list : lists)
    for (const auto& bounder : list) findings.push_back(look_for(bounder, options, run));
  return findings;
}

} // namespace

std::vector<Fault_finding> seed_faults(const Audit_options& options, const Run_options& run)
{
  return look_for_all(seed_number_faults(options, run),
                      {expansion_faults(), memory_faults(), bernstein_faults(), method_faults(), taylor_form_faults()},
                      options, run);
}

std::vector<Fault_finding> seed_no_faults(const Audit_options& options, const Run_options& run)
{
  return look_for_all(seed_no_number_fault(options, run),
                      {sound_expansions(), sound_bernstein_forms(), sound_methods(), sound_taylor_forms()}, options,
                      run);
}

} // namespace corral::audit
