// SPDX-License-Identifier: LGPL-3.0-or-later
/// \file
/// Localises a line, whose cells are known, and writes a picture: a part of each library.
#include <corral/localization/localize_fast.h>
#include <corral/output/all.h>
#include <corral/polynomial/parse.h>

#include <iostream>

int main()
{
  using namespace corral;
  const auto f = parse_polynomial<2>("x - y - 1/8", {"x", "y"});
  const Grid<2> grid({Rational_interval(0, 1), Rational_interval(0, 1)}, {4, 4});

  const auto found = localize_fast<2>(f, grid);
  write_file("line.svg", grid, found.cells);
  std::cout << found.cells.plotted() << " cells plotted, " << found.cells.hit() << " hit\n";
  return found.cells.plotted() == 7 && found.cells.hit() == 7 ? 0 : 1; // four on the diagonal, three below it
}
