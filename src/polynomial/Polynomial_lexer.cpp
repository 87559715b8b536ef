// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/errors.h>
#include <corral/internal/polynomial/Polynomial_lexer.h>

#include "characters.h"
#include "names.h"

#include <algorithm>
#include <utility>

namespace corral::detail {

namespace {

constexpr std::uint32_t byte_order_mark = 0xfeff;

std::string escaped(char c)
{
  if (' ' <= c && c <= '~') return {c};
  static constexpr char digits[] = "0123456789abcdef";
  const auto byte = static_cast<unsigned char>(c);
  return {'\\', 'x', digits[byte / 16], digits[byte % 16]};
}

// What a word of this one character is, if it is any.
std::optional<Token::Kind> kind_of_mark(char c)
{
  constexpr std::string_view marks = "+-*/^()=";
  constexpr Token::Kind kinds[] = {Token::plus,  Token::minus, Token::times, Token::slash,
                                   Token::caret, Token::open,  Token::close, Token::equals};
  const auto found = c == '\0' ? std::string_view::npos : marks.find(c);
  return found == std::string_view::npos ? std::nullopt : std::optional(kinds[found]);
}

bool ends_factor(Token::Kind kind) { return kind == Token::number || kind == Token::name || kind == Token::close; }
bool begins_factor(Token::Kind kind) { return kind == Token::number || kind == Token::name || kind == Token::open; }

} // namespace

bool is_variable_name(std::string_view text)
{
  if (text.empty() || !is_letter(text.front())) return false;
  return std::all_of(text.begin(), text.end(), [](char c) { return is_letter(c) || is_digit(c); });
}

std::string printable_excerpt(std::string_view text, std::size_t position)
{
  constexpr std::size_t length = 30;
  std::string excerpt;
  for (const char c : text.substr(position, length)) excerpt += escaped(c);
  if (text.size() > position + length) excerpt += "...";
  return excerpt;
}

Polynomial_lexer::Polynomial_lexer(std::string_view text, std::vector<std::string> variables)
    : text_(text), variables_(std::move(variables))
{
  if (!text_.empty()) {
    const Character first = character_at(text_, 0);
    if (first.code == byte_order_mark) token_.position = first.length;
  }
  advance();
}

void Polynomial_lexer::advance()
{
  if (held_) {
    token_ = *std::exchange(held_, std::nullopt);
  } else {
    const Token next = next_word();
    if (ends_factor(token_.kind) && begins_factor(next.kind)) {
      require_one_reading(next);
      token_ = {Token::times, {}, next.position};
      held_ = next;
    } else
      token_ = next;
  }
  note_operator(token_);
}

// Divisions, and the parentheses around them.
void Polynomial_lexer::note_operator(const Token& word)
{
  switch (word.kind) {
  case Token::open:
    slashes_.emplace_back();
    break;
  case Token::close:
    if (slashes_.size() > 1) slashes_.pop_back();
    break;
  case Token::slash:
    slashes_.back() = word.position;
    break;
  case Token::plus:
  case Token::minus:
    if (ends_factor(token_before_)) slashes_.back().reset();
    break;
  case Token::times:
  case Token::equals:
    slashes_.back().reset();
    break;
  default:
    break;
  }
  token_before_ = word.kind;
}

Token Polynomial_lexer::next_word()
{
  const std::size_t begin = end_of_blanks(token_.position + token_.text.size());
  if (!ends_of_names_.empty()) { // within a name of several variables
    const std::size_t end = ends_of_names_.back();
    ends_of_names_.pop_back();
    return {Token::name, text_of(begin, end), begin};
  }
  if (begin == text_.size()) return {Token::end, {}, begin};
  const char c = at(begin);
  if (is_digit(c) || (c == '.' && is_digit(at(begin + 1)))) return number_at(begin);
  return is_letter(c) ? name_at(begin) : mark_at(begin);
}

std::string_view Polynomial_lexer::text_of(std::size_t begin, std::size_t end) const
{
  return text_.substr(begin, end - begin);
}

// Blanks of all kinds, comments, and at the end of the text a semicolon.
std::size_t Polynomial_lexer::end_of_blanks(std::size_t begin) const
{
  std::size_t semicolon = text_.size();
  for (std::size_t end = begin; end < text_.size();) {
    const Character character = character_at(text_, end);
    if (ascii_for(character.code) == ' ')
      end += character.length;
    else if (at(end) == '#')
      end = std::min(text_.find_first_of("\r\n", end), text_.size());
    else if (at(end) == ';')
      semicolon = std::min(semicolon, end++);
    else
      return std::min(semicolon, end);
  }
  return text_.size();
}

Token Polynomial_lexer::mark_at(std::size_t begin) const
{
  const Character character = character_at(text_, begin);
  std::size_t end = begin + character.length;
  if (is_superscript(character.code)) {
    while (end < text_.size() && is_superscript(character_at(text_, end).code)) end += character_at(text_, end).length;
    return {Token::caret, text_of(begin, end), begin};
  }
  char c = ascii_for(character.code);
  if (c == '.' && (at(end) == '*' || at(end) == '/' || at(end) == '^')) c = at(end++); // of each entry of a matrix
  auto kind = kind_of_mark(c);
  if (kind == Token::times && at(end) == '*' && at(end - 1) == '*') {
    kind = Token::caret;
    ++end;
  } else if (kind == Token::equals && at(end) == '=')
    ++end;
  if (!kind) fail(why_not(character), begin);
  return {*kind, text_of(begin, end), begin};
}

std::size_t Polynomial_lexer::end_of_name(std::size_t begin) const
{
  std::size_t end = begin;
  while (is_letter(at(end)) || is_digit(at(end))) ++end;
  return end;
}

Token Polynomial_lexer::name_at(std::size_t begin)
{
  const std::size_t end = end_of_name(begin);
  const std::string_view name = text_of(begin, end);
  const bool is_variable = std::find(variables_.begin(), variables_.end(), name) != variables_.end();
  if (!is_variable && is_function_name(name) && at(end_of_blanks(end)) == '(') fail(why_no_polynomial(name), begin);
  if (variables_.empty()) return {Token::name, name, begin};
  auto readings = readings_of(name, variables_);
  if (readings.empty()) refuse_name(name, begin);
  if (readings.size() > 1)
    fail("'" + printable_excerpt(name, 0) + "' may be " + product_text(name, readings[0]) + " or "
             + product_text(name, readings[1]) + "; expected *",
         begin);
  ends_of_names_ = std::move(readings[0]);
  for (std::size_t& place : ends_of_names_) place += begin;
  const std::size_t end_of_first = ends_of_names_.back();
  ends_of_names_.pop_back();
  return {Token::name, text_of(begin, end_of_first), begin};
}

void Polynomial_lexer::refuse_name(std::string_view name, std::size_t position) const
{
  if (is_function_name(name)) fail(why_no_polynomial(name), position);
  std::string known;
  for (const auto& variable : variables_) known += (known.empty() ? "" : ", ") + variable;
  fail("unknown variable '" + printable_excerpt(name, 0) + "'; the variables are " + known
           + what_may_be_meant(name, variables_),
       position);
}

// A product is understood before `next`, if that is the only meaning.
void Polynomial_lexer::require_one_reading(const Token& next) const
{
  const std::size_t end = token_.position + token_.text.size();
  if (next.kind == Token::number) {
    const std::string factor = token_.kind == Token::close ? ")" : printable_excerpt(text_of(token_.position, end), 0);
    const std::string number = printable_excerpt(next.text, 0);
    fail("'" + factor + " " + number + "' may be " + factor + "*" + number
             + (token_.kind == Token::number ? " or one number; expected *" : " or a power; expected * or ^"),
         next.position);
  }
  if (slashes_.back()) {
    const std::size_t slash = *slashes_.back() + 1;
    const std::string divisor = end - slash > 20 ? "b" : printable_excerpt(text_of(end_of_blanks(slash), end), 0);
    const std::string factor = next.kind == Token::open ? "(...)" : printable_excerpt(next.text, 0);
    fail("'a/" + divisor + " " + factor + "' may be (a/" + divisor + ")*" + factor + " or a/(" + divisor + "*" + factor
             + "); expected * or parentheses",
         next.position);
  }
  if (token_.kind == Token::name && next.kind == Token::open) refuse_notation_of_function(next);
}

// x(y) and x(2) are a product to some, a value of a function to others.
void Polynomial_lexer::refuse_notation_of_function(const Token& open) const
{
  const std::size_t begin = end_of_blanks(open.position + 1);
  std::size_t end = end_of_name(begin);
  if (!is_letter(at(begin)) && is_digit(at(begin))) end = end_of_number(begin);
  if (end == begin || at(end_of_blanks(end)) != ')') return;
  const std::string name = printable_excerpt(token_.text, 0);
  const std::string argument = printable_excerpt(text_of(begin, end), 0);
  fail("'" + name + "(" + argument + ")' may be the product " + name + "*" + argument + " or the function " + name
           + " of " + argument + "; expected * or just " + name,
       token_.position);
}

Token Polynomial_lexer::number_at(std::size_t begin) const
{
  const std::size_t end = end_of_number(begin);
  const bool is_hex = end > begin + 1 && (at(begin + 1) == 'x' || at(begin + 1) == 'X');
  if (is_hex && !variables_.empty()) {
    const auto name = text_of(begin + 1, end_of_name(begin + 1));
    if (!readings_of(name, variables_).empty())
      fail("'0" + printable_excerpt(name, 0) + "' may be a hexadecimal number or 0*" + printable_excerpt(name, 0)
               + "; expected *",
           begin);
  }
  return {Token::number, text_of(begin, end), begin};
}

std::size_t Polynomial_lexer::end_of_number(std::size_t begin) const
{
  std::size_t end = begin;
  const bool is_hex = at(begin) == '0' && (at(begin + 1) == 'x' || at(begin + 1) == 'X') && is_hex_digit(at(begin + 2));
  const auto is_point = [&] {
    const char next = at(end + 1);
    return at(end) == '.' && next != '*' && next != '/' && next != '^';
  };
  if (is_hex) {
    for (end += 2; is_hex_digit(at(end)) || is_point();) ++end;
  } else {
    while (is_digit(at(end)) || is_point()) ++end;
  }
  const char mark = at(end);
  if (is_hex ? mark == 'p' || mark == 'P' : mark == 'e' || mark == 'E') {
    const std::size_t sign = at(end + 1) == '+' || at(end + 1) == '-' ? 1 : 0;
    if (is_digit(at(end + 1 + sign)))
      for (end += 1 + sign; is_digit(at(end));) ++end;
  }
  return end;
}

Rational Polynomial_lexer::number() const
{
  try {
    return parse_rational(token_.text);
  } catch (const Parse_error&) {
    fail("'" + printable_excerpt(token_.text, 0) + "' is not a number that can be read exactly", token_.position);
  }
}

unsigned Polynomial_lexer::exponent()
{
  const std::size_t begin = token_.position;
  std::size_t end = begin + token_.text.size();
  const std::string digits = exponent_digits(end);
  constexpr std::size_t max_digits = 9;
  if (digits.size() > max_digits)
    fail("exponent of " + std::to_string(digits.size()) + " digits; expected at most " + std::to_string(max_digits),
         begin + 1);
  token_ = {Token::number, text_of(begin, end), begin};
  token_before_ = Token::number;
  advance();
  return static_cast<unsigned>(std::stoul(digits));
}

// The digits behind the caret that ends at `end`, or of which it consists; `end` moves behind them.
std::string Polynomial_lexer::exponent_digits(std::size_t& end) const
{
  std::string digits;
  for (std::size_t k = token_.position; k < end; k += character_at(text_, k).length)
    if (const auto code = character_at(text_, k).code; is_superscript(code)) digits += ascii_for(code);
  if (!digits.empty()) return digits;
  std::size_t begin = end_of_blanks(end);
  const char bracket = at(begin);
  const bool is_bracketed = bracket == '(' || bracket == '{';
  if (is_bracketed) begin = end_of_blanks(begin + 1);
  end = begin;
  while (is_digit(at(end))) ++end;
  digits = text_of(begin, end);
  const bool is_whole = !digits.empty() && end == (is_letter(at(end)) ? end : end_of_number(begin));
  if (!is_whole)
    fail(std::string("an exponent must be a whole number, 0 or more, written in digits")
             + (at(begin) == '-' ? "; x^-n is written 1/x^n" : ""),
         begin);
  if (!is_bracketed) return digits;
  const std::size_t last = end_of_blanks(end);
  if (at(last) != (bracket == '(' ? ')' : '}'))
    fail("an exponent must be a whole number, 0 or more, written in digits", begin);
  end = last + 1;
  return digits;
}

std::string Polynomial_lexer::located(const std::string& message, std::size_t position) const
{
  const std::string_view before = text_.substr(0, position);
  const std::size_t line = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
  std::size_t column = 1;
  for (std::size_t k = line; k < position; k += character_at(text_, k).length)
    if (character_at(text_, k).code != byte_order_mark) ++column;
  const auto line_number = 1 + std::count(before.begin(), before.end(), '\n');
  return "polynomial, " + (line == 0 ? "" : "line " + std::to_string(line_number) + ", ") + "column "
         + std::to_string(column) + ": " + message
         + (position < text_.size() ? ": '" + printable_excerpt(text_, position) + "'" : " (the text ends)");
}

void Polynomial_lexer::fail(const std::string& reason, std::size_t position) const
{
  throw Polynomial_error(located(reason, position), position, reason);
}

void Polynomial_lexer::fail_budget(std::size_t position) const
{
  throw Budget_exceeded(located("the expanded polynomial has too many terms or digits", position));
}

} // namespace corral::detail
