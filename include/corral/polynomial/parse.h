// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_POLYNOMIAL_PARSE_H
#define CORRAL_POLYNOMIAL_PARSE_H

#include <corral/errors.h>
#include <corral/polynomial/Polynomial_lexer.h>
#include <corral/polynomial/Polynomial_sum.h>
#include <corral/polynomial/arithmetic.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace corral {

/// The highest degree in one variable that a parsed polynomial may have.
inline constexpr unsigned max_parsed_degree = 1000;

/// \brief The names of all variables in the text of a polynomial, in alphabetical order.
/// \throw Parse_error if the text has a character that no polynomial has.
[[nodiscard]] std::vector<std::string> variables_in(std::string_view text);

namespace detail {

/// The parser, with a stack of its own: one level for each open parenthesis.
template <std::size_t D>
class Polynomial_parser
{
public:
  using Result = Polynomial<Rational, D>;

  Polynomial_parser(std::string_view text, const std::array<std::string, D>& variables)
      : lexer_(text), variables_(variables)
  {
    for (std::size_t axis = 0; axis < D; ++axis) {
      if (!is_variable_name(variables[axis]))
        throw Invalid_input("parse_polynomial: variable name '" + printable_excerpt(variables[axis], 0)
                            + "'; expected a letter or _, then letters, digits or _");
      if (std::find(variables.begin(), variables.begin() + axis, variables[axis]) != variables.begin() + axis)
        throw Invalid_input("parse_polynomial: variable name '" + variables[axis] + "' given twice");
    }
  }

  Result parse()
  {
    levels_.emplace_back();
    while (true) {
      read_operand();
      while (lexer_.token().kind == Token::close) close_parenthesis();
      if (!read_operator()) break;
    }
    return finish_level();
  }

private:
  /// What is known of the sum inside one pair of parentheses.
  struct Level
  {
    Polynomial_sum<D> sum;
    std::optional<Result> product; // of the factors of the current term
    bool is_negative = false;      // the sign of the current term
    bool divides = false;          // whether the next factor is a divisor
    std::size_t position = 0;      // of the parenthesis
  };

  /// Signs and opening parentheses, then one number or variable.
  void read_operand()
  {
    for (;; lexer_.advance()) {
      const Token& token = lexer_.token();
      if (token.kind == Token::open) {
        levels_.emplace_back();
        levels_.back().position = token.position;
      } else if (token.kind == Token::minus)
        levels_.back().is_negative = !levels_.back().is_negative;
      else if (token.kind != Token::plus)
        break;
    }
    const Token operand = lexer_.token();
    if (operand.kind == Token::number)
      multiply_by(raised(constant<Rational, D>(lexer_.number()), operand.position), operand.position);
    else if (operand.kind == Token::name)
      multiply_by(raised(variable<Rational, D>(axis_of(operand)), operand.position), operand.position);
    else
      lexer_.fail(std::string("expected a number, a variable or ( here")
                      + (operand.kind == Token::times ? "; powers are written x^2" : ""),
                  operand.position);
  }

  std::size_t axis_of(const Token& name) const
  {
    const auto found = std::find(variables_.begin(), variables_.end(), name.text);
    if (found != variables_.end()) return static_cast<std::size_t>(found - variables_.begin());
    std::string known = variables_[0];
    for (std::size_t axis = 1; axis < D; ++axis) known += ", " + variables_[axis];
    lexer_.fail("unknown variable '" + printable_excerpt(name.text, 0) + "'; the variables are " + known,
                name.position);
  }

  /// Steps over the operand and an exponent behind it.
  Result raised(Result operand, std::size_t position)
  {
    lexer_.advance();
    if (lexer_.token().kind != Token::caret) return operand;
    const unsigned exponent = lexer_.exponent();
    if (operand.is_constant()) {
      if (exponent > max_parsed_degree * 100)
        lexer_.fail("exponent " + std::to_string(exponent) + " of a number; expected at most "
                        + std::to_string(max_parsed_degree * 100),
                    position);
    } else
      for (std::size_t axis = 0; axis < D; ++axis)
        check_degree(double(operand.degree(axis)) * exponent, axis, position);
    if (least_words_of_power(operand, exponent) > Product_budget{}.max_words) lexer_.fail_budget(position);
    return within_budget(position, [&] { return raise(std::move(operand), exponent); });
  }

  /// The powers of the first and the last term stand alone in the result.
  static double least_words_of_power(const Result& f, unsigned exponent)
  {
    double bits = 0;
    if (!f.is_zero())
      for (const Rational& c : {f.terms().front().coefficient, f.terms().back().coefficient})
        bits = std::max(bits, least_bits(c.get_num()) + least_bits(c.get_den()));
    return exponent * bits / 64;
  }

