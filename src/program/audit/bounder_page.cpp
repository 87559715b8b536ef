// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Bounder_report.h"
#include "report_page.h"
#include "tightness_plot.h"

#include <algorithm>
#include <cstdio>

namespace corral::program {

namespace {

std::string cell(const std::string& html) { return "<td>" + html + "</td>"; }
std::string number_cell(const std::string& text) { return "<td class=\"number\">" + text + "</td>"; }

std::string coloured(const char* colour, const std::string& html)
{
  return std::string("<span class=\"") + colour + "\">" + html + "</span>";
}

std::string ratio(double value)
{
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.4g", value);
  return buffer;
}

std::string number_table(const Bounder_report& report)
{
  std::string html = "<table><tr><th>number type</th><th class=\"number\">cases</th><th class=\"number\">values</th>"
                     "<th class=\"number\">escapes</th><th>verdict</th></tr>\n";
  for (const Number_summary& summary : summaries(report)) {
    const char* const colour = summary.escapes == 0 ? "good" : summary.is_guaranteed ? "bad" : "note";
    html += "<tr>" + cell(summary.number) + number_cell(std::to_string(summary.cases))
            + number_cell(std::to_string(summary.checks)) + number_cell(std::to_string(summary.escapes))
            + cell(coloured(colour, verdict(summary))) + "</tr>\n";
  }
  return html + "</table>\n";
}

// Bounders with their orders, each once, in the order of the audits.
std::vector<std::string> bounder_names(const Bounder_report& report)
{
  std::vector<std::string> names;
  for (const Method_audit& audit : report.audits)
    if (std::find(names.begin(), names.end(), audit.bounder_name()) == names.end())
      names.push_back(audit.bounder_name());
  return names;
}

std::string escape_table(const Bounder_report& report)
{
  std::string html = "<table><tr><th>bounder</th>";
  for (const auto& number : report.settings.numbers) html += "<th class=\"number\">" + number + "</th>";
  html += "</tr>\n";
  for (const auto& bounder : bounder_names(report)) {
    html += "<tr>" + cell(bounder);
    for (const auto& number : report.settings.numbers) {
      std::uint64_t escapes = 0;
      bool is_guaranteed = false;
      for (const Method_audit& audit : report.audits)
        if (audit.method.number == number && audit.bounder_name() == bounder) {
          escapes += audit.escapes;
          is_guaranteed = audit.is_guaranteed;
        }
      const std::string text = std::to_string(escapes);
      html += number_cell(escapes == 0 || !is_guaranteed ? text : coloured("bad", text));
    }
    html += "</tr>\n";
  }
  return html + "</table>\n";
}

std::string counterexamples(const Bounder_report& report)
{
  std::string html;
  for (const Number_summary& summary : summaries(report)) {
    if (summary.shortest == nullptr) continue;
    const Counterexample& example = *summary.shortest->first_escape;
    html += "<p>" + summary.number + " with bounder " + summary.shortest->bounder_name() + ": "
            + escaped(example.origin) + ".</p>\n<pre>" + escaped(example.command)
            + "</pre>\n<details><summary>the first of each bounder over " + summary.number + "</summary>\n";
    for (const Method_audit& audit : report.audits)
      if (audit.method.number == summary.number && audit.first_escape)
        html += "<p>" + audit.bounder_name() + ", " + std::to_string(audit.dimension)
                + (audit.dimension == 1 ? " variable: " : " variables: ") + escaped(audit.first_escape->origin)
                + "</p>\n<pre>" + escaped(audit.first_escape->command) + "</pre>\n";
    html += "</details>\n";
  }
  return html.empty() ? html : "<h2>Where values escape</h2>\n<p>Each command shows it again.</p>\n" + html;
}

std::string tightness_section(const Bounder_report& report)
{
  const auto audits = audits_for_tightness(report);
  if (audits.empty() || audits.front()->tightness.empty()) return {};
  std::string html =
      "<h2>Tightness</h2>\n<p>The width of the bound divided by that of the exact range, over number type "
      + audits.front()->method.number + "; 1 is perfect. In each dimension all bounders have the same "
      + std::to_string(report.settings.tightness_cases) + " polynomials and boxes.</p>\n<table><tr><th></th>";
  for (const std::size_t dimension : report.settings.dimensions)
    html += "<th colspan=\"2\">" + std::to_string(dimension) + (dimension == 1 ? " variable" : " variables") + "</th>";
  html += "</tr>\n<tr><th>bounder</th>";
  for (std::size_t k = 0; k < report.settings.dimensions.size(); ++k)
    html += "<th class=\"number\">median</th><th class=\"number\">worst</th>";
  html += "</tr>\n";
  for (const auto& bounder : bounder_names(report)) {
    html += "<tr>" + cell(bounder);
    for (const auto* const audit : audits)
      if (audit->bounder_name() == bounder) {
        const Tightness tightness = tightness_of(*audit);
        html += number_cell(ratio(tightness.median)) + number_cell(ratio(tightness.worst));
      }
    html += "</tr>\n";
  }
  html +=
      "</table>\n<p>Below, the median of that ratio minus 1. When boxes are halved it stays where it is for a method "
      "of "
      "linear convergence, and falls by half for one of quadratic convergence. Points at the lower edge are exact as "
      "far as the range is known.</p>\n";
  for (const std::size_t dimension : report.settings.dimensions) {
    std::vector<const Method_audit*> of_dimension;
    std::copy_if(audits.begin(), audits.end(), std::back_inserter(of_dimension),
                 [&](const auto* audit) { return audit->dimension == dimension; });
    html += "<h3>" + std::to_string(dimension) + (dimension == 1 ? " variable" : " variables")
            + "</h3>\n<div class=\"plots\">\n" + tightness_plot(of_dimension, Plot_axis::box_width)
            + tightness_plot(of_dimension, Plot_axis::degree) + "</div>\n" + plot_legend(of_dimension);
  }
  return html;
}

std::string fault_section(const Bounder_report& report)
{
  if (report.faults.empty()) return {};
  const auto caught = std::count_if(report.faults.begin(), report.faults.end(), [](const auto& f) { return f.caught; });
  std::string html =
      "<h2>Planted faults</h2>\n<p>Copies of bounders and number types, each with one fault. The audit found "
      + std::to_string(caught) + " of " + std::to_string(report.faults.size())
      + ".</p>\n<table><tr><th>fault</th><th>what is wrong</th><th>caught by</th><th class=\"number\">after "
        "cases</th></tr>\n";
  for (const auto& fault : report.faults)
    html += "<tr>" + cell(escaped(fault.fault)) + cell(escaped(fault.description))
            + cell(fault.caught ? escaped(fault.caught_by) : coloured("bad", "not caught"))
            + number_cell(std::to_string(fault.cases)) + "</tr>\n";
  return html + "</table>\n";
}

std::string how_section(const Bounder_report& report)
{
  const Audit_settings& settings = report.settings;
  std::string html =
      "<h2>How</h2>\n<p>Each bound is compared, without tolerance, with exact rational values of the "
      "polynomial at points of the box. Seed "
      + std::to_string(settings.seed) + "; for each method and dimension " + std::to_string(settings.cases)
      + " generated polynomials, each on several boxes, " + std::to_string(settings.paper_cases)
      + " cases on the paper's examples in two and three variables, and " + std::to_string(settings.tightness_cases)
      + " boxes for tightness. The same seed gives the same cases.</p>\n<table>\n";
  for (const auto& [name, value] : environment())
    html += "<tr>" + cell(coloured("note", name)) + cell(escaped(value)) + "</tr>\n";
  return html + "</table>\n";
}

} // namespace

void write_bounder_html(std::ostream& out, const Bounder_report& report)
{
  const std::string verdict_text =
      is_sound(report) ? coloured("good", "No value escapes from a bound over a guaranteed number type.")
                       : coloured("bad", "A guaranteed bound fails, or a planted fault was not caught.");
  const std::string body = "<p>" + verdict_text + "</p>\n" + number_table(report) + "<h2>Escapes by bounder</h2>\n"
                           + escape_table(report) + counterexamples(report) + tightness_section(report)
                           + fault_section(report) + how_section(report);
  out << report_page("Audit of the bounders", body);
}

} // namespace corral::program
