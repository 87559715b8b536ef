// SPDX-License-Identifier: LGPL-3.0-or-later
#include "arguments.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <iostream>
#include <iterator>
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

std::string read_all(std::istream& in, const std::string& name)
{
  std::string text;
  char buffer[1 << 16];
  while (in.read(buffer, sizeof buffer), in.gcount() > 0) {
    text.append(buffer, static_cast<std::size_t>(in.gcount()));
    if (text.size() > max_file_size) throw Invalid_input("polynomial: " + name + " is larger than 64 MiB");
  }
  if (in.bad()) throw Invalid_input("polynomial: cannot read " + name);
  return text;
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

// Adds x, y, z, as far as they are not there, until every side has a name.
void name_further_axes(std::set<std::string>& names, std::size_t dimension)
{
  for (const char* const name : {"x", "y", "z"})
    if (names.size() < dimension) names.insert(name);
  if (names.size() < dimension)
    throw Invalid_input("variables: the box has " + std::to_string(dimension)
                        + " sides; expected a name for each, as in --variables t,x,y,z");
}

} // namespace

std::string polynomial_text(const std::string& argument)
{
  if (argument.empty() || argument[0] != '@') return argument;
  const std::string name = argument.substr(1);
  if (name == "-") return read_all(std::cin, "standard input");
  std::ifstream in(name, std::ios::binary);
  if (!in) throw Invalid_input("polynomial: cannot read file '" + name + "': " + std::strerror(errno));
  return read_all(in, "file '" + name + "'");
}

Space read_space(const std::string& box, const std::string& variables, const std::vector<std::string>& polynomials)
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
  std::set<std::string> names;
  for (const auto& polynomial : polynomials)
    for (auto& name : variables_in(polynomial)) names.insert(std::move(name));
  if (names.size() > sides.size())
    throw Invalid_input("box: given " + detail::quantity(sides.size(), "side")
                        + "; expected one for each of the variables " + joined({names.begin(), names.end()}));
  name_further_axes(names, sides.size());
  space.variables.assign(names.begin(), names.end());
  return space;
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
