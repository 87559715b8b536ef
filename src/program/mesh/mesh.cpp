// SPDX-License-Identifier: LGPL-3.0-or-later
#include "../Progress.h"
#include "../arguments.h"
#include "../commands.h"
#include "../files.h"
#include "../whole_number.h"

#include <corral/geometry/mesh_curve.h>
#include <corral/output/Output_file.h>
#include <corral/output/curve_meshes.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <iostream>
#include <memory>
#include <mutex>
#include <thread>

namespace corral::program {

namespace {

struct Mesh_arguments
{
  std::vector<std::string> polynomials;
  std::string box;
  std::string variables;
  std::string tolerance;
  std::uint64_t max_cells = std::uint64_t{1} << 21;
  unsigned repeat = 1;
  unsigned threads = 1;
  std::vector<std::string> outputs;
  std::string format = "summary";
  unsigned size = Output_options().size;
};

// A thousandth of the shorter side, unless another one is given.
Rational tolerance_for(const Mesh_arguments& arguments, const Rational_box<2>& box)
{
  if (arguments.tolerance.empty())
    return std::min<Rational>(box[0].upper() - box[0].lower(), box[1].upper() - box[1].lower()) / 1000;
  const Rational tolerance = parse_rational(arguments.tolerance);
  if (tolerance <= 0) throw Invalid_input("mesh: tolerance '" + arguments.tolerance + "'; expected a positive number");
  return tolerance;
}

/// Meshes of all curves, several at the same time.
std::vector<Named_mesh> compute(const std::vector<std::string>& texts,
                                const std::vector<Polynomial<Rational, 2>>& curves, const Rational_box<2>& box,
                                const Rational& tolerance, const Run_options& run)
{
  std::vector<Named_mesh> meshes(curves.size());
  std::vector<std::exception_ptr> errors(curves.size());
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t k = next++; k < curves.size(); k = next++) {
      try {
        meshes[k] = {texts[k], mesh_curve(curves[k], box, tolerance, run)};
      } catch (...) {
        errors[k] = std::current_exception();
      }
    }
  };
  {
    std::vector<std::jthread> others;
    const std::size_t useful =
        std::min<std::size_t>(run.threads == 0 ? std::thread::hardware_concurrency() : run.threads, curves.size());
    for (std::size_t k = 1; k < useful; ++k) others.emplace_back(work);
    work();
  }
  for (const auto& error : errors)
    if (error) std::rethrow_exception(error);
  return meshes;
}

void mesh_command(const Mesh_arguments& arguments)
{
  require_outputs_are_no_inputs(arguments.outputs, arguments.polynomials);
  for (const auto& path : arguments.outputs)
    static_cast<void>(mesh_writer_for(path)); // fail before the work, not after
  const auto formulas = formulas_of(arguments.polynomials);
  const Space space = read_space(arguments.box, arguments.variables, formulas);
  if (space.sides.size() != 2)
    throw Invalid_input("mesh: given " + detail::quantity(space.sides.size(), "axis")
                        + "; expected a curve in the plane, so 2");
  const auto curves = polynomials_of<2>(space, formulas);
  const auto box = box_of<2>(space);

  Progress progress("mesh");
  const Rational tolerance = tolerance_for(arguments, box);
  Run_options run = progress.run();
  run.cell_budget = arguments.max_cells;
  run.threads = arguments.threads;
  std::mutex mutex;
  if (run.progress)
    run.progress = [&mutex, tell = run.progress](double done) {
      const std::scoped_lock lock(mutex);
      tell(done);
    };
  std::vector<Named_mesh> meshes;
  std::vector<double> seconds;
  for (unsigned k = 0; k < arguments.repeat && (k == 0 || interrupted_by() == 0); ++k) {
    const auto start = std::chrono::steady_clock::now();
    meshes = compute(texts_of(formulas), curves, box, tolerance, run);
    seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  if (interrupted_by() != 0) keep_what_is_proved();
  std::sort(seconds.begin(), seconds.end());

  Output_options output;
  output.variables = space.variables;
  output.size = arguments.size;
  output.facts = {reading_fact(readings_of<2>(space, curves)),
                  {"tolerance", to_string(tolerance)},
                  {"seconds", seconds[seconds.size() / 2]}};
  if (seconds.size() > 1)
    output.facts.insert(output.facts.end(),
                        {{"repeat", std::uint64_t{seconds.size()}}, {"seconds_min", seconds.front()}});
  std::vector<File_to_write> files;
  for (const auto& path : arguments.outputs)
    files.push_back(
        {path, [&, write = mesh_writer_for(path).write](std::ostream& out) { write(out, meshes, output); }});
  write_whole_files(files);
  if (!files.empty()) files_are_written();
  if (arguments.format == "json")
    write_meshes_json(std::cout, meshes, output);
  else
    write_meshes_summary(std::cout, meshes, output);
}

} // namespace

void add_mesh(CLI::App& app)
{
  const auto arguments = std::make_shared<Mesh_arguments>();
  CLI::App* const command =
      app.add_subcommand("mesh", "Draw a plane curve as polylines with proved topology: components, singular points");
  command
      ->add_option("POLY", arguments->polynomials,
                   "polynomial in two variables; @FILE reads it from a file, @- from standard input.\n"
                   "With several, each is a curve of its own.")
      ->required();
  command->add_option("--box", arguments->box, "LOWER:UPPER for each axis, separated by a comma, such as -1:1,0:3/2")
      ->required();
  command->add_option("--variables", arguments->variables,
                      "names of the axes in order (else x, y, z; see doc/input.md)");
  command
      ->add_option("--tolerance", arguments->tolerance,
                   "greatest distance between curve and polylines, both ways, in the units of the box")
      ->default_str("a thousandth of the shorter side");
  command->add_option("--max-cells", arguments->max_cells, "cells to look at; what is unclear then is said to be")
      ->check(whole_number(1))
      ->capture_default_str();
  command
      ->add_option("--repeat", arguments->repeat, "run the computation so many times; the summary says the median time")
      ->check(whole_number(1))
      ->capture_default_str();
  command->add_option("--threads", arguments->threads, "curves to mesh at the same time; 0: one for each processor")
      ->check(whole_number(0, 1024))
      ->capture_default_str();
  command
      ->add_option("--output", arguments->outputs, "file to write: .svg .png .json .csv .dxf or .wkt; may be repeated")
      ->take_all()
      ->expected(1);
  command->add_option("--format", arguments->format, "what to print: summary (a line of JSON) or json (with the mesh)")
      ->check(CLI::IsMember({"summary", "json"}))
      ->capture_default_str();
  command->add_option("--size", arguments->size, "longer side of pictures in pixels")
      ->check(whole_number(64, 8192))
      ->capture_default_str();
  command->footer("The polylines are isotopic to the curve in the box, unless \"certified\" is false.\n"
                  "When interrupted, what is proved by then is written and the rest uncertified.\n"
                  "Examples:\n"
                  "  corral mesh 'y^2 - x^3 + x' --box -2:2,-2:2 --output elliptic.svg\n"
                  "  corral mesh 'x^4+y^4-1' '(x^2+y^2)^2-2*(x^2-y^2)' --box -3/2:3/2,-3/2:3/2 --output both.png");
  command->callback([arguments] { mesh_command(*arguments); });
}

} // namespace corral::program
