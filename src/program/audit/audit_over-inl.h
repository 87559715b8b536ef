// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_PROGRAM_AUDIT_AUDIT_OVER_INL_H
#define CORRAL_SRC_PROGRAM_AUDIT_AUDIT_OVER_INL_H

#include "../Progress.h"
#include "../bound/make_bounder.h"
#include "Method_audit.h"
#include "Paper_subjects.h"

namespace corral::program {

/// Adds what an audit of one kind of cases saw.
template <std::size_t D, class Origin>
void add(const Bounder_audit<D>& seen, const Origin& origin, Method_audit& audit)
{
  audit.cases += seen.cases;
  audit.checks += seen.checks;
  audit.escapes += seen.escapes;
  audit.tightness.insert(audit.tightness.end(), seen.tightness.begin(), seen.tightness.end());
  if (seen.first_escape && !audit.first_escape)
    audit.first_escape = counterexample(*seen.first_escape, audit, origin(seen.first_escape->case_number));
}

template <IntervalNumber I, std::size_t D>
[[nodiscard]] Method_audit audit_method(const Method& method, const Audit_settings& settings, const Run_options& run)
{
  Method_audit audit;
  audit.method = method;
  audit.has_order = has_order(method.bounder);
  audit.is_guaranteed = is_guaranteed<I>;
  audit.dimension = D;
  const auto make = [&](const Polynomial<I, D>& f) { return make_bounder<I, D>(method, f); };
  const auto seed = " of seed " + std::to_string(settings.seed);
  const double share = settings.paper_cases > 0 && D > 1 ? 0.7 : 1;
  Audit_options options;
  options.seed = settings.seed;
  options.cases = settings.cases;
  options.tightness_cases = settings.tightness_cases;
  add(
      audit_bounder<I, D>(make, options, part_of(run, 0, share)),
      [&](std::uint64_t number) { return "generated case " + std::to_string(number) + seed; }, audit);
  const auto paper = paper_subjects<D>();
  if (!paper.subjects.empty() && settings.paper_cases > 0) {
    options.cases = settings.paper_cases;
    options.tightness_cases = 0;
    add(
        audit_bounder<I, D>(make, std::span<const Audit_subject<D>>(paper.subjects), options,
                            part_of(run, share, 1 - share)),
        [&](std::uint64_t number) {
          return "the paper's example " + std::to_string(paper.numbers[number % paper.numbers.size()]) + ", case "
                 + std::to_string(number) + seed;
        },
        audit);
  }
  corral::detail::report_or_throw(run, 1, "audit bounders");
  return audit;
}

template <IntervalNumber I>
std::vector<Method_audit> audit_over(const Audit_settings& settings, const Run_options& run)
{
  const auto methods = methods_over(settings, std::string(Interval_traits<I>::name));
  const double total = static_cast<double>(methods.size() * settings.dimensions.size());
  std::vector<Method_audit> audits;
  const auto next = [&] { return part_of(run, static_cast<double>(audits.size()) / total, 1 / total); };
  for (const std::size_t dimension : settings.dimensions)
    for (const Method& method : methods)
      audits.push_back(dimension == 1   ? audit_method<I, 1>(method, settings, next())
                       : dimension == 2 ? audit_method<I, 2>(method, settings, next())
                                        : audit_method<I, 3>(method, settings, next()));
  return audits;
}

} // namespace corral::program

#define CORRAL_INSTANTIATE_AUDIT(I)                                                                                    \
  template std::vector<Method_audit> audit_over<I>(const Audit_settings&, const Run_options&);

#endif
