// SPDX-License-Identifier: LGPL-3.0-or-later
#include "../Grid_problem.h"
#include "../Progress.h"
#include "../commands.h"
#include "../files.h"
#include "../localize/engine.h"
#include "../localize/exact_engine.h"
#include "../whole_number.h"
#include "Raster_report.h"

#include <corral/output/Output_file.h>

#include <algorithm>
#include <iostream>
#include <limits>
#include <memory>

namespace corral::program {

namespace {

struct Raster_arguments
{
  Grid_arguments problem;
  std::string cells;
  Raster_options reading;
  Raster_report_options reporting;
  std::uint64_t max_cells = default_max_cells;
  std::string format = "text";
  std::vector<std::string> outputs;
};

// The cells that are truly hit.
template <std::size_t D>
Ideal_raster<D> truth(const std::vector<Polynomial<Rational, D>>& system, const Grid<D>& grid, std::uint64_t max_cells,
                      Progress& progress)
{
  constexpr double share = 0.3; // of the first pass
  Localize_settings settings;
  if constexpr (D == 1) settings.engine = "paper"; // the fast one is of 2 and 3 dimensions
  settings.run = part_of(progress.run(), 0, share);
  settings.run.cell_budget = max_cells;
  progress.begins("fast engine");
  const auto found = localize_by_name<D>(system, grid, settings);
  progress.begins("exact decision");
  auto ideal = decide_exactly<D>(system, found, part_of(progress.run(), share, 1 - share));
  if (ideal.raster.was_stopped()) throw Cancelled("audit raster");
  return ideal;
}

template <std::size_t D>
void report(const Raster_arguments& arguments, const Raster_audit<D>& audit, Evidence_finder<D>& evidence)
{
  std::vector<File_to_write> files;
  for (const auto& path : arguments.outputs)
    files.push_back({path, [&](std::ostream& out) {
                       if (has_ending(path, ".json"))
                         write_raster_json(out, audit, evidence);
                       else
                         write_raster_html(out, audit, evidence, arguments.reporting);
                     }});
  write_whole_files(files);
  if (!files.empty()) files_are_written();
  if (arguments.format == "json")
    write_raster_json(std::cout, audit, evidence);
  else
    write_raster_text(std::cout, audit, evidence, arguments.reporting);
}

template <std::size_t D>
void audit_in(const Raster_arguments& arguments, const Grid_problem<D>& problem)
{
  const auto& system = problem.system;
  if (system.size() > (D == 1 ? 1 : 2))
    throw Invalid_input("audit raster: given " + detail::quantity(system.size(), "polynomial") + " in "
                        + detail::quantity(D, "dimension") + "; expected 1, or 2 in 2 or 3 dimensions");
  Raster_audit<D> audit{problem.grid, {}, problem.texts, problem.readings, arguments.cells, 0, {}};
  std::copy_n(problem.variables.begin(), D, audit.variables.begin());
  Raster_options reading = arguments.reading;
  reading.variables = problem.variables;
  reading.max_rows = arguments.max_cells;
  const auto raster = read_raster<D>(arguments.cells, problem.grid.resolution(), reading);

  {
    Progress progress("audit raster");
    const auto ideal = truth<D>(system, audit.grid, arguments.max_cells, progress);
    audit.repeated = raster.repeated;
    audit.judgement = judge(ideal.raster, raster);
  }
  Evidence_finder<D> evidence(system, audit.grid, [] {
    if (interrupted_by() != 0) throw Cancelled("audit raster");
  });
  report(arguments, audit, evidence);
  if (!audit.judgement.is_faultless()) throw CLI::RuntimeError(1);
}

void raster_command(const Raster_arguments& arguments)
{
  require_endings(arguments.outputs, {".json", ".html"});
  require_outputs_are_no_inputs(arguments.outputs, arguments.problem.polynomials, {arguments.cells});
  with_problem(arguments.problem, [&]<std::size_t D>(const Grid_problem<D>& problem) {
    if constexpr (D <= 3)
      audit_in(arguments, problem);
    else
      throw Invalid_input("audit raster: given " + std::to_string(D) + " axes; expected 1 to 3");
  });
}

} // namespace

void add_audit_raster(CLI::App& audit)
{
  const auto arguments = std::make_shared<Raster_arguments>();
  CLI::App* const command =
      audit.add_subcommand("raster", "Judge a raster that another program made: lost cells, false cells");
  add_grid_options(*command, arguments->problem,
                   "polynomial; @FILE reads it from a file, @- from standard input. With two, their common zeros");
  command->add_option("--cells", arguments->cells, "the raster: a table (CSV) or, in two dimensions, a PNG picture")
      ->required();
  command->add_flag("--invert", arguments->reading.invert, "the picture is light on dark");
  command->add_option("--list", arguments->reporting.list, "cells of each kind to list")
      ->check(whole_number(0, std::numeric_limits<std::uint64_t>::max()))
      ->capture_default_str();
  command->add_option("--max-cells", arguments->max_cells, "fail when more cells are plotted")
      ->check(whole_number(0, std::numeric_limits<std::uint64_t>::max()))
      ->capture_default_str();
  command->add_option("--output", arguments->outputs, "report to write, .json (every cell) or .html; may be repeated")
      ->take_all()
      ->expected(1);
  command->add_option("--format", arguments->format, "what to print: text or json")
      ->check(CLI::IsMember({"text", "json"}))
      ->capture_default_str();
  command->footer(
      "A table has a row i,j[,k][,verdict] for each plotted cell, indices from 0, axis x first; separators are "
      "commas,\n"
      "semicolons, tabs or blanks. A header may name the columns, by i,j,k or x,y,z or the variables, in any order.\n"
      "Rows with verdict empty count for nothing.\n"
      "A picture has one pixel for each cell; its top row is the largest y. A pixel is plotted if its grey,\n"
      "0.2126 R + 0.7152 G + 0.0722 B of 8-bit sRGB over white, is below 127.5; with --invert, over black, if it is "
      "not.\n"
      "Exit codes: 0 no cell is lost or false, 1 some are or the audit failed, 2 bad usage.\n"
      "Example:\n"
      "  corral audit raster 'x^2 + y^2 - 1' --box -2:2,-2:2 --resolution 256 --cells plot.png --output report.json");
  command->callback([arguments] { raster_command(*arguments); });
}

} // namespace corral::program
