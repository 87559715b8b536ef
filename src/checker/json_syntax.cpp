// SPDX-License-Identifier: LGPL-3.0-or-later
#include "json_syntax.h"

#include "fault.h"

#include <algorithm>
#include <cstdint>

namespace corral_check {
namespace {

constexpr std::size_t max_depth = 16;
constexpr std::size_t max_values = std::size_t{1} << 23;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

int hexadecimal(char c)
{
  if (is_digit(c)) return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

/// The number of four hexadecimal digits; -1 if they are none.
int code_unit(std::string_view digits)
{
  if (digits.size() < 4) return -1;
  int result = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const int digit = hexadecimal(digits[k]);
    if (digit < 0) return -1;
    result = result * 16 + digit;
  }
  return result;
}

bool is_high_surrogate(int unit) { return unit >= 0xd800 && unit < 0xdc00; }
bool is_low_surrogate(int unit) { return unit >= 0xdc00 && unit < 0xe000; }

/// The length of the UTF-8 sequence at the beginning of `bytes`; 0 if there is none.
std::size_t utf8_length(std::string_view bytes)
{
  const auto byte = [&](std::size_t k) { return k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0U; };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t count = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4) return 0;
  for (std::size_t k = 1; k < count; ++k)
    if ((byte(k) & 0xc0U) != 0x80) return 0;
  const unsigned second = byte(1);
  const bool is_overlong = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
  const bool is_no_character = (first == 0xed && second >= 0xa0) || (first == 0xf4 && second >= 0x90);
  return is_overlong || is_no_character ? 0 : count;
}

void append_utf8(std::string& text, unsigned code)
{
  const auto add = [&](unsigned byte) { text += static_cast<char>(static_cast<unsigned char>(byte)); };
  if (code < 0x80) return add(code);
  if (code < 0x800)
    add(0xc0 | code >> 6);
  else if (code < 0x10000) {
    add(0xe0 | code >> 12);
    add(0x80 | (code >> 6 & 0x3f));
  } else {
    add(0xf0 | code >> 18);
    add(0x80 | (code >> 12 & 0x3f));
    add(0x80 | (code >> 6 & 0x3f));
  }
  add(0x80 | (code & 0x3f));
}

/// Reads a whole value and refuses what the specification does not allow.
class Syntax_check
{
public:
  Syntax_check(std::string_view text, std::size_t at) : text_(text), at_(at) {}

  std::size_t value(std::size_t depth)
  {
    limit(++count_ <= max_values, {"json", at_}, "more than 2^23 values");
    switch (peek()) {
    case '[':
      list(depth);
      break;
    case '{':
      object(depth);
      break;
    case '"':
      string();
      break;
    case 'n':
      word("null");
      break;
    case 't':
    case 'f':
      fail("true and false have no place in a certificate");
    default:
      number();
    }
    return at_;
  }

private:
  [[noreturn]] void fail(const char* why) const { reject({"json", at_}, why); }
  [[noreturn]] void fail_syntax() const { fail("not a JSON text"); }

  [[nodiscard]] char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  void take(char expected)
  {
    if (peek() != expected) fail_syntax();
    ++at_;
  }
  void space() { at_ = skip_space(text_, at_); }
  void word(std::string_view expected)
  {
    if (text_.substr(at_, expected.size()) != expected) fail_syntax();
    at_ += expected.size();
  }

  void enter(std::size_t depth) const
  {
    limit(depth < max_depth, {"json", at_}, "lists and objects are nested more than 16 deep");
  }

  void list(std::size_t depth)
  {
    enter(depth);
    take('[');
    space();
    if (peek() != ']') {
      while (true) {
        value(depth + 1);
        space();
        if (peek() != ',') break;
        ++at_;
        space();
      }
    }
    take(']');
  }

  void object(std::size_t depth)
  {
    enter(depth);
    take('{');
    space();
    if (peek() != '}') {
      while (true) {
        string();
        space();
        take(':');
        space();
        value(depth + 1);
        space();
        if (peek() != ',') break;
        ++at_;
        space();
      }
    }
    take('}');
  }

