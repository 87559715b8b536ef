// SPDX-License-Identifier: LGPL-3.0-or-later
#include "../Grid_problem.h"
#include "../Progress.h"
#include "../commands.h"
#include "../files.h"
#include "../method_options.h"
#include "../whole_number.h"
#include "engine.h"
#include "exact_engine.h"
#include "run_facts.h"

#include <corral/output/all.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <limits>
#include <optional>

namespace corral::program {

namespace {

struct Localize_arguments
{
  Grid_arguments problem;
  Localize_settings settings;
  bool plus = false;
  bool names_engine = false;
  std::vector<std::string> paper_options; // given options that only the paper's engine heeds
  bool exact = false;
  bool recheck = false;
  bool rungs = false; ///< a column of CSV
  unsigned threads = 1;
  std::uint64_t max_cells = default_max_cells;
  unsigned repeat = 1;
  std::vector<std::string> outputs;
  std::string format;
  unsigned size = Output_options().size;
  bool plain = false;
};

template <std::size_t D>
void print(const std::string& format, const Raster<D>& raster, const Output_options& options)
{
  if (format == "csv")
    write_csv(std::cout, raster, options);
  else if (format == "json")
    write_json(std::cout, raster, options);
  else if (format == "text")
    write_text(std::cout, raster, options);
  else
    write_summary(std::cout, raster, options);
}

// The cells of one run or, with `repeat`, of the last of several equal ones.
template <std::size_t D>
struct Outcome
{
  Raster<D> raster;
  Facts facts;
  std::vector<Decided_cell<D>> decided; ///< exactly, if that is to be written
};

// Whether some output says of each cell who decided it.
bool writes_rungs(const Localize_arguments& arguments)
{
  const auto is_json = [](const std::string& path) { return path.ends_with(".json"); };
  return arguments.exact
         && (arguments.rungs || arguments.format == "json"
             || std::any_of(arguments.outputs.begin(), arguments.outputs.end(), is_json));
}

// The settings that the options and the dimension make.
Localize_settings settings_for(std::size_t dimension, const Localize_arguments& arguments)
{
  Localize_settings settings = arguments.settings;
  settings.refine = settings.refine || arguments.plus;
  settings.sample = settings.sample || arguments.plus;
  if (!arguments.names_engine && (dimension < 2 || dimension > 3)) { // the fast engine is of 2 and 3 dimensions
    settings.engine = "paper";
    settings.sample = settings.sample || arguments.paper_options.empty(); // the fast one proves hits, too
  }
  return settings;
}

// One run of the engine and, if asked for, of the exact decision.
template <std::size_t D>
Outcome<D> run_once(const std::vector<Polynomial<Rational, D>>& system, const Grid<D>& grid,
                    const std::vector<std::string>& texts, const Localize_settings& settings,
                    const Localize_arguments& arguments, Progress& progress)
{
  const Method& method = settings.method;
  progress.begins(settings.engine == "fast" ? "fast engine" : method.bounder + " over " + method.number);
  auto found = localize_by_name<D>(system, grid, settings);
  // What was not visited when the run was stopped may be too much to name.
  if (found.was_stopped() && found.plotted() > arguments.max_cells) throw Cancelled("localize");
  Facts about = facts(texts, settings, found.counters(), found.is_guaranteed());
  Outcome<D> outcome{std::move(found), std::move(about), {}};
  if (!arguments.exact) return outcome;
  if (!outcome.raster.is_guaranteed())
    throw Invalid_input("exact: number type " + method.number + " may have lost cells; expected a guaranteed one");
  progress.begins("exact decision");
  auto ideal = decide_exactly<D>(system, outcome.raster, settings.run,
                                 {.keep_rungs = writes_rungs(arguments), .recheck = arguments.recheck});
  const Facts more = exact_facts(ideal, arguments.recheck);
  outcome.facts.insert(outcome.facts.end(), more.begin(), more.end());
  outcome.raster = std::move(ideal.raster);
  outcome.decided = std::move(ideal.decided);
  return outcome;
}

template <std::size_t D>
Outcome<D> compute(const std::vector<Polynomial<Rational, D>>& system, const Grid<D>& grid,
                   const std::vector<std::string>& texts, const Localize_arguments& arguments)
{
  Progress progress("localize");
  Localize_settings settings = settings_for(D, arguments);
  settings.run = progress.run(arguments.threads);
  settings.run.cell_budget = arguments.max_cells;
  std::optional<Outcome<D>> outcome;
  std::vector<double> seconds;
  while (seconds.size() < arguments.repeat && interrupted_by() == 0) {
    const auto start = std::chrono::steady_clock::now();
    outcome = run_once<D>(system, grid, texts, settings, arguments, progress);
    seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  if (!outcome) throw Cancelled("localize");
  const Facts times = time_facts(std::move(seconds));
  outcome->facts.insert(outcome->facts.end(), times.begin(), times.end());
  return std::move(*outcome);
}

template <std::size_t D>
void localize_in(const Localize_arguments& arguments, const Grid_problem<D>& problem)
{
  const auto& [texts, readings, variables, system, grid] = problem;
  for (const auto& path : arguments.outputs) static_cast<void>(writer_for<D>(path)); // fail before the work, not after
  for (std::size_t k = 0; k < system.size(); ++k)
    if (system[k].is_zero())
      throw Invalid_input("localize: polynomial " + std::to_string(k + 1) + " is zero, so that every point is a zero; "
                          + "expected a polynomial that is not");
  const Outcome<D> outcome = compute<D>(system, grid, texts, arguments);
  if (interrupted_by() != 0) keep_what_is_proved();

  Output_options options;
  options.variables = variables;
  options.facts = outcome.facts;
  options.facts.insert(options.facts.begin() + 1, reading_fact(readings)); // behind the texts as given
  options.cell_notes = notes(outcome.decided);
  options.cell_notes.in_csv = arguments.rungs;
  options.size = arguments.size;
  options.colouring = arguments.plain ? Colouring::plotted : Colouring::by_verdict;
  std::vector<File_to_write> files;
  for (const auto& path : arguments.outputs)
    files.push_back(
        {path, [&, write = writer_for<D>(path).write](std::ostream& out) { write(out, outcome.raster, options); }});
  write_whole_files(files);
  if (!files.empty()) files_are_written();
  print(arguments.format, outcome.raster, options);
}

void localize_command(const Localize_arguments& arguments)
{
  require_outputs_are_no_inputs(arguments.outputs, arguments.problem.polynomials);
  with_problem(arguments.problem, [&](const auto& problem) { localize_in(arguments, problem); });
}

// The given options that only the paper's engine heeds.
std::vector<std::string> paper_options(const CLI::App& command)
{
  std::vector<std::string> given;
  for (const char* option :
       {"--bounder", "--order", "--number", "--precision", "--sample", "--refine", "--plus", "--count"})
    if (command.count(option) > 0) given.emplace_back(option);
  return given;
}

void add_engine_options(CLI::App& command, Localize_arguments& arguments)
{
  Localize_settings& settings = arguments.settings;
  add_method_options(command, settings.method);
  command.add_option("--engine", settings.engine, "fast: Taylor forms in doubles; paper: the subdivision of the paper")
      ->check(CLI::IsMember({"fast", "paper"}))
      ->default_str("fast; paper where one of its options is given");
  command
      .add_option("--threads", arguments.threads,
                  "threads of the fast engine and of --exact; 0: one for each processor")
      ->check(whole_number(0, 1024))
      ->capture_default_str();
  command
      .add_option("--repeat", arguments.repeat,
                  "run the computation so many times; the summary says the least and the median time")
      ->check(whole_number(1))
      ->capture_default_str();
  command.add_flag("--exact", arguments.exact,
                   "decide every cell exactly: one polynomial in 1 to 3 variables, or two in 2 or 3");
  command
      .add_flag("--recheck", arguments.recheck,
                "decide every cell again without floats; a contradiction ends the run with exit code 1")
      ->needs("--exact");
  command.add_flag("--sample", settings.sample, "look for a change of sign at the corners of a cell");
  command.add_flag("--refine", settings.refine, "cut each remaining cell once more before it is plotted");
  command.add_flag("--plus", arguments.plus, "--sample and --refine: the paper's RT++ and MAA++");
  command.add_flag("--count", settings.count, "count additions and multiplications (paper's engine)");
  command.add_option("--max-cells", arguments.max_cells, "fail when more cells would be plotted")
      ->check(whole_number(0, std::numeric_limits<std::uint64_t>::max()))
      ->capture_default_str();
}

void add_output_options(CLI::App& command, Localize_arguments& arguments)
{
  command.add_option("--output", arguments.outputs, "file to write, of a kind told by its ending; may be repeated")
      ->take_all()
      ->expected(1);
  command.add_option("--format", arguments.format, "what to print: csv, json, text, or summary (a line of JSON)")
      ->check(CLI::IsMember({"csv", "json", "text", "summary"}))
      ->default_str("summary");
  command.add_flag("--rungs", arguments.rungs, "a last column of CSV with the step that decided each cell")
      ->needs("--exact");
  command.add_option("--size", arguments.size, "longer side of pictures in pixels")
      ->check(whole_number(64, 8192))
      ->capture_default_str();
  command.add_flag("--plain", arguments.plain, "pictures show hit and unknown cells alike, as in the paper");
}

} // namespace

void add_localize(CLI::App& app)
{
  const auto arguments = std::make_shared<Localize_arguments>();
  CLI::App* const command = app.add_subcommand("localize", "Find the cells that a curve or surface passes through");
  add_grid_options(*command, arguments->problem,
                   "polynomial, such as 'x^2 + y^2 - 1/4'; @FILE reads it from a file, @- from standard input.\n"
                   "With several, cells where all may vanish together are found.");
  add_engine_options(*command, *arguments);
  add_output_options(*command, *arguments);
  command->footer(
      "Verdicts: hit (proved: a zero in the cell) and unknown; all other cells are proved empty.\n"
      "With --exact, none is unknown in one and two dimensions. What is decided when it is interrupted is kept.\n"
      "Examples:\n"
      "  corral localize 'x^2 + y^2 - 1' --box -2:2,-2:2 --resolution 256 --plus --output circle.png\n"
      "  corral localize 'x^2+y^2+z^2-4' '(x-1)^2+y^2-1' --box -2:2,-2:2,-2:2 --resolution 64 --output v.ply\n"
      "  corral localize 'x^4 + y^4 - 2*x^2*y^2' --box -1:1,-1:1 --resolution 256 --exact --output cross.svg\n"
      "  corral localize 'y - x^3' --box -1:1,-1:1 --resolution 40,20 --format text");
  command->callback([arguments, command] {
    arguments->names_engine = command->count("--engine") > 0;
    arguments->paper_options = paper_options(*command);
    if (!arguments->names_engine && !arguments->paper_options.empty()) arguments->settings.engine = "paper";
    if (arguments->settings.engine == "fast" && !arguments->paper_options.empty())
      std::cerr << "corral: note: engine fast takes no notice of " << arguments->paper_options.front() << '\n';
    localize_command(*arguments);
  });
}

} // namespace corral::program
