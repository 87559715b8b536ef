// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_INTERNAL_POLYNOMIAL_POLYNOMIAL_LEXER_H
#define CORRAL_INTERNAL_POLYNOMIAL_POLYNOMIAL_LEXER_H

#include <corral/errors.h>
#include <corral/number/Rational.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// \file
/// The words of a polynomial's text, products that are not written among them, and the errors that point into it.
namespace corral::detail {

/// One word of the text.
struct Token
{
  enum Kind { number, name, plus, minus, times, slash, caret, open, close, equals, end };
  Kind kind = end;
  std::string_view text;    ///< empty for a product that is not written
  std::size_t position = 0; ///< offset in bytes
};

/// An error at a place of a polynomial's text, with what is wrong there in `reason`.
struct Polynomial_error : Parse_error
{
  Polynomial_error(const std::string& message, std::size_t where, std::string why)
      : Parse_error(message, where), reason(std::move(why))
  {}
  std::string reason;
};

/// Whether `text` is a letter or _, then letters, digits or _ (ASCII).
[[nodiscard]] bool is_variable_name(std::string_view text);

/// About thirty characters from `position` on, everything but printable ASCII escaped.
[[nodiscard]] std::string printable_excerpt(std::string_view text, std::size_t position);

/// Walks over the words of a text, which must outlive it.
class Polynomial_lexer
{
public:
  /// \brief Stands on the first word. Names are cut into the `variables`, where that is possible in one way; without
  /// any, they are left as they are. \throw Polynomial_error as `advance`.
  explicit Polynomial_lexer(std::string_view text, std::vector<std::string> variables = {});

  [[nodiscard]] const Token& token() const { return token_; }

  /// \brief Steps to the next word, which is `times` without text where a product is understood.
  /// \throw Polynomial_error on a character that starts none, a name that is no product of variables, and wherever the
  ///        text can be read in two ways.
  void advance();

  /// The value of the current word. \pre It is a number.
  [[nodiscard]] Rational number() const;

  /// Reads the whole number behind a caret and steps over it. \pre The current word is a caret.
  [[nodiscard]] unsigned exponent();

  /// \throw Polynomial_error always: one line with the column and an excerpt.
  [[noreturn]] void fail(const std::string& reason, std::size_t position) const;

  /// \throw Budget_exceeded always, in the same form.
  [[noreturn]] void fail_budget(std::size_t position) const;

private:
  [[nodiscard]] std::string located(const std::string& message, std::size_t position) const;
  [[nodiscard]] std::size_t end_of_blanks(std::size_t begin) const;
  [[nodiscard]] std::size_t end_of_number(std::size_t begin) const;
  [[nodiscard]] std::size_t end_of_name(std::size_t begin) const;
  [[nodiscard]] std::string_view text_of(std::size_t begin, std::size_t end) const;
  [[nodiscard]] Token next_word();
  [[nodiscard]] Token name_at(std::size_t begin);
  [[nodiscard]] Token number_at(std::size_t begin) const;
  [[nodiscard]] Token mark_at(std::size_t begin) const;
  void require_one_reading(const Token& next) const;
  void refuse_notation_of_function(const Token& open) const;
  [[noreturn]] void refuse_name(std::string_view name, std::size_t position) const;
  void note_operator(const Token& word);
  [[nodiscard]] std::string exponent_digits(std::size_t& end) const;
  [[nodiscard]] char at(std::size_t position) const { return position < text_.size() ? text_[position] : '\0'; }

  std::string_view text_;
  std::vector<std::string> variables_;
  Token token_;
  Token::Kind token_before_ = Token::end;
  std::optional<Token> held_;              // the word behind a product that is not written
  std::vector<std::size_t> ends_of_names_; // of the variables that follow in the current name, the next one last
  std::vector<std::optional<std::size_t>> slashes_ = {std::nullopt}; // before a factor that is a divisor, in each level
};

} // namespace corral::detail

#endif
