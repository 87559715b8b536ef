// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_INTERNAL_POLYNOMIAL_POLYNOMIAL_PARSER_H
#define CORRAL_INTERNAL_POLYNOMIAL_POLYNOMIAL_PARSER_H

#include <corral/errors.h>
#include <corral/internal/polynomial/Polynomial_lexer.h>
#include <corral/internal/polynomial/Polynomial_sum.h>
#include <corral/polynomial/Rational_function.h>
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

namespace detail {

/// The parser, with a stack of its own: one level for each open parenthesis.
template <std::size_t D>
class Polynomial_parser
{
public:
  using Result = Polynomial<Rational, D>;
  using Quotient = Rational_function<D>;

  Polynomial_parser(std::string_view text, const std::array<std::string, D>& variables)
      : lexer_(text, {variables.begin(), variables.end()}), variables_(variables)
  {
    for (std::size_t axis = 0; axis < D; ++axis) {
      if (!is_variable_name(variables[axis]))
        throw Invalid_input("parse_polynomial: variable name '" + printable_excerpt(variables[axis], 0)
                            + "'; expected a letter or _, then letters, digits or _");
      if (std::find(variables.begin(), variables.begin() + axis, variables[axis]) != variables.begin() + axis)
        throw Invalid_input("parse_polynomial: variable name '" + variables[axis] + "' given twice");
    }
  }

  /// The left side of an equation less the right side.
  Quotient parse()
  {
    levels_.emplace_back();
    while (true) {
      read_operand();
      while (lexer_.token().kind == Token::close) close_parenthesis();
      if (!read_operator()) break;
    }
    return finish_level();
  }

  /// The same. \throw Parse_error if something is divided by a polynomial.
  Result parse_polynomial()
  {
    Quotient quotient = parse();
    if (first_divisor_)
      lexer_.fail("division by a polynomial; expected a number as divisor, or both sides multiplied by it",
                  *first_divisor_);
    return std::move(quotient.numerator);
  }

private:
  /// What is known of the sum inside one pair of parentheses.
  struct Level
  {
    Polynomial_sum<D> sum;            // of the terms without divisors
    std::optional<Quotient> fraction; // the sum of the others
    std::optional<Quotient> product;  // of the factors of the current term
    bool is_negative = false;         // the sign of the current term
    bool divides = false;             // whether the next factor is a divisor
    std::size_t position = 0;         // of the parenthesis
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
      multiply_by(raised({constant<Rational, D>(lexer_.number())}, operand.position), operand.position);
    else if (operand.kind == Token::name)
      multiply_by(raised({variable<Rational, D>(axis_of(operand))}, operand.position), operand.position);
    else
      lexer_.fail(std::string("expected a number, a variable or ( here")
                      + (operand.kind == Token::times ? "; powers are written x^2" : ""),
                  operand.position);
  }

  /// \pre It is one of the variables: the lexer lets no other name pass.
  std::size_t axis_of(const Token& name) const
  {
    return static_cast<std::size_t>(std::find(variables_.begin(), variables_.end(), name.text) - variables_.begin());
  }

  /// Steps over the operand and an exponent behind it.
  Quotient raised(Quotient operand, std::size_t position)
  {
    lexer_.advance();
    if (lexer_.token().kind != Token::caret) return operand;
    const unsigned exponent = lexer_.exponent();
    if (!operand.has_poles()) return {raised_polynomial(std::move(operand.numerator), exponent, position)};
    Result poles = raised_polynomial(operand.denominator, std::max(exponent, 1U), position);
    // The zeroth power is 1, but where it is not defined.
    Result values = exponent == 0 ? poles : raised_polynomial(std::move(operand.numerator), exponent, position);
    return {std::move(values), std::move(poles)};
  }

  Result raised_polynomial(Result operand, unsigned exponent, std::size_t position)
  {
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

  void multiply_by(Quotient factor, std::size_t position)
  {
    Level& level = levels_.back();
    if (level.divides) factor = inverse(std::move(factor), position);
    level.product = level.product ? product(*level.product, factor, position) : std::move(factor);
  }

  /// Not defined where the divisor is zero, nor where it is not defined itself.
  Quotient inverse(Quotient divisor, std::size_t position)
  {
    if (divisor.numerator.is_zero()) lexer_.fail("division by zero", position);
    if (divisor.numerator.is_constant() && !divisor.has_poles())
      return {constant<Rational, D>(1 / divisor.numerator.terms().front().coefficient)};
    if (!first_divisor_) first_divisor_ = position;
    const Quotient poles{divisor.denominator, divisor.denominator};
    return product({divisor.denominator, divisor.numerator}, poles, position);
  }

  Quotient product(const Quotient& f, const Quotient& g, std::size_t position)
  {
    return {product(f.numerator, g.numerator, position),
            f.has_poles() || g.has_poles() ? product(f.denominator, g.denominator, position) : f.denominator};
  }

  Result product(const Result& f, const Result& g, std::size_t position)
  {
    for (std::size_t axis = 0; axis < D; ++axis) check_degree(f.degree(axis) + g.degree(axis), axis, position);
    return within_budget(position, [&] { return product(f, g); });
  }

  Quotient sum(Quotient f, const Quotient& g, std::size_t position)
  {
    if (f.denominator == g.denominator) return {f.numerator + g.numerator, std::move(f.denominator)};
    return {product(f.numerator, g.denominator, position) + product(g.numerator, f.denominator, position),
            product(f.denominator, g.denominator, position)};
  }

  /// Adds the current term to the sum of its level.
  void finish_term()
  {
    Level& level = levels_.back();
    Quotient term = std::move(*level.product);
    if (level.is_negative != (is_right_side_ && levels_.size() == 1)) term.numerator = -term.numerator;
    if (!term.has_poles())
      level.sum.add(std::move(term.numerator));
    else
      level.fraction = level.fraction ? sum(std::move(*level.fraction), term, level.position) : std::move(term);
    level.product.reset();
    level.is_negative = level.divides = false;
  }

  Quotient finish_level()
  {
    finish_term();
    Level& level = levels_.back();
    Quotient result{level.sum.take()};
    spend(500.0 * static_cast<double>(level.sum.terms_sorted()), level.position);
    if (level.fraction) result = sum(std::move(*level.fraction), result, level.position);
    levels_.pop_back();
    return result;
  }

  void close_parenthesis()
  {
    const std::size_t position = levels_.back().position;
    if (levels_.size() == 1) lexer_.fail("this ) has no (", lexer_.token().position);
    Quotient inner = finish_level();
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
    case Token::equals:
      if (levels_.size() > 1) lexer_.fail("an equation within parentheses", token.position);
      if (is_right_side_) lexer_.fail("a second equals sign; expected one at most", token.position);
      finish_term();
      is_right_side_ = true;
      break;
    case Token::end:
      if (levels_.size() > 1) lexer_.fail("this ( has no )", levels_.back().position);
      return false;
    default: // a caret, as all else makes a product
      lexer_.fail("a second exponent; 'x^a^b' may be (x^a)^b or x^(a^b); expected parentheses, as in (x^2)^3",
                  token.position);
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
  bool is_right_side_ = false;
  std::optional<std::size_t> first_divisor_; // that is a polynomial
  double work_ = 0;
};

} // namespace detail

} // namespace corral

#endif
