// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Bounder_report.h"

#include <algorithm>
#include <gmp.h>
#include <iomanip>
#include <mpfr.h>
#include <nlohmann/json.hpp>
#include <sstream>
#include <sys/utsname.h>

namespace corral::program {

std::vector<Number_summary> summaries(const Bounder_report& report)
{
  std::vector<Number_summary> result;
  for (const Method_audit& audit : report.audits) {
    if (result.empty() || result.back().number != audit.method.number)
      result.push_back({audit.method.number, audit.is_guaranteed, 0, 0, 0, nullptr});
    Number_summary& summary = result.back();
    summary.cases += audit.cases;
    summary.checks += audit.checks;
    summary.escapes += audit.escapes;
    const auto length = [](const Method_audit& a) { return a.first_escape->command.size(); };
    if (audit.first_escape && (summary.shortest == nullptr || length(audit) < length(*summary.shortest)))
      summary.shortest = &audit;
  }
  return result;
}

std::string verdict(const Number_summary& summary)
{
  if (summary.is_guaranteed) return summary.escapes == 0 ? "passes" : "FAILS";
  return summary.escapes == 0 ? "not guaranteed: no fault seen" : "not guaranteed: fails";
}

bool is_sound(const Bounder_report& report)
{
  return std::all_of(report.audits.begin(), report.audits.end(),
                     [](const Method_audit& audit) { return !audit.is_guaranteed || audit.escapes == 0; })
         && std::all_of(report.faults.begin(), report.faults.end(),
                        [](const audit::Fault_finding& fault) { return fault.caught; });
}

std::vector<const Method_audit*> audits_for_tightness(const Bounder_report& report)
{
  if (report.audits.empty()) return {};
  std::string number = report.audits.front().method.number;
  for (const Method_audit& audit : report.audits)
    if (audit.is_guaranteed) {
      number = audit.method.number;
      break;
    }
  const auto& numbers = report.settings.numbers;
  if (std::find(numbers.begin(), numbers.end(), "rational") != numbers.end()) number = "rational";
  std::vector<const Method_audit*> result;
  for (const Method_audit& audit : report.audits)
    if (audit.method.number == number) result.push_back(&audit);
  return result;
}

Tightness tightness_of(const Method_audit& audit)
{
  std::vector<double> ratios;
  for (const auto& sample : audit.tightness) ratios.push_back(sample.ratio);
  if (ratios.empty()) return {};
  std::sort(ratios.begin(), ratios.end());
  const std::size_t half = ratios.size() / 2;
  const double median = ratios.size() % 2 == 1 ? ratios[half] : (ratios[half - 1] + ratios[half]) / 2;
  return {median, ratios.back(), ratios.size()};
}

std::vector<std::pair<std::string, std::string>> environment()
{
  utsname machine{};
  const bool is_known = ::uname(&machine) == 0;
  return {
      {"program", "corral " CORRAL_VERSION},
      {"compiler",
#ifdef __clang__
       "clang " __clang_version__
#else
       "g++ " __VERSION__
#endif
      },
      {"gmp", gmp_version},
      {"mpfr", mpfr_get_version()},
      {"system", is_known ? std::string(machine.sysname) + ' ' + machine.release + ' ' + machine.machine : "unknown"}};
}

namespace {

std::string ratio_text(double ratio)
{
  std::ostringstream text;
  text << std::setprecision(ratio < 10 ? 4 : 3) << std::fixed;
  if (ratio >= 1e5) text.unsetf(std::ios::fixed);
  if (ratio >= 10) text << std::setprecision(3);
  text << ratio;
  return text.str();
}

void write_numbers(std::ostream& out, const Bounder_report& report)
{
  out << std::left << std::setw(16) << "number type" << std::right << std::setw(10) << "cases" << std::setw(12)
      << "checks" << std::setw(10) << "escapes"
      << "  verdict\n";
  for (const Number_summary& summary : summaries(report))
    out << std::left << std::setw(16) << summary.number << std::right << std::setw(10) << summary.cases << std::setw(12)
        << summary.checks << std::setw(10) << summary.escapes << "  " << verdict(summary) << '\n';
}

void write_counterexamples(std::ostream& out, const Bounder_report& report)
{
  for (const Number_summary& summary : summaries(report)) {
    if (summary.shortest == nullptr) continue;
    const Counterexample& example = *summary.shortest->first_escape;
    out << '\n'
        << summary.number << " loses a value with bounder " << summary.shortest->bounder_name() << " ("
        << example.origin << "); to see it:\n  " << example.command << '\n';
  }
}

void write_tightness(std::ostream& out, const Bounder_report& report)
{
  const auto audits = audits_for_tightness(report);
  if (audits.empty() || audits.front()->tightness.empty()) return;
  out << "\nwidth of the bound / width of the range, number type " << audits.front()->method.number << '\n'
      << std::left << std::setw(30) << "bounder" << std::right << std::setw(10) << "dimension" << std::setw(14)
      << "median" << std::setw(14) << "worst" << '\n';
  for (const Method_audit* const audit : audits) {
    const Tightness tightness = tightness_of(*audit);
    out << std::left << std::setw(30) << audit->bounder_name() << std::right << std::setw(10) << audit->dimension
        << std::setw(14) << ratio_text(tightness.median) << std::setw(14) << ratio_text(tightness.worst) << '\n';
  }
}

void write_faults(std::ostream& out, const Bounder_report& report)
{
  if (report.faults.empty()) return;
  const auto caught = std::count_if(report.faults.begin(), report.faults.end(), [](const auto& f) { return f.caught; });
  out << "\nplanted faults: " << caught << " of " << report.faults.size() << " caught\n";
  for (const auto& fault : report.faults)
    out << "  " << std::left << std::setw(36) << fault.fault << std::right << std::setw(7) << fault.cases
        << (fault.caught ? "  " + fault.caught_by : "  NOT CAUGHT: " + fault.description) << '\n';
}

} // namespace

void write_bounder_text(std::ostream& out, const Bounder_report& report)
{
  write_numbers(out, report);
  write_counterexamples(out, report);
  write_tightness(out, report);
  write_faults(out, report);
}

namespace {

using Json = nlohmann::ordered_json;

Json json(const Counterexample& example)
{
  return {{"origin", example.origin},  {"polynomial", example.polynomial}, {"box", example.box},
          {"point", example.point},    {"value", example.value},           {"bound", {example.lower, example.upper}},
          {"command", example.command}};
}

Json json(const Method_audit& audit)
{
  Json result{{"number", audit.method.number}, {"guaranteed", audit.is_guaranteed}, {"bounder", audit.method.bounder}};
  if (audit.has_order) result["order"] = audit.method.order;
  result.update(
      {{"dimension", audit.dimension}, {"cases", audit.cases}, {"checks", audit.checks}, {"escapes", audit.escapes}});
  if (audit.first_escape) result["first_escape"] = json(*audit.first_escape);
  if (audit.tightness.empty()) return result;
  const Tightness tightness = tightness_of(audit);
  result["tightness"] = {{"median", tightness.median}, {"worst", tightness.worst}};
  Json& samples = result["tightness"]["degree_width_ratio"];
  for (const auto& sample : audit.tightness) samples.push_back({sample.degree, sample.box_width, sample.ratio});
  return result;
}

} // namespace

void write_bounder_json(std::ostream& out, const Bounder_report& report)
{
  const Audit_settings& settings = report.settings;
  Json root{{"audit", "bounders"}, {"is_sound", is_sound(report)}};
  for (const auto& [name, value] : environment()) root["environment"][name] = value;
  root["settings"] = {{"seed", settings.seed},
                      {"cases", settings.cases},
                      {"paper_cases", settings.paper_cases},
                      {"tightness_cases", settings.tightness_cases},
                      {"precision", settings.precision}};
  for (const Number_summary& summary : summaries(report))
    root["numbers"].push_back({{"number", summary.number},
                               {"guaranteed", summary.is_guaranteed},
                               {"cases", summary.cases},
                               {"checks", summary.checks},
                               {"escapes", summary.escapes},
                               {"verdict", verdict(summary)}});
  for (const Method_audit& audit : report.audits) root["audits"].push_back(json(audit));
  root["faults"] = Json::array();
  for (const auto& fault : report.faults)
    root["faults"].push_back({{"fault", fault.fault},
                              {"description", fault.description},
                              {"caught", fault.caught},
                              {"caught_by", fault.caught_by},
                              {"cases", fault.cases}});
  out << root.dump(-1, ' ', false, Json::error_handler_t::replace) << '\n';
}

} // namespace corral::program
