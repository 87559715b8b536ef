// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Grid_problem.h"

namespace corral::program {

void add_grid_options(CLI::App& command, Grid_arguments& arguments, const std::string& polynomial_help)
{
  command.add_option("POLY", arguments.polynomials, polynomial_help)->required();
  command.add_option("--box", arguments.box, "LOWER:UPPER for each axis, separated by commas, such as -1:1,0:3/2")
      ->required();
  command.add_option("--resolution", arguments.resolution, "number of cells along each axis: N or NX,NY[,NZ]")
      ->required();
  command.add_option("--variables", arguments.variables, "names of the axes in order (else x, y, z; see doc/input.md)");
}

} // namespace corral::program
