// SPDX-License-Identifier: LGPL-3.0-or-later
#include "../commands.h"
#include "../method_options.h"
#include "bound_over.h"

#include <corral/bounders/all.h>
#include <corral/number/all.h>

#include <iostream>
#include <memory>
#include <optional>
#include <sstream>

namespace corral::program {

namespace {

struct Bound_arguments
{
  std::string polynomial;
  std::string box;
  std::string variables;
  std::optional<std::string> point;
  Method method;
};

// Reads X,Y,... and checks that the point lies in the box.
std::vector<Rational> read_point(const std::string& text, const Space& space)
{
  std::vector<Rational> point;
  std::istringstream in(text);
  for (std::string coordinate; std::getline(in, coordinate, ',');) {
    coordinate.erase(0, coordinate.find_first_not_of(' '));
    try {
      point.push_back(parse_rational(coordinate));
    } catch (const Parse_error& error) {
      throw Invalid_input(std::string("at: ") + error.what());
    }
  }
  if (point.size() != space.sides.size())
    throw Invalid_input("at: given " + detail::quantity(point.size(), "coordinate") + "; expected "
                        + std::to_string(space.sides.size()) + ", one for each side of the box");
  for (std::size_t axis = 0; axis < point.size(); ++axis)
    if (!contains(space.sides[axis], point[axis]))
      throw Invalid_input("at: coordinate " + std::to_string(axis + 1) + " is " + to_string(point[axis])
                          + "; expected a point of the box");
  return point;
}

void print(const Value_answer& at_point)
{
  std::cout << "value:   " << to_string(at_point.value) << '\n'
            << (at_point.is_contained ? "the bound contains the value\n"
                                      : "ESCAPE: the bound does not contain the value at this point of the box\n");
}

void print(const Bound_answer& answer, const std::string& number)
{
  std::cout << "polynomial: " << answer.polynomial << '\n'
            << "exact:   " << answer.exact << '\n'
            << "decimal: " << answer.decimal << '\n';
  if (answer.counts != Operation_counts{})
    std::cout << "counted: " << answer.counts.additions << " additions, " << answer.counts.multiplications
              << " multiplications\n";
  if (!answer.is_guaranteed)
    std::cout << "note: not guaranteed: " << number << " rounds to nearest, so that values may lie outside\n";
  if (answer.at_point) print(*answer.at_point);
}

void bound_command(const Bound_arguments& arguments)
{
  const Method& method = arguments.method;
  const Formula formula = single_formula_of(arguments.polynomial);
  Bound_problem problem{read_space(arguments.box, arguments.variables, {formula}), formula, method, {}};
  if (arguments.point) problem.point = read_point(*arguments.point, problem.space);
  const Mpfr_precision_scope precision(method.precision);
  const auto answer =
      Number_types::visit(method.number, [&]<class I>(std::type_identity<I>) { return bound_over<I>(problem); });
  print(answer, method.number);
  if (answer.at_point && !answer.at_point->is_contained) throw CLI::RuntimeError(1);
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
  command->add_option("--variables", arguments->variables,
                      "names of the axes in order (else x, y, z; see doc/input.md)");
  add_method_options(*command, arguments->method);
  command->add_option("--at", arguments->point,
                      "X,Y,...: a point of the box; says whether the bound contains the exact value there");
  command->footer("Prints the interval exactly, as fractions or hexadecimal floats, and in decimals rounded outward.\n"
                  "Exit codes: 0 done, 1 failed or the bound does not contain the value at the point, 2 bad usage.\n"
                  "Examples:\n"
                  "  corral bound 'x^2 - x*y' --box 0:1,0:1\n"
                  "  corral bound 'x^3 - 1/3' --box -1:1 --bounder bernstein --number rational");
  command->callback([arguments] { bound_command(*arguments); });
}

} // namespace corral::program
