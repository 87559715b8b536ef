// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_PROGRAM_GRID_PROBLEM_H
#define CORRAL_PROGRAM_GRID_PROBLEM_H

#include "arguments.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace corral::program {

/// Polynomials on a grid, as the command line gives them.
struct Grid_arguments
{
  std::vector<std::string> polynomials;
  std::string box;
  std::string resolution;
  std::string variables;
};

/// Adds the options of a problem to a command. \param polynomial_help  what to say of the polynomials.
void add_grid_options(CLI::App& command, Grid_arguments& arguments, const std::string& polynomial_help);

/// Polynomials on a grid.
template <std::size_t D>
struct Grid_problem
{
  std::vector<std::string> texts;    ///< as given
  std::vector<std::string> readings; ///< as read
  std::vector<std::string> variables;
  std::vector<Polynomial<Rational, D>> system;
  Grid<D> grid;
};

/// Calls `function(Grid_problem<D>)` for the problem that the arguments pose. \throw Invalid_input, Parse_error.
template <class Function>
void with_problem(const Grid_arguments& arguments, const Function& function)
{
  const auto formulas = formulas_of(arguments.polynomials);
  const Space space = read_space(arguments.box, arguments.variables, formulas);
  with_dimension(space, [&](auto dimension) {
    constexpr std::size_t D = dimension;
    auto system = polynomials_of<D>(space, formulas);
    auto readings = readings_of<D>(space, system);
    const auto counts = read_resolution(arguments.resolution, D);
    Resolution<D> resolution;
    std::copy_n(counts.begin(), D, resolution.begin());
    function(Grid_problem<D>{texts_of(formulas), std::move(readings), space.variables, std::move(system),
                             Grid<D>(box_of<D>(space), resolution)});
  });
}

} // namespace corral::program

#endif
