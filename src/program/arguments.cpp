// SPDX-License-Identifier: LGPL-3.0-or-later
#include "arguments.h"

#include <algorithm>
#include <charconv>
#include <set>

namespace corral::program {

namespace {

constexpr std::size_t max_file_size = std::size_t{64} << 20;

std::string trimmed(std::string_view text)
{
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1));
}

std::vector<std::string> split(std::string_view text, char separator)
{
  std::vector<std::string> parts;
  for (;;) {
    const auto end = text.find(separator);
    parts.push_back(trimmed(text.substr(0, end)));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

std::string joined(const std::vector<std::string>& words)
{
  std::string result;
  for (const auto& word : words) result += (result.empty() ? "" : ", ") + word;
  return result;
}

Rational_interval read_side(const std::string& text, std::size_t axis)
{
  const auto ends = split(text, ':');
  const std::string who = "box: side " + std::to_string(axis + 1) + " is '" + text + "'; expected LOWER:UPPER";
  if (ends.size() != 2) throw Invalid_input(who + ", as in -1:1/2");
  try {
    Rational lower = parse_rational(ends[0]);
    Rational upper = parse_rational(ends[1]);
    if (lower > upper) throw Invalid_input(who + " with LOWER <= UPPER");
    return {std::move(lower), std::move(upper)};
  } catch (const Parse_error&) {
    throw Invalid_input(who + " with finite numbers, as in -1:1/2 or 0.25:1e3");
  }
}

void require_variable_names(const std::vector<std::string>& names)
{
  for (auto name = names.begin(); name != names.end(); ++name) {
    if (!detail::is_variable_name(*name))
      throw Invalid_input("variables: given '" + *name + "'; expected a letter or _, then letters, digits or _");
    if (std::find(names.begin(), name, *name) != name)
      throw Invalid_input("variables: given '" + *name + "' twice; expected different names");
  }
}

// The names that need no explanation.
const std::vector<std::string> standard_names{"x", "y", "z"};

// Whether mathematicians write variables so: one letter, but for numbers with a name.
bool is_letter(const std::string& name) { return name.size() == 1 && name != "e" && name != "i" && name != "_"; }

// A letter and a number, as x1. Beside x itself, it may be a power or a product.
bool is_letter_with_index(const std::string& name)
{
  return name.size() > 1 && name[0] != '_'
         && std::all_of(name.begin() + 1, name.end(), [](char c) { return '0' <= c && c <= '9'; });
}

// No axis is made of a name that may be a slip: of `xy` or `pi`, or of `a` where x or y may be meant.
void require_known_names(const std::vector<std::string>& names, std::size_t dimension)
{
  const bool are_indexed = std::all_of(names.begin(), names.end(), is_letter_with_index);
  for (const auto& name : names) {
    if (std::find(standard_names.begin(), standard_names.end(), name) != standard_names.end()) continue;
    if (names.size() >= dimension && (are_indexed || is_letter(name))) continue;
    throw Invalid_input("variables: '" + detail::printable_excerpt(name, 0) + "' is a new name"
                        + detail::meaning_of_name(name, standard_names) + "; expected " + joined(standard_names)
                        + ", or --variables with a name for each side of the box");
  }
}

// Adds x, y, z, as far as they are not there, until every side has a name.
std::vector<std::string> with_further_axes(std::vector<std::string> names, std::size_t dimension)
{
  if (names.size() < dimension && dimension > standard_names.size()) // t, x, y, z or x, y, z, t?
    throw Invalid_input("variables: the box has " + std::to_string(dimension)
                        + " sides; expected a name for each, as in --variables t,x,y,z");
  for (const auto& name : standard_names)
    if (names.size() < dimension && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  std::sort(names.begin(), names.end());
  return names;
}

} // namespace

std::vector<std::string> names_in(const std::vector<Formula>& formulas)
{
  std::set<std::string> names;
  for (const auto& formula : formulas)
    for (auto& name : read_formula(formula, [](const std::string& text) { return variables_in(text); }))
      names.insert(std::move(name));
  return detail::without_products({names.begin(), names.end()});
}

Space read_space(const std::string& box, const std::string& variables, const std::vector<Formula>& polynomials)
{
  Space space;
  const auto sides = split(box, ',');
  if (sides.size() > max_dimension)
    throw Invalid_input("box: given " + detail::quantity(sides.size(), "side") + "; expected 1 to "
                        + std::to_string(max_dimension));
  for (std::size_t axis = 0; axis < sides.size(); ++axis) space.sides.push_back(read_side(sides[axis], axis));

  if (!trimmed(variables).empty()) {
    space.variables = split(variables, ',');
    if (space.variables.size() != sides.size())
      throw Invalid_input("variables: given " + joined(space.variables) + "; expected "
                          + detail::quantity(sides.size(), "name") + ", one for each side of the box");
    require_variable_names(space.variables);
    return space;
  }
  auto names = names_in(polynomials);
  require_known_names(names, sides.size());
  if (names.size() > sides.size())
    throw Invalid_input("box: given " + detail::quantity(sides.size(), "side")
                        + "; expected one for each of the variables " + joined(names));
  space.variables = with_further_axes(std::move(names), sides.size());
  return space;
}

std::pair<std::string, Output_options::Fact> reading_fact(const std::vector<std::string>& readings)
{
  if (readings.size() == 1) return {"polynomial", readings[0]};
  return {"polynomial", readings};
}

std::vector<std::uint32_t> read_resolution(const std::string& text, std::size_t dimension)
{
  const auto parts = split(text, ',');
  std::vector<std::uint32_t> result;
  for (const auto& part : parts) {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
    if (error != std::errc() || end != part.data() + part.size() || value == 0 || value > Grid<1>::max_resolution)
      throw Invalid_input("resolution: given '" + part + "'; expected a whole number from 1 to "
                          + std::to_string(Grid<1>::max_resolution));
    result.push_back(static_cast<std::uint32_t>(value));
  }
  if (result.size() == 1) result.resize(dimension, result[0]);
  if (result.size() != dimension)
    throw Invalid_input(
        "resolution: given " + detail::quantity(result.size(), "number") + "; expected 1"
        + (dimension == 1 ? "" : " or " + std::to_string(dimension) + ", one for each side of the box"));
  return result;
}

} // namespace corral::program
