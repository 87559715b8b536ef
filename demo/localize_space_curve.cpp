// SPDX-License-Identifier: LGPL-3.0-or-later
/// \file
/// Finds the voxels that Viviani's curve passes through, where a sphere and a cylinder meet, and writes a mesh.
#include <corral/localization/localize.h>
#include <corral/output/all.h>
#include <corral/polynomial/parse.h>

#include <iostream>

int main()
{
  using namespace corral;
  const std::array<std::string, 3> variables{"x", "y", "z"};
  const std::vector system{parse_polynomial<3>("x^2 + y^2 + z^2 - 4", variables),
                           parse_polynomial<3>("(x - 1)^2 + y^2 - 1", variables)};
  const Grid grid({{-2, 2}, {-2, 2}, {-2, 2}}, 64);

  const auto found = localize(system, grid);
  std::cout << found.plotted() << " of " << grid.cell_count() << " voxels may hold a point of the curve\n";
  write_file("viviani.png", found);
  write_file("viviani.ply", found);
}
