// SPDX-License-Identifier: LGPL-3.0-or-later
#include "names.h"

#include "characters.h"

#include <algorithm>
#include <iterator>

namespace corral::detail {

namespace {

constexpr std::string_view function_names[] = {
    "sin",    "cos",   "tan",   "cot",  "sec",   "csc",   "asin",  "acos",  "atan", "arcsin", "arccos",
    "arctan", "atan2", "sinh",  "cosh", "tanh",  "asinh", "acosh", "atanh", "exp",  "log",    "ln",
    "lg",     "log2",  "log10", "sqrt", "cbrt",  "root",  "abs",   "sign",  "sgn",  "min",    "max",
    "floor",  "ceil",  "round", "mod",  "gamma", "hypot", "erf",   "pow",   "frac",
};

std::string shortened(std::string_view text)
{
  constexpr std::size_t longest = 30;
  return std::string(text.substr(0, longest)) + (text.size() > longest ? "..." : "");
}

} // namespace

std::vector<std::vector<std::size_t>> readings_of(std::string_view name, const std::vector<std::string>& variables)
{
  if (std::find(variables.begin(), variables.end(), name) != variables.end()) return {{name.size()}};
  const std::size_t n = name.size();
  std::vector<unsigned char> ways(n + 1, 0); // to read what follows a place, 2 for more
  ways[n] = 1;
  const auto starts = [&](std::size_t k, const std::string& v) { return name.compare(k, v.size(), v) == 0; };
  for (std::size_t k = n; k-- > 0;)
    for (const auto& v : variables)
      if (starts(k, v)) ways[k] = static_cast<unsigned char>(std::min(2, ways[k] + ways[k + v.size()]));
  std::vector<std::vector<std::size_t>> readings(n == 0 ? 0 : ways[0]);
  for (std::size_t r = 0; r < readings.size(); ++r) {
    std::size_t skip = r; // so many readings are before this one
    for (std::size_t k = 0; k < n;)
      for (const auto& v : variables) {
        if (!starts(k, v) || ways[k + v.size()] == 0) continue;
        if (skip >= ways[k + v.size()]) {
          skip -= ways[k + v.size()];
          continue;
        }
        k += v.size();
        readings[r].push_back(k);
        break;
      }
    std::reverse(readings[r].begin(), readings[r].end());
  }
  return readings;
}

std::string product_text(std::string_view name, const std::vector<std::size_t>& ends)
{
  constexpr std::size_t longest = 10;
  std::string text;
  std::size_t begin = 0;
  for (std::size_t k = ends.size(); k-- > 0; begin = ends[k]) {
    if (ends.size() - k > longest) return text + "*...";
    if (!text.empty()) text += '*';
    text += shortened(name.substr(begin, ends[k] - begin));
  }
  return text;
}

bool is_function_name(std::string_view name)
{
  return std::find(std::begin(function_names), std::end(function_names), name) != std::end(function_names);
}

std::string why_no_polynomial(std::string_view function)
{
  const std::string start = "the function " + std::string(function) + " is no polynomial; ";
  if (function == "sqrt") return start + "y = sqrt(a) is y^2 = a where y >= 0";
  if (function == "cbrt") return start + "y = cbrt(a) is y^3 = a";
  if (function == "abs") return start + "b = abs(a) is b^2 = a^2 where b >= 0";
  if (function == "pow") return start + "powers are written x^2";
  return start + "expected sums, products and powers of variables and numbers";
}

std::string what_may_be_meant(std::string_view name, const std::vector<std::string>& variables)
{
  if (name == "pi") return "; pi is not rational and is not read as a number";
  if (name == "e" || name == "E") return "; e is not read as a number, which is not rational";
  if (name == "i" || name == "I") return "; coefficients are real, i is not read as a number";
  if (const auto readings = readings_of(name, variables); !readings.empty())
    return "; a product is written " + product_text(name, readings[0]);
  const auto end_of_letters = std::find_if_not(name.begin(), name.end(), is_letter);
  const std::string letters(name.begin(), end_of_letters);
  const std::string digits(end_of_letters, name.end());
  if (!digits.empty() && digits.size() < 4 && std::all_of(digits.begin(), digits.end(), is_digit)
      && std::find(variables.begin(), variables.end(), letters) != variables.end())
    return "; a power is written " + letters + "^" + digits + ", a product " + digits + "*" + letters;
  return "";
}

} // namespace corral::detail