  static double least_bits(const Integer& c) { return static_cast<double>(mpz_sizeinbase(c.get_mpz_t(), 2)) - 1; }

  Result raise(Result f, unsigned exponent)
  {
    Result result = constant<Rational, D>(1);
    for (;; f = product(f, f)) {
      if (exponent % 2 != 0) result = product(result, f);
      exponent /= 2;
      if (exponent == 0) return result;
    }
  }

  void multiply_by(Result factor, std::size_t position)
  {
    Level& level = levels_.back();
    if (level.divides) {
      if (!factor.is_constant()) lexer_.fail("division by a polynomial; expected a number as divisor", position);
      if (factor.is_zero()) lexer_.fail("division by zero", position);
      factor = constant<Rational, D>(1 / factor.terms().front().coefficient);
    }
    if (!level.product) {
      level.product = std::move(factor);
      return;
    }
    for (std::size_t axis = 0; axis < D; ++axis)
      check_degree(level.product->degree(axis) + factor.degree(axis), axis, position);
    level.product = within_budget(position, [&] { return product(*level.product, factor); });
  }

  /// Adds the current term to the sum of its level.
  void finish_term()
  {
    Level& level = levels_.back();
    level.sum.add(level.is_negative ? -*level.product : std::move(*level.product));
    level.product.reset();
    level.is_negative = level.divides = false;
  }

  Result finish_level()
  {
    finish_term();
    Result sum = levels_.back().sum.take();
    spend(500.0 * static_cast<double>(levels_.back().sum.terms_sorted()), levels_.back().position);
    levels_.pop_back();
    return sum;
  }

  void close_parenthesis()
  {
    const std::size_t position = levels_.back().position;
    if (levels_.size() == 1) lexer_.fail("this ) has no (", lexer_.token().position);
    Result inner = finish_level();
    multiply_by(raised(std::move(inner), position), position);
  }

  /// Reads the operator before the next operand; false at the end of the text.
  bool read_operator()
  {
    const Token token = lexer_.token();
    switch (token.kind) {
    case Token::plus:
    case Token::minus:
      finish_term();
      levels_.back().is_negative = token.kind == Token::minus;
      break;
    case Token::times:
    case Token::slash:
      levels_.back().divides = token.kind == Token::slash;
      break;
    case Token::end:
      if (levels_.size() > 1) lexer_.fail("this ( has no )", levels_.back().position);
      return false;
    case Token::caret:
      lexer_.fail("a second exponent; expected parentheses, as in (x^2)^3", token.position);
    default:
      lexer_.fail("implicit product; expected * between factors", token.position);
    }
    lexer_.advance();
    return true;
  }

  void check_degree(double degree, std::size_t axis, std::size_t position) const
  {
    if (degree > max_parsed_degree)
      lexer_.fail("degree " + std::to_string(static_cast<unsigned long>(degree)) + " in " + variables_[axis]
                      + "; expected at most " + std::to_string(max_parsed_degree),
                  position);
  }

  Result product(const Result& f, const Result& g)
  {
    work_ += product_work(f, g);
    Product_budget budget;
    budget.max_work -= work_;
    return multiply(f, g, budget);
  }

  void spend(double work, std::size_t position)
  {
    work_ += work;
    if (work_ > Product_budget{}.max_work) lexer_.fail_budget(position);
  }

  template <class Function>
  Result within_budget(std::size_t position, const Function& function)
  {
    try {
      return function();
    } catch (const Budget_exceeded&) {
      lexer_.fail_budget(position);
    }
  }

  Polynomial_lexer lexer_;
  std::array<std::string, D> variables_;
  std::vector<Level> levels_;
  double work_ = 0;
};

} // namespace detail

/// \brief Reads a polynomial exactly.
///
/// Sums, differences and products (`*` is always written), parentheses, powers by whole numbers,
/// division by a number other than zero; numbers as `parse_rational` reads them: `15/4*x^2 - 0.1*(x + y)^3`.
/// `-x^2` is -(x^2).
///
/// \throw Parse_error with the column and an excerpt, for text that is no polynomial in these
///        variables or has a degree above `max_parsed_degree` in one of them.
/// \throw Budget_exceeded if its expanded form would take too much memory or time.
/// \throw Invalid_input if a variable name is none or is given twice.
/// \par Complexity  That of the products written in the text; parentheses may be nested to any depth.
template <std::size_t D>
[[nodiscard]] Polynomial<Rational, D> parse_polynomial(std::string_view text,
                                                       const std::array<std::string, D>& variables)
{
  return detail::Polynomial_parser<D>(text, variables).parse();
}

} // namespace corral

#endif
