// SPDX-License-Identifier: LGPL-3.0-or-later
#include "../Grid_problem.h"
#include "../Progress.h"
#include "../commands.h"
#include "../files.h"
#include "../whole_number.h"

#include <corral/certificate/certificate.h>
#include <corral/output/Output_file.h>

#include <algorithm>
#include <iostream>
#include <limits>
#include <memory>

namespace corral::program {

namespace {

struct Certify_arguments
{
  Grid_arguments problem;
  std::string output;
  std::size_t max_boxes = Certify_options().max_boxes;
};

template <std::size_t D>
void print_summary(const Certificate<D>& certificate, const std::string& path, std::size_t bytes)
{
  std::cout << "certified: " << certificate.empty + certificate.plotted() << " cells, " << certificate.empty
            << " empty, " << certificate.hit << " hit, " << certificate.unknown << " unknown; " << bytes << " bytes in "
            << path << '\n';
  for (const auto& reason : certificate.reasons) std::cout << "unknown: " << reason << '\n';
}

template <std::size_t D>
void certify_in(const Certify_arguments& arguments, const Grid_problem<D>& problem)
{
  std::array<std::string, D> variables;
  std::copy_n(problem.variables.begin(), D, variables.begin());

  Progress progress("certify");
  const auto certificate = certify(problem.system, problem.grid, progress.run(),
                                   {.max_boxes = arguments.max_boxes, .patience = std::chrono::milliseconds(250)});
  if (interrupted_by() != 0) keep_what_is_proved();
  std::string bytes = to_json(certificate, variables);
  if (arguments.output.ends_with(".gz")) bytes = gzip(bytes);
  write_whole_file(arguments.output, [&](std::ostream& stream) { stream << bytes; });
  files_are_written();
  print_summary(certificate, arguments.output, bytes.size());
  for (const auto& reading : problem.readings) std::cout << "polynomial: " << reading << '\n';
}

void certify_command(const Certify_arguments& arguments)
{
  require_outputs_are_no_inputs({arguments.output}, arguments.problem.polynomials);
  if (!arguments.output.ends_with(".json") && !arguments.output.ends_with(".json.gz"))
    throw Invalid_input("certify: output file '" + arguments.output + "'; expected a name ending in .json or .json.gz");
  with_problem(arguments.problem, [&]<std::size_t D>(const Grid_problem<D>& problem) {
    if constexpr (D <= 3)
      certify_in(arguments, problem);
    else
      throw Invalid_input("certify: given " + std::to_string(D) + " axes; expected 1 to 3");
  });
}

} // namespace

void add_certify(CLI::App& app)
{
  const auto arguments = std::make_shared<Certify_arguments>();
  CLI::App* const command =
      app.add_subcommand("certify", "Decide every cell exactly and write the proofs to a file for corral-check");
  add_grid_options(*command, arguments->problem,
                   "polynomial; @FILE reads it from a file, @- from standard input. Two: their common zeros.");
  command->add_option("--output", arguments->output, "certificate to write: .json or .json.gz")->required();
  command->add_option("--max-boxes", arguments->max_boxes, "boxes into which one cell may be cut to prove it empty")
      ->check(whole_number(1, std::numeric_limits<std::uint64_t>::max()))
      ->capture_default_str();
  command->footer(
      "When interrupted, what is proved by then is written and the rest left unknown.\n"
      "Example:\n"
      "  corral certify 'x^2 + y^2 - 1' --box -2:2,-2:2 --resolution 256 --output circle.json.gz\n"
      "  corral-check circle.json.gz\n"
      "  corral certify 'x^2+y^2+z^2-4' '(x-1)^2+y^2-1' --box -2:2,-2:2,-2:2 --resolution 32 --output v.json.gz\n"
      "The format is specified in doc/certificate.md.");
  command->callback([arguments] { certify_command(*arguments); });
}

} // namespace corral::program
