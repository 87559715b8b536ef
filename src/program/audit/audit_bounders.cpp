// SPDX-License-Identifier: LGPL-3.0-or-later
#include "../Progress.h"
#include "../arguments.h"
#include "../commands.h"
#include "../files.h"
#include "../whole_number.h"
#include "Bounder_report.h"

#include <corral/bounders/all.h>
#include <corral/number/all.h>
#include <corral/output/Output_file.h>

#include <algorithm>
#include <iostream>
#include <limits>
#include <memory>

namespace corral::program {

namespace {

struct Bounders_arguments
{
  Audit_settings settings;
  std::uint64_t fault_cases = Audit_options().cases;
  std::string format = "text";
  std::vector<std::string> outputs;
};

template <class T>
void remove_repeated(std::vector<T>& list)
{
  for (auto k = list.begin(); k != list.end();) k = std::find(list.begin(), k, *k) == k ? k + 1 : list.erase(k);
}

// Nothing named means all of them.
void complete(Audit_settings& settings)
{
  if (settings.numbers.empty())
    Number_types::for_each(
        [&]<class I>(std::type_identity<I>) { settings.numbers.emplace_back(Interval_traits<I>::name); });
  if (settings.bounders.empty())
    Bounders::for_each<Rational_interval, 1>(
        [&](auto bounder) { settings.bounders.emplace_back(decltype(bounder)::type::name); });
  remove_repeated(settings.numbers);
  remove_repeated(settings.bounders);
  remove_repeated(settings.orders);
  remove_repeated(settings.dimensions);
  for (const auto& number : settings.numbers) Number_types::visit(number, [](auto) {}); // throws for unknown names
  for (const auto& bounder : settings.bounders) static_cast<void>(has_order(bounder));
}

// The planted faults. How far the search has come is not known, so that the bar stands still meanwhile.
std::vector<audit::Fault_finding> plant_faults(std::uint64_t seed, std::uint64_t cases, Progress& progress)
{
  Audit_options options;
  options.seed = seed;
  options.cases = cases;
  progress.begins("planted faults");
  auto findings = audit::seed_faults(options, part_of(progress.run(), 0, 0));
  if (interrupted_by() != 0) throw Cancelled("audit bounders");
  return findings;
}

Bounder_report audit_all(const Audit_settings& settings, std::uint64_t fault_cases)
{
  Progress progress("audit bounders");
  const Mpfr_precision_scope precision(settings.precision);
  Bounder_report report{settings, {}, {}};
  if (fault_cases > 0) report.faults = plant_faults(settings.seed, fault_cases, progress);
  const double shares = static_cast<double>(settings.numbers.size());
  double share = 0;
  for (const auto& number : settings.numbers) {
    progress.begins(number);
    const auto audits = Number_types::visit(number, [&]<class I>(std::type_identity<I>) {
      return audit_over<I>(settings, part_of(progress.run(), share / shares, 1 / shares));
    });
    report.audits.insert(report.audits.end(), audits.begin(), audits.end());
    ++share;
  }
  return report;
}

void bounders_command(const Bounders_arguments& arguments)
{
  require_endings(arguments.outputs, {".json", ".html"});
  Audit_settings settings = arguments.settings;
  complete(settings);
  const Bounder_report report = audit_all(settings, arguments.fault_cases);
  std::vector<File_to_write> files;
  for (const auto& path : arguments.outputs)
    files.push_back({path, [&](std::ostream& out) {
                       (has_ending(path, ".json") ? write_bounder_json : write_bounder_html)(out, report);
                     }});
  write_whole_files(files);
  if (!files.empty()) files_are_written();
  (arguments.format == "json" ? write_bounder_json : write_bounder_text)(std::cout, report);
  if (!is_sound(report)) throw CLI::RuntimeError(1);
}

void add_subjects(CLI::App& command, Audit_settings& settings)
{
  command.add_option("--bounder", settings.bounders, "bounders, separated by commas; see corral list")
      ->delimiter(',')
      ->default_str("all");
  command.add_option("--number", settings.numbers, "number types, separated by commas; see corral list")
      ->delimiter(',')
      ->default_str("all");
  command.add_option("--order", settings.orders, "orders of recursive Taylor expansion, 1 to 16, separated by commas")
      ->delimiter(',')
      ->check(whole_number(1, 16))
      ->default_str("1,2,3,4");
  command.add_option("--dimension", settings.dimensions, "numbers of variables, 1 to 3, separated by commas")
      ->delimiter(',')
      ->check(whole_number(1, 3))
      ->default_str("1,2,3");
  command.add_option("--precision", settings.precision, "bits of number type mpfr")
      ->check(whole_number(1))
      ->capture_default_str();
}

void add_cases(CLI::App& command, Bounders_arguments& arguments)
{
  Audit_settings& settings = arguments.settings;
  command.add_option("--seed", settings.seed, "of all cases; the same seed gives the same report")
      ->check(whole_number(0, std::numeric_limits<std::uint64_t>::max()))
      ->capture_default_str();
  command.add_option("--cases", settings.cases, "generated polynomials for each method and dimension")
      ->check(whole_number(1, 1'000'000'000))
      ->capture_default_str();
  command
      .add_option("--paper-cases", settings.paper_cases, "cases on the paper's examples for each method and dimension")
      ->check(whole_number(0, 1'000'000'000))
      ->capture_default_str();
  command.add_option("--tightness-cases", settings.tightness_cases, "boxes on which the exact range is computed")
      ->check(whole_number(0, 1'000'000))
      ->capture_default_str();
  command.add_option("--fault-cases", arguments.fault_cases, "cases to find each planted fault; 0 plants none")
      ->check(whole_number(0, 1'000'000'000))
      ->capture_default_str();
}

} // namespace

void add_audit_bounders(CLI::App& audit)
{
  const auto arguments = std::make_shared<Bounders_arguments>();
  arguments->settings.orders = {1, 2, 3, 4};
  arguments->settings.dimensions = {1, 2, 3};
  CLI::App* const command =
      audit.add_subcommand("bounders", "Compare the bounds of every method and number type with exact values");
  add_subjects(*command, arguments->settings);
  add_cases(*command, *arguments);
  command->add_option("--output", arguments->outputs, "report to write, .json or .html; may be repeated")
      ->take_all()
      ->expected(1);
  command->add_option("--format", arguments->format, "what to print: text or json")
      ->check(CLI::IsMember({"text", "json"}))
      ->capture_default_str();
  command->footer(
      "Every value that escapes from a bound is printed as a command that shows it again.\n"
      "Exit codes: 0 every guaranteed number type passes and every planted fault is caught, 1 one does not or\n"
      "the audit failed, 2 bad usage. That double_nearest fails is expected.\n"
      "Examples:\n"
      "  corral audit bounders --output report.html\n"
      "  corral audit bounders --bounder rt,maa --order 2 --number cgal_interval --cases 100000");
  command->callback([arguments] { bounders_command(*arguments); });
}

} // namespace corral::program
