// SPDX-License-Identifier: LGPL-3.0-or-later
/// \file
/// Finds the voxels that Viviani's curve passes through, where a sphere and a cylinder meet, and writes a mesh.
#include <corral/localization/localize_fast.h>
#include <corral/output/all.h>
#include <corral/polynomial/parse.h>

#include <iostream>

int main()
{
  using namespace corral;
  const std::array<std::string, 3> variables{"x", "y", "z"};
  const std::vector system{parse_polynomial<3>("x^2 + y^2 + z^2 - 4", variables),
                           parse_polynomial<3>("(x - 1)^2 + y^2 - 1", variables)};
  const Grid<3> grid({Rational_interval(-2, 2), Rational_interval(-2, 2), Rational_interval(-2, 2)}, {64, 64, 64});

  const auto found = localize_fast<3>(system, grid);
  std::cout << found.cells.plotted() << " of " << grid.cell_count() << " voxels may hold a point of the curve\n";
  write_file("viviani.png", grid, found.cells);
  write_file("viviani.ply", grid, found.cells);
}
