// SPDX-License-Identifier: LGPL-3.0-or-later
#include "bound_over.h"
#include "commands.h"

#include <corral/bounders/all.h>
#include <corral/number/all.h>
#include <corral/output/Output_file.h>

#include <cerrno>
#include <cstring>
#include <iostream>
#include <memory>

namespace corral::program {

namespace {

struct Bound_arguments
{
  std::string polynomial;
  std::string box;
  std::string variables;
  Method method;
};

void print(const Bound_answer& answer, const std::string& number)
{
  errno = 0;
  std::cout << "exact:   " << answer.exact << '\n' << "decimal: " << answer.decimal << '\n';
  if (answer.counts != Operation_counts{})
    std::cout << "counted: " << answer.counts.additions << " additions, " << answer.counts.multiplications
              << " multiplications\n";
  if (!answer.is_guaranteed)
    std::cout << "note: not guaranteed: " << number << " rounds to nearest, so that values may lie outside\n";
  if (!std::cout.flush())
    throw Output_error(std::string("output: cannot write standard output: ") + std::strerror(errno != 0 ? errno : EIO));
}

void bound_command(const Bound_arguments& arguments)
{
  const Method& method = arguments.method;
  if (method.order == 0) throw Invalid_input("order: given 0; expected a whole number from 1");
  const std::string text = polynomial_text(arguments.polynomial);
  const Bound_problem problem{read_space(arguments.box, arguments.variables, {text}), text, method};
  const Mpfr_precision_scope precision(method.precision);
  const auto answer =
      Number_types::visit(method.number, [&]<class I>(std::type_identity<I>) { return bound_over<I>(problem); });
  print(answer, method.number);
}

} // namespace

void add_bound(CLI::App& app)
{
  const auto arguments = std::make_shared<Bound_arguments>();
  CLI::App* const command = app.add_subcommand("bound", "Enclose the values of a polynomial over a box");
  command->add_option("POLY", arguments->polynomial, "polynomial; @FILE reads it from a file, @- from standard input")
      ->required();
  command
      ->add_option("--box", arguments->box,
                   "LOWER:UPPER for each axis, separated by commas, such as -1:1,0:3/2; a side may be a point, 1:1")
      ->required();
  command->add_option("--variables", arguments->variables, "names of the axes in order (else alphabetical)");
  Method& method = arguments->method;
  command->add_option("--bounder", method.bounder, "how ranges are bounded; see corral list")->capture_default_str();
  command->add_option("--order", method.order, "order of a Taylor method")->capture_default_str();
  command->add_option("--number", method.number, "number type; see corral list")->capture_default_str();
  command->add_option("--precision", method.precision, "bits of number type mpfr")->capture_default_str();
  command->footer("Prints the interval exactly, as fractions or hexadecimal floats, and in decimals rounded outward.\n"
                  "Examples:\n"
                  "  corral bound 'x^2 - x*y' --box 0:1,0:1\n"
                  "  corral bound 'x^3 - 1/3' --box -1:1 --bounder bernstein --number rational");
  command->callback([arguments] { bound_command(*arguments); });
}

} // namespace corral::program
