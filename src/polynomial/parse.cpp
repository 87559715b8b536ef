// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/errors.h>
#include <corral/polynomial/Polynomial_lexer.h>
#include <corral/polynomial/parse.h>

#include <algorithm>
#include <optional>
#include <set>

namespace corral {
namespace detail {

namespace {

// The functions of <cctype> depend on the locale.
bool is_digit(char c) { return '0' <= c && c <= '9'; }
bool is_letter(char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || c == '_'; }
bool is_hex_digit(char c) { return is_digit(c) || ('a' <= c && c <= 'f') || ('A' <= c && c <= 'F'); }
bool is_space(char c) { return c == ' ' || ('\t' <= c && c <= '\r'); }

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
  constexpr std::string_view marks = "+-*/^()";
  constexpr Token::Kind kinds[] = {Token::plus,  Token::minus, Token::times, Token::slash,
                                   Token::caret, Token::open,  Token::close};
  const auto found = marks.find(c);
  return found == std::string_view::npos ? std::nullopt : std::optional(kinds[found]);
}

} // namespace

bool is_variable_name(std::string_view text)
{
  if (text.empty() || !is_letter(text.front())) return false;
  for (const char c : text)
    if (!is_letter(c) && !is_digit(c)) return false;
  return true;
}

std::string printable_excerpt(std::string_view text, std::size_t position)
{
  constexpr std::size_t length = 30;
  std::string excerpt;
  for (const char c : text.substr(position, length)) excerpt += escaped(c);
  if (text.size() > position + length) excerpt += "...";
  return excerpt;
}

Polynomial_lexer::Polynomial_lexer(std::string_view text) : text_(text) { advance(); }

void Polynomial_lexer::advance()
{
  std::size_t begin = token_.position + token_.text.size();
  while (is_space(at(begin))) ++begin;
  token_ = {Token::end, {}, begin};
  if (begin == text_.size()) return;
  const char c = at(begin);
  std::size_t end = begin + 1;
  if (is_digit(c) || (c == '.' && is_digit(at(end)))) {
    token_.kind = Token::number;
    end = end_of_number(begin);
  } else if (is_letter(c)) {
    token_.kind = Token::name;
    while (is_letter(at(end)) || is_digit(at(end))) ++end;
    refuse_call(begin, end);
  } else if (const auto mark = kind_of_mark(c))
    token_.kind = *mark;
  else if (c == '=')
    fail("an equation; expected a polynomial, as x - y for x = y", begin);
  else
    fail(std::string("a polynomial is ASCII text without '") + escaped(c) + "'", begin);
  token_.text = text_.substr(begin, end - begin);
}

void Polynomial_lexer::refuse_call(std::size_t begin, std::size_t end) const
{
  while (is_space(at(end))) ++end;
  if (at(end) == '(') fail("implicit product or function; expected * before the (", begin);
}

std::size_t Polynomial_lexer::end_of_number(std::size_t begin) const
{
  std::size_t end = begin;
  const bool is_hex = at(begin) == '0' && (at(begin + 1) == 'x' || at(begin + 1) == 'X') && is_hex_digit(at(begin + 2));
  if (is_hex) {
    for (end += 2; is_hex_digit(at(end)) || at(end) == '.';) ++end;
  } else {
    while (is_digit(at(end)) || at(end) == '.') ++end;
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
  advance();
  const Token token = token_;
  constexpr std::size_t max_digits = 9;
  if (token.kind != Token::number || !std::all_of(token.text.begin(), token.text.end(), is_digit))
    fail("an exponent must be a whole number, 0 or more, written in digits", token.position);
  if (token.text.size() > max_digits)
    fail("exponent of " + std::to_string(token.text.size()) + " digits; expected at most " + std::to_string(max_digits),
         token.position);
  advance();
  return static_cast<unsigned>(std::stoul(std::string(token.text)));
}

std::string Polynomial_lexer::located(const std::string& message, std::size_t position) const
{
  return "polynomial, column " + std::to_string(position + 1) + ": " + message
         + (position < text_.size() ? ": '" + printable_excerpt(text_, position) + "'" : " (the text ends)");
}

void Polynomial_lexer::fail(const std::string& message, std::size_t position) const
{
  throw Parse_error(located(message, position), position);
}

void Polynomial_lexer::fail_budget(std::size_t position) const
{
  throw Budget_exceeded(located("the expanded polynomial has too many terms or digits", position));
}

} // namespace detail

std::vector<std::string> variables_in(std::string_view text)
{
  std::set<std::string, std::less<>> names;
  for (detail::Polynomial_lexer lexer(text); lexer.token().kind != detail::Token::end; lexer.advance())
    if (lexer.token().kind == detail::Token::name) names.emplace(lexer.token().text);
  return {names.begin(), names.end()};
}

} // namespace corral
