// SPDX-License-Identifier: LGPL-3.0-or-later
#include "../Progress.h"
#include "../arguments.h"
#include "../commands.h"
#include "../whole_number.h"

#include <corral/geometry/solve.h>
#include <corral/number/format.h>
#include <corral/polynomial/print.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <iostream>
#include <memory>

namespace corral::program {

namespace {

struct Solve_arguments
{
  std::vector<std::string> polynomials;
  std::string box;
  std::string variables;
  int digits = 15;
  std::string format = "text";
};

// One zero, ready to print.
struct Printed_zero
{
  std::vector<std::string> decimals;
  std::vector<std::string> exact; // fractions, if it is rational
  unsigned multiplicity;
};

// Whether all numbers of an interval begin with the same digits; these.
std::optional<std::string> common_digits(const Rational_interval& x, int digits)
{
  auto text = decimal_below(x.lower(), digits);
  if (text == decimal_below(x.upper(), digits)) return text;
  return std::nullopt;
}

// The digits of a root; it is known as a rational where it is one.
std::string digits_of(Real_root& root, int digits)
{
  for (;;) {
    if (const auto text = common_digits(root.interval(), digits)) return *text;
    root.refine();
  }
}

Printed_zero printed(Real_root root, int digits)
{
  (void)root.make_rational();
  Printed_zero zero{{digits_of(root, digits)}, {}, root.multiplicity()};
  if (root.is_point()) zero.exact = {to_string(root.lower())};
  return zero;
}

Printed_zero printed(Algebraic_point point, int digits)
{
  Printed_zero zero{{}, {}, point.multiplicity()};
  if (const auto exact = point.rational())
    for (const Rational& x : *exact) zero.exact.push_back(to_string(x));
  Integer scale;
  mpz_ui_pow_ui(scale.get_mpz_t(), 10, static_cast<unsigned long>(digits));
  for (const std::size_t axis : {0U, 1U}) {
    std::optional<std::string> text;
    Rational width(1, scale);
    for (int attempt = 0; attempt < 3 && !text; ++attempt, width /= scale) {
      point.refine_to(width);
      text = common_digits(point.box()[axis], digits);
    }
    if (!text) { // a decimal fraction, or next to one
      Real_root root = point.coordinate(axis);
      (void)root.make_rational();
      text = digits_of(root, digits);
    }
    zero.decimals.push_back(*text);
  }
  return zero;
}

struct Printed_zeros
{
  std::vector<std::string> readings; ///< of the polynomials
  std::vector<Printed_zero> zeros;
  std::string common_curve{}; // empty if there is none
};

void print_text(const Printed_zeros& found, const std::vector<std::string>& variables)
{
  for (const auto& zero : found.zeros) {
    for (std::size_t k = 0; k < variables.size(); ++k)
      std::cout << (k == 0 ? "" : "  ") << variables[k] << " = " << zero.decimals[k];
    if (zero.multiplicity > 1) std::cout << "  multiplicity " << zero.multiplicity;
    if (!zero.exact.empty()) {
      std::cout << "  exactly";
      for (const auto& text : zero.exact) std::cout << ' ' << text;
    }
    std::cout << '\n';
  }
  if (!found.common_curve.empty()) std::cout << "and the curve " << found.common_curve << " = 0\n";
  if (found.zeros.empty() && found.common_curve.empty()) std::cout << "no zero\n";
}

void print_csv(const Printed_zeros& found, const std::vector<std::string>& variables)
{
  for (const auto& name : variables) std::cout << name << ',';
  std::cout << "multiplicity\n";
  for (const auto& zero : found.zeros) {
    for (const auto& text : zero.decimals) std::cout << text << ',';
    std::cout << zero.multiplicity << '\n';
  }
}

void print_json(const Printed_zeros& found, const std::vector<std::string>& variables)
{
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const auto& zero : found.zeros) {
    nlohmann::ordered_json entry{{"point", zero.decimals}, {"multiplicity", zero.multiplicity}};
    if (!zero.exact.empty()) entry["exact"] = zero.exact;
    list.push_back(std::move(entry));
  }
  nlohmann::ordered_json result;
  if (found.readings.size() == 1)
    result["polynomial"] = found.readings[0];
  else
    result["polynomial"] = found.readings;
  result.update({{"variables", variables}, {"zeros", std::move(list)}});
  if (!found.common_curve.empty()) result["common_curve"] = found.common_curve;
  std::cout << result.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
}

// The names of the axes: those of the polynomials, and further ones if there are too few for the equations.
Space whole_space(const Solve_arguments& arguments, const std::vector<Formula>& formulas)
{
  const std::size_t count = std::max(names_in(formulas).size(), formulas.size());
  std::string sides = "0:1";
  for (std::size_t k = 1; k < count; ++k) sides += ",0:1";
  return read_space(sides, arguments.variables, formulas);
}

Printed_zeros solved(const Solve_arguments& arguments, const Space& space, const std::vector<Formula>& formulas,
                     const Run_options& run)
{
  const bool bounded = !arguments.box.empty();
  Printed_zeros result;
  if (space.sides.size() == 1 && formulas.size() == 1) {
    const auto interval = bounded ? std::optional(space.sides[0]) : std::nullopt;
    const auto system = polynomials_of<1>(space, formulas);
    result.readings = readings_of<1>(space, system);
    for (const auto& root : solve(system[0], interval, run)) result.zeros.push_back(printed(root, arguments.digits));
  } else if (space.sides.size() == 2 && formulas.size() == 2) {
    const auto system = polynomials_of<2>(space, formulas);
    result.readings = readings_of<2>(space, system);
    const auto box = bounded ? std::optional(box_of<2>(space)) : std::nullopt;
    const auto found = solve(system[0], system[1], box, run);
    for (const auto& point : found.points) result.zeros.push_back(printed(point, arguments.digits));
    if (!found.common_curve.is_constant())
      result.common_curve = to_string(found.common_curve, std::array{space.variables[0], space.variables[1]});
  } else
    throw Invalid_input("solve: given " + detail::quantity(formulas.size(), "polynomial") + " in "
                        + detail::quantity(space.sides.size(), "variable") + "; expected as many as variables, 1 or 2");
  return result;
}

void solve_command(const Solve_arguments& arguments)
{
  const auto formulas = formulas_of(arguments.polynomials);
  const Space space = arguments.box.empty() ? whole_space(arguments, formulas)
                                            : read_space(arguments.box, arguments.variables, formulas);
  Progress progress("solve");
  const auto found = solved(arguments, space, formulas, progress.run());
  if (arguments.format == "csv")
    print_csv(found, space.variables);
  else if (arguments.format == "json")
    print_json(found, space.variables);
  else
    print_text(found, space.variables);
}

} // namespace

void add_solve(CLI::App& app)
{
  const auto arguments = std::make_shared<Solve_arguments>();
  CLI::App* const command = app.add_subcommand("solve", "Find all common zeros of polynomials as points, exactly");
  command
      ->add_option("POLY", arguments->polynomials,
                   "as many polynomials as variables, 1 or 2; @FILE reads one from a file, @- from standard input")
      ->required();
  command->add_option("--box", arguments->box, "LOWER:UPPER for each axis, separated by a comma")
      ->default_str("the whole line or plane");
  command->add_option("--variables", arguments->variables,
                      "names of the axes in order (else x, y, z; see doc/input.md)");
  command->add_option("--digits", arguments->digits, "significant digits to print; the rest is cut off, none is wrong")
      ->check(whole_number(1, 10000))
      ->capture_default_str();
  command->add_option("--format", arguments->format, "text, csv or json")
      ->check(CLI::IsMember({"text", "csv", "json"}))
      ->capture_default_str();
  command->footer("Examples:\n"
                  "  corral solve 'x^3 - 2' --digits 30\n"
                  "  corral solve 'x^2 + y^2 - 1' 'y - x^2' --box 0:1,0:1");
  command->callback([arguments] { solve_command(*arguments); });
}

} // namespace corral::program
