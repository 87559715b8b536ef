// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_PROGRAM_FORMULA_H
#define CORRAL_PROGRAM_FORMULA_H

#include <corral/errors.h>
#include <corral/polynomial/parse.h>

#include <cstddef>
#include <string>
#include <vector>

namespace corral::program {

/// The text of a polynomial, and where it is.
struct Formula
{
  Formula(std::string content) : text(std::move(content)) {} // NOLINT: a text is a formula
  Formula(std::string content, std::string place, std::size_t first)
      : text(std::move(content)), file(std::move(place)), line(first)
  {}

  std::string text;
  std::string file{};   ///< such as "file 'a.txt'"; empty: an argument of the program
  std::size_t line = 1; ///< where the text begins in the file
};

/// What cannot be read in a file, and the line with a caret under the place.
struct Formula_error : Invalid_input
{
  Formula_error(const std::string& message, std::string marked) : Invalid_input(message), excerpt(std::move(marked)) {}
  std::string excerpt; ///< two lines
};

/// \brief The formulas of the arguments: of each argument itself, or of FILE for `@FILE` (`@-` is standard input), one
/// a line. A formula goes on in the next line while a parenthesis is open, or behind `\`, `=` and operators.
/// \throw Invalid_input if a file cannot be read, is larger than 64 MiB or has no formula.
[[nodiscard]] std::vector<Formula> formulas_of(const std::vector<std::string>& arguments);

/// The one formula of an argument. \throw Invalid_input as `formulas_of`, and if there are several.
[[nodiscard]] Formula single_formula_of(const std::string& argument);

[[nodiscard]] std::vector<std::string> texts_of(const std::vector<Formula>& formulas);

/// \throw Formula_error that says the same of a formula in a file; else the error itself.
[[noreturn]] void fail_in(const Formula& formula, const detail::Polynomial_error& error);

/// `function(text)`, with errors that say where in a file they are.
template <class Function>
[[nodiscard]] auto read_formula(const Formula& formula, const Function& function)
{
  try {
    return function(formula.text);
  } catch (const detail::Polynomial_error& error) {
    fail_in(formula, error);
  }
}

} // namespace corral::program

#endif
