// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_POLYNOMIAL_POLYNOMIAL_LEXER_H
#define CORRAL_POLYNOMIAL_POLYNOMIAL_LEXER_H

#include <corral/number/Rational.h>

#include <cstddef>
#include <string>
#include <string_view>

/// \file
/// The words of a polynomial's text, and the errors that point into it.
namespace corral::detail {

/// One word of the text.
struct Token
{
  enum Kind { number, name, plus, minus, times, slash, caret, open, close, end };
  Kind kind = end;
  std::string_view text;
  std::size_t position = 0; ///< offset in bytes
};

/// Whether `text` is a letter or _, then letters, digits or _ (ASCII).
[[nodiscard]] bool is_variable_name(std::string_view text);

/// About thirty characters from `position` on, everything but printable ASCII escaped.
[[nodiscard]] std::string printable_excerpt(std::string_view text, std::size_t position);

/// Walks over the words of a text, which must outlive it.
class Polynomial_lexer
{
public:
  /// Stands on the first word. \throw Parse_error as `advance`.
  explicit Polynomial_lexer(std::string_view text);

  [[nodiscard]] const Token& token() const { return token_; }

  /// Steps to the next word. \throw Parse_error on a character that starts none, or a name before a parenthesis.
  void advance();

  /// The value of the current word. \pre It is a number.
  [[nodiscard]] Rational number() const;

  /// Reads the whole number behind a caret and steps over it. \pre The current word is a caret.
  [[nodiscard]] unsigned exponent();

  /// \throw Parse_error always: one line with the column and an excerpt.
  [[noreturn]] void fail(const std::string& message, std::size_t position) const;

  /// \throw Budget_exceeded always, in the same form.
  [[noreturn]] void fail_budget(std::size_t position) const;

private:
  [[nodiscard]] std::string located(const std::string& message, std::size_t position) const;
  /// Refuses a name from `begin` to `end` with a parenthesis behind it, as in sin(x).
  void refuse_call(std::size_t begin, std::size_t end) const;
  [[nodiscard]] std::size_t end_of_number(std::size_t begin) const;
  [[nodiscard]] char at(std::size_t position) const { return position < text_.size() ? text_[position] : '\0'; }

  std::string_view text_;
  Token token_;
};

} // namespace corral::detail

#endif
