// SPDX-License-Identifier: LGPL-3.0-or-later
#include "html.h"

#include <cctype>

namespace corral::program {

namespace {

std::string_view take_digits(std::string_view& text)
{
  std::size_t length = 0;
  while (length < text.size() && std::isdigit(static_cast<unsigned char>(text[length])) != 0) ++length;
  const std::string_view digits = text.substr(0, length);
  text.remove_prefix(length);
  return digits;
}

// The decimal of numerator / 10^zeros.
std::string decimal(std::string_view numerator, std::size_t zeros)
{
  std::string digits(zeros + 1 > numerator.size() ? zeros + 1 - numerator.size() : 0, '0');
  digits += numerator;
  const std::size_t whole = digits.size() - zeros;
  std::string result = digits.substr(0, whole);
  result += '.';
  result += digits.substr(whole);
  result.resize(result.find_last_not_of('0') + 1);
  if (result.back() == '.') result.pop_back();
  return result;
}

// Reads a number and a divisor behind it.
std::string take_number(std::string_view& text)
{
  const std::string_view numerator = take_digits(text);
  if (text.empty() || text[0] != '/') return std::string(numerator);
  text.remove_prefix(1);
  const std::string_view denominator = take_digits(text);
  if (denominator.size() > 1 && denominator[0] == '1'
      && denominator.find_first_not_of('0', 1) == std::string_view::npos)
    return decimal(numerator, denominator.size() - 1);
  return "<sup>" + std::string(numerator) + "</sup>&frasl;<sub>" + std::string(denominator) + "</sub>";
}

} // namespace

std::string polynomial_html(std::string_view text)
{
  std::string result;
  while (!text.empty()) {
    const char first = text[0];
    if (std::isdigit(static_cast<unsigned char>(first)) != 0) {
      result += take_number(text);
      continue;
    }
    text.remove_prefix(1);
    if (first == '^')
      result.append("<sup>").append(take_digits(text)).append("</sup>");
    else if (std::isalpha(static_cast<unsigned char>(first)) != 0)
      result.append("<i>").append(1, first).append("</i>");
    else if (first == '-')
      result += "&minus;";
    else if (first != '*')
      result += first;
  }
  return result;
}

} // namespace corral::program
