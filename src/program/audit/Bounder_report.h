// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_PROGRAM_AUDIT_BOUNDER_REPORT_H
#define CORRAL_SRC_PROGRAM_AUDIT_BOUNDER_REPORT_H

#include "../../audit/seed_faults.h"
#include "Method_audit.h"

#include <ostream>
#include <string>
#include <utility>
#include <vector>

/// \file
/// What `corral audit bounders` says, in three forms.
namespace corral::program {

/// All that an audit of bounders saw.
struct Bounder_report
{
  Audit_settings settings;
  std::vector<Method_audit> audits;
  std::vector<audit::Fault_finding> faults; ///< empty if none were planted
};

/// A number type and all its audits.
struct Number_summary
{
  std::string number;
  bool is_guaranteed = false;
  std::uint64_t cases = 0;
  std::uint64_t checks = 0;
  std::uint64_t escapes = 0;
  const Method_audit* shortest = nullptr; ///< of those with a counterexample, the one with the shortest
};

/// How tight one bounder is in one dimension.
struct Tightness
{
  double median = 0;
  double worst = 0;
  std::size_t samples = 0;
};

/// In the order of the settings.
[[nodiscard]] std::vector<Number_summary> summaries(const Bounder_report& report);

/// `passes`, `FAILS` or, where nothing is promised, `not guaranteed: fails` or `not guaranteed: no fault seen`.
[[nodiscard]] std::string verdict(const Number_summary& summary);

/// Whether no type that is guaranteed fails, and every planted fault was caught.
[[nodiscard]] bool is_sound(const Bounder_report& report);

/// \brief The audits that show the tightness of the methods themselves: those over exact numbers if there are any, else
/// those over the first guaranteed type, else all over the first type.
[[nodiscard]] std::vector<const Method_audit*> audits_for_tightness(const Bounder_report& report);

/// Median and worst ratio; zeros where there is no sample.
[[nodiscard]] Tightness tightness_of(const Method_audit& audit);

/// The program, its compiler and libraries, and the machine: names and values.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> environment();

void write_bounder_text(std::ostream& out, const Bounder_report& report);
void write_bounder_json(std::ostream& out, const Bounder_report& report);

/// One file with plots.
void write_bounder_html(std::ostream& out, const Bounder_report& report);

} // namespace corral::program

#endif
