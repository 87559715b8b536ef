// SPDX-License-Identifier: LGPL-3.0-or-later
#include "number_faults.h"

#include "fault_harness.h"

#include <corral/audit/audit_bounder.h>
#include <corral/audit/audit_number.h>
#include <corral/bounders/Mean_value_bounder.h>

namespace corral::audit {
namespace {

/// \brief Both audits over a number type; that of numbers is the one that counts the cases if both find the fault.
///
/// The bounder is the mean-value form, which uses every operation of the type.
template <class Fault>
Fault_finding look_for_number_fault(const Audit_options& options, const Run_options& run)
{
  using I = Faulty_interval<Fault>;
  Audit_options until_first = options;
  until_first.stop_at_first = true;
  const auto of_number = audit_number<I>(until_first, run);
  const auto of_bounder = audit_bounder<Mean_value_bounder<I, 2>>(until_first, run);
  Fault_finding finding{std::string(Fault::name), std::string(Fault::description), "", of_number.cases,
                        of_number.first_fault || of_bounder.first_escape};
  if (of_number.first_fault) finding.caught_by = "number audit (" + of_number.first_fault->operation + ")";
  if (of_bounder.first_escape) {
    finding.caught_by += finding.caught_by.empty()
                             ? "bounder audit of mean_value"
                             : ", bounder audit of mean_value after " + std::to_string(of_bounder.cases) + " cases";
    if (!of_number.first_fault) finding.cases = of_bounder.cases;
  }
  return finding;
}

template <class... Faults>
std::vector<Fault_finding> look_for_number_faults(const Audit_options& options, const Run_options& run)
{
  return {look_for_number_fault<Faults>(options, run)...};
}

} // namespace

std::vector<Fault_finding> seed_number_faults(const Audit_options& options, const Run_options& run)
{
  return look_for_number_faults<Sum_upper_rounded_down, Sum_lower_rounded_up, Difference_to_nearest,
                                Difference_of_like_ends, Product_upper_rounded_down, Product_lower_rounded_up,
                                Product_of_two_corners, Product_shrinks, Product_error_underflows, Square_loses_zero,
                                Square_keeps_order, No_outward_step, One_end_stepped, Step_by_a_factor, Flush_to_zero,
                                Overflow_saturates, Hull_drops_an_end, Enclose_to_nearest, Enclose_subnormals_as_zero>(
      options, run);
}

std::vector<Fault_finding> seed_no_number_fault(const Audit_options& options, const Run_options& run)
{
  return look_for_number_faults<No_fault>(options, run);
}

} // namespace corral::audit
