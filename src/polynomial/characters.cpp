// SPDX-License-Identifier: LGPL-3.0-or-later
#include "characters.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace corral::detail {

namespace {

struct Equivalent
{
  std::uint32_t code;
  char ascii;
};

constexpr Equivalent equivalents[] = {
    {0x00a0, ' '}, {0x00b7, '*'}, {0x00d7, '*'}, {0x00f7, '/'}, {0x2013, '-'},
    {0x202f, ' '}, {0x2044, '/'}, {0x205f, ' '}, {0x2062, '*'}, {0x2212, '-'},
    {0x2215, '/'}, {0x2217, '*'}, {0x2219, '*'}, {0x22c5, '*'}, {0x3000, ' '},
};

constexpr std::uint32_t superscript_digits[] = {0x2070, 0x00b9, 0x00b2, 0x00b3, 0x2074,
                                                0x2075, 0x2076, 0x2077, 0x2078, 0x2079};

std::string name_of(const Character& character)
{
  constexpr char digits[] = "0123456789ABCDEF";
  if (character.code == Character::no_code) return "a byte that is not UTF-8";
  if (' ' < character.code && character.code <= '~') return {'\'', static_cast<char>(character.code), '\''};
  std::string hex;
  for (std::uint32_t rest = character.code; rest > 0 || hex.size() < 4; rest /= 16) hex.insert(0, 1, digits[rest % 16]);
  return "the character U+" + hex;
}

} // namespace

Character character_at(std::string_view text, std::size_t begin)
{
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[begin + k]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return {first, 1};
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4 || text.size() - begin < length) return {};
  std::uint32_t code = first & (0xffU >> (length + 1));
  for (std::size_t k = 1; k < length; ++k) {
    if ((byte(k) & 0xc0) != 0x80) return {};
    code = code << 6 | (byte(k) & 0x3fU);
  }
  constexpr std::uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
  return code < least[length] ? Character() : Character{code, length};
}

char ascii_for(std::uint32_t code)
{
  if (code < 0x80) return '\t' <= code && code <= '\r' ? ' ' : static_cast<char>(code);
  if (0x2000 <= code && code <= 0x200a) return ' ';
  for (const auto& [known, ascii] : equivalents)
    if (known == code) return ascii;
  const auto* const digit = std::find(std::begin(superscript_digits), std::end(superscript_digits), code);
  return digit == std::end(superscript_digits) ? '\0' : static_cast<char>('0' + (digit - superscript_digits));
}

bool is_superscript(std::uint32_t code) { return code >= 0x80 && is_digit(ascii_for(code)); }

std::string why_not(const Character& character)
{
  switch (character.code) {
  case '<':
  case '>':
  case 0x2264:
  case 0x2265:
    return "an inequality; expected a polynomial or an equation, as the boundary of the region is one";
  case '!':
  case 0x2260:
    return "neither 'not equal' nor a factorial is read; expected a polynomial or an equation";
  case ',':
    return "a comma; decimals have a point, as in 0.5, and each polynomial is an argument or a line of its own";
  case ';':
    return "text behind the ; that ends a polynomial; each is an argument or a line of its own";
  case '|':
    return "an absolute value is no polynomial; |a| = b is a^2 = b^2 where b >= 0";
  case 0x221a:
    return "a root is no polynomial; y = root of a is y^2 = a where y >= 0";
  case 0x03c0:
    return "pi is not rational, so no polynomial with exact coefficients has it; expected a fraction near it";
  case 0x207b:
    return "a negative exponent; x^-n is written 1/x^n";
  case '[':
  case ']':
  case '{':
  case '}':
    return "brackets; expected parentheses, ( and )";
  default:
    return "no polynomial has " + name_of(character) + "; names are of ASCII letters, digits and _";
  }
}

} // namespace corral::detail
