// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_POLYNOMIAL_CHARACTERS_H
#define CORRAL_SRC_POLYNOMIAL_CHARACTERS_H

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

/// The characters of formulas, in ASCII and beyond. The functions of <cctype> depend on the locale.
namespace corral::detail {

inline bool is_digit(char c) { return '0' <= c && c <= '9'; }
inline bool is_letter(char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || c == '_'; }
inline bool is_hex_digit(char c) { return is_digit(c) || ('a' <= c && c <= 'f') || ('A' <= c && c <= 'F'); }

/// A character of a text in UTF-8. What is no UTF-8 is a character of one byte with the code `no_code`.
struct Character
{
  static constexpr std::uint32_t no_code = 0xffffffff;
  std::uint32_t code = no_code;
  std::size_t length = 1;
};

/// \pre begin < text.size().
[[nodiscard]] Character character_at(std::string_view text, std::size_t begin);

/// \brief The ASCII that means the same: one of `+-*/` and the blank, a digit for a superscript; the character itself
/// if it is ASCII; '\0' for any other.
[[nodiscard]] char ascii_for(std::uint32_t code);
[[nodiscard]] bool is_superscript(std::uint32_t code);

/// Why no polynomial has this character, and what may be meant. \pre `ascii_for` it is '\0', or it is no word.
[[nodiscard]] std::string why_not(const Character& character);

} // namespace corral::detail

#endif
