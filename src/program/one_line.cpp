// SPDX-License-Identifier: LGPL-3.0-or-later
#include "one_line.h"

#include <cstddef>
#include <cstdint>

namespace corral::program {

namespace {

/// The number of bytes of the character in UTF-8 that `text` begins with; 0 if it is none or no printable one.
std::size_t printable_length(std::string_view text)
{
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return first >= 0x20 && first != 0x7f ? 1 : 0;
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4 || text.size() < length) return 0;
  std::uint32_t code = first & (0xffU >> (length + 1));
  for (std::size_t k = 1; k < length; ++k) {
    if ((byte(k) & 0xc0) != 0x80) return 0;
    code = code << 6 | (byte(k) & 0x3fU);
  }
  constexpr std::uint32_t least[] = {0, 0, 0xa0, 0x800, 0x10000}; // below 0xa0: control characters
  const bool is_surrogate = code >= 0xd800 && code < 0xe000;
  const bool turns_text = (code >= 0x200e && code <= 0x200f) || (code >= 0x2028 && code <= 0x202e)
                          || (code >= 0x2066 && code <= 0x2069); // separators and directions
  return code < least[length] || code > 0x10ffff || is_surrogate || turns_text ? 0 : length;
}

} // namespace

std::string one_line(std::string_view text)
{
  constexpr std::size_t longest = 600;
  constexpr char digits[] = "0123456789abcdef";
  std::string line;
  while (!text.empty()) {
    std::size_t length = printable_length(text);
    std::string next(text.substr(0, length));
    if (length == 0) {
      const auto byte = static_cast<unsigned char>(text[0]);
      const bool is_blank = byte == '\n' || byte == '\r' || byte == '\t';
      next = is_blank ? std::string(" ") : std::string("\\x") + digits[byte >> 4] + digits[byte & 15];
      length = 1;
    }
    if (line.size() + next.size() > longest) return line + "...";
    line += next;
    text.remove_prefix(length);
  }
  return line;
}

} // namespace corral::program