  void string()
  {
    take('"');
    while (peek() != '"') {
      if (at_ >= text_.size() || static_cast<unsigned char>(peek()) < 0x20) fail_syntax();
      if (peek() == '\\') {
        escape();
        continue;
      }
      const std::size_t length = utf8_length(text_.substr(at_, 4));
      if (length == 0) fail("not UTF-8");
      at_ += length;
    }
    ++at_;
  }

  void escape()
  {
    ++at_;
    if (peek() != 'u') {
      if (std::string_view("\"\\/bfnrt").find(peek()) == std::string_view::npos || at_ >= text_.size()) fail_syntax();
      ++at_;
      return;
    }
    const int unit = code_unit(text_.substr(at_ + 1, 4));
    if (unit < 0) fail_syntax();
    const bool is_pair = is_high_surrogate(unit) && text_.substr(at_ + 5, 2) == "\\u"
                         && is_low_surrogate(code_unit(text_.substr(at_ + 7, 4)));
    if (!is_pair && (is_high_surrogate(unit) || is_low_surrogate(unit))) fail("half a surrogate pair");
    at_ += is_pair ? 11 : 5;
  }

  void number()
  {
    const std::size_t begin = at_;
    while (is_digit(peek())) ++at_;
    const auto digits = text_.substr(begin, at_ - begin);
    const bool more = at_ < text_.size() && std::string_view("+-.eE").find(peek()) != std::string_view::npos;
    const bool is_number = !digits.empty() || peek() == '-';
    if (more && is_number) fail("a number is not a natural number; write other numbers as exact text");
    if (digits.empty() || (digits.size() > 1 && digits.front() == '0')) fail_syntax();
    constexpr std::string_view limit = "9223372036854775808"; // 2^63
    if (digits.size() > limit.size() || (digits.size() == limit.size() && digits >= limit))
      fail("a number is 2^63 or more");
  }

  std::string_view text_;
  std::size_t at_;
  std::size_t count_ = 0;
};

std::size_t end_of_string(std::string_view text, std::size_t at)
{
  for (++at; text[at] != '"'; ++at)
    if (text[at] == '\\') ++at;
  return at + 1;
}

} // namespace

std::size_t skip_space(std::string_view text, std::size_t at)
{
  while (at < text.size() && (text[at] == ' ' || text[at] == '\n' || text[at] == '\t' || text[at] == '\r')) ++at;
  return at;
}

std::size_t end_of_checked_value(std::string_view text, std::size_t at) { return Syntax_check(text, at).value(0); }

std::size_t end_of_value(std::string_view text, std::size_t at)
{
  if (text[at] == '"') return end_of_string(text, at);
  if (text[at] != '[' && text[at] != '{') return std::min(text.size(), text.find_first_of(" \n\t\r,]}", at));
  std::size_t depth = 0;
  do {
    if (text[at] == '"') {
      at = end_of_string(text, at);
      continue;
    }
    if (text[at] == '[' || text[at] == '{') ++depth;
    if (text[at] == ']' || text[at] == '}') --depth;
    ++at;
  } while (depth > 0);
  return at;
}

std::string unescaped(std::string_view quoted)
{
  const auto inner = quoted.substr(1, quoted.size() - 2);
  std::string result;
  result.reserve(inner.size());
  for (std::size_t at = 0; at < inner.size(); ++at) {
    if (inner[at] != '\\') {
      result += inner[at];
      continue;
    }
    constexpr std::string_view letters = "bfnrt";
    constexpr std::string_view meanings = "\b\f\n\r\t";
    const char letter = inner[++at];
    if (letter != 'u') {
      const auto known = letters.find(letter);
      result += known == std::string_view::npos ? letter : meanings[known];
      continue;
    }
    auto code = static_cast<unsigned>(code_unit(inner.substr(at + 1)));
    at += 4;
    if (is_high_surrogate(static_cast<int>(code))) {
      code = 0x10000 + ((code - 0xd800) << 10) + (static_cast<unsigned>(code_unit(inner.substr(at + 3))) - 0xdc00);
      at += 6;
    }
    append_utf8(result, code);
  }
  return result;
}

} // namespace corral_check
