// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_PROGRAM_ARGUMENTS_H
#define CORRAL_PROGRAM_ARGUMENTS_H

#include "Formula.h"

#include <corral/errors.h>
#include <corral/localization/Grid.h>
#include <corral/output/Output_options.h>
#include <corral/polynomial/print.h>

#include <algorithm>
#include <array>
#include <string>
#include <type_traits>
#include <vector>

/// \file
/// What all commands read alike: polynomials, boxes, resolutions.
namespace corral::program {

/// The greatest number of variables that the program is built for.
inline constexpr std::size_t max_dimension = 4;

/// The axes of a problem: a name and an interval each.
struct Space
{
  std::vector<std::string> variables;
  std::vector<Rational_interval> sides;
};

/// The names of the formulas' variables, without those that are products of others of them, in alphabetical order.
[[nodiscard]] std::vector<std::string> names_in(const std::vector<Formula>& formulas);

/// \brief Reads `LOWER:UPPER,...` and finds a name for each axis.
///
/// Without `variables` (names separated by commas) the axes are the variables of the polynomials in alphabetical order,
/// with unused ones of x, y, z added where there are more sides, three at most. Other names
/// need `variables`, but for single letters, or letters that all have an index, where there are as many names as sides.
/// \throw Invalid_input if the texts do not fit together.
[[nodiscard]] Space read_space(const std::string& box, const std::string& variables,
                               const std::vector<Formula>& polynomials);

/// \brief Reads `N` or `NX,NY,...`.
/// \throw Invalid_input unless there are one or `dimension` numbers from 1 to the largest resolution.
[[nodiscard]] std::vector<std::uint32_t> read_resolution(const std::string& text, std::size_t dimension);

/// Calls `function(std::integral_constant<std::size_t, D>{})` for the dimension of the space. \pre It has one to
/// `max_dimension` sides.
template <class Function>
void with_dimension(const Space& space, const Function& function)
{
  switch (space.sides.size()) {
  case 1:
    return function(std::integral_constant<std::size_t, 1>{});
  case 2:
    return function(std::integral_constant<std::size_t, 2>{});
  case 3:
    return function(std::integral_constant<std::size_t, 3>{});
  default:
    return function(std::integral_constant<std::size_t, max_dimension>{});
  }
}

/// The box of a space. \pre D is its dimension.
template <std::size_t D>
[[nodiscard]] Rational_box<D> box_of(const Space& space)
{
  Rational_box<D> box;
  std::copy_n(space.sides.begin(), D, box.begin());
  return box;
}

/// The names of the axes. \pre D is the dimension of the space.
template <std::size_t D>
[[nodiscard]] std::array<std::string, D> variables_of(const Space& space)
{
  std::array<std::string, D> variables;
  std::copy_n(space.variables.begin(), D, variables.begin());
  return variables;
}

/// \brief The polynomials over the variables of a space. \pre D is its dimension.
/// \throw Formula_error, Parse_error, Budget_exceeded as `parse_polynomial`.
template <std::size_t D>
[[nodiscard]] std::vector<Polynomial<Rational, D>> polynomials_of(const Space& space,
                                                                  const std::vector<Formula>& formulas)
{
  std::vector<Polynomial<Rational, D>> result;
  for (const Formula& formula : formulas)
    result.push_back(read_formula(
        formula, [&](const std::string& text) { return parse_polynomial<D>(text, variables_of<D>(space)); }));
  return result;
}

/// The polynomials as text, expanded, so that everybody sees what was read.
template <std::size_t D>
[[nodiscard]] std::vector<std::string> readings_of(const Space& space,
                                                   const std::vector<Polynomial<Rational, D>>& polynomials)
{
  std::vector<std::string> result;
  for (const auto& f : polynomials) result.push_back(to_string(f, variables_of<D>(space)));
  return result;
}

/// The readings under the name that they have in all summaries: a text, or a list of several.
[[nodiscard]] std::pair<std::string, Output_options::Fact> reading_fact(const std::vector<std::string>& readings);

} // namespace corral::program

#endif
