// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_POLYNOMIAL_PARSE_H
#define CORRAL_POLYNOMIAL_PARSE_H

#include <corral/internal/polynomial/Polynomial_parser.h>

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace corral {

/// \brief The names of all variables in the text of a polynomial, in alphabetical order.
///
/// Names are as written: `xy` is one of them, also where `parse_polynomial` reads it as x*y.
/// \throw Parse_error if the text has a character that no polynomial has.
[[nodiscard]] std::vector<std::string> variables_in(std::string_view text);

/// The names x, y and z, as many as there are dimensions. For more there is no order that everybody expects.
template <std::size_t D>
  requires(D <= 3)
[[nodiscard]] std::array<std::string, D> standard_variables()
{
  std::array<std::string, D> names;
  for (std::size_t axis = 0; axis < D; ++axis) names[axis] = std::string(1, static_cast<char>('x' + axis));
  return names;
}

/// \brief Reads a polynomial exactly, or the left side of an equation less the right side.
///
/// Sums, differences, products and powers by whole numbers, parentheses, division by a number other than zero; numbers
/// as `parse_rational` reads them: `15/4*x^2 = 0.1*(x + y)^3`. A product need not be written: `2x(y+1)`; `xy` is x*y,
/// unless it is a variable. Powers may be `**` or superscripts. `-x^2` is -(x^2). Blanks, ends of lines, comments from
/// `#` to the end of the line, a byte order mark, and `;` at the end mean nothing. What can be read in two ways is
/// refused: `1/2x`, `x^2^3`, `y(x)`. All of it: doc/input.md.
///
/// \throw Parse_error with the column and an excerpt, for text that is no polynomial in these variables, or two, or has
///        a degree above `max_parsed_degree` in one of them.
/// \throw Budget_exceeded if its expanded form would take too much memory or time.
/// \throw Invalid_input if a variable name is none or is given twice.
/// \par Complexity  That of the products written in the text; parentheses may be nested to any depth.
template <std::size_t D>
[[nodiscard]] Polynomial<Rational, D> parse_polynomial(std::string_view text,
                                                       const std::array<std::string, D>& variables)
{
  return detail::Polynomial_parser<D>(text, variables).parse_polynomial();
}

/// The same in the `standard_variables`.
template <std::size_t D>
[[nodiscard]] Polynomial<Rational, D> parse_polynomial(std::string_view text)
{
  return parse_polynomial<D>(text, standard_variables<D>());
}

/// \brief The same, but that divisors may be polynomials. The denominator is the product of all of them, so that it is
/// zero exactly where some part of the formula is not defined. \throw As `parse_polynomial`.
template <std::size_t D>
[[nodiscard]] Rational_function<D> parse_rational_function(std::string_view text,
                                                           const std::array<std::string, D>& variables)
{
  return detail::Polynomial_parser<D>(text, variables).parse();
}

namespace detail {

/// The names that are no products of others of them.
[[nodiscard]] std::vector<std::string> without_products(const std::vector<std::string>& names);

/// What may be meant by a name that is none of the variables; empty, or begins with "; ".
[[nodiscard]] std::string meaning_of_name(std::string_view name, const std::vector<std::string>& variables);

} // namespace detail

} // namespace corral

#endif
