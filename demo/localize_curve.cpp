// SPDX-License-Identifier: LGPL-3.0-or-later
/// \file
/// Finds the pixels that a lemniscate passes through, prints them as letters and draws them.
#include <corral/localization/localize_fast.h>
#include <corral/output/all.h>
#include <corral/polynomial/parse.h>

#include <iostream>

int main()
{
  using namespace corral;
  const auto f = parse_polynomial<2>("(x^2 + y^2)^2 - 2*(x^2 - y^2)", {"x", "y"});
  const Grid<2> grid({Rational_interval(-2, 2), Rational_interval(-1, 1)}, {64, 32});

  const auto found = localize_fast<2>(f, grid);
  std::cout << found.cells.plotted() << " pixels: " << found.cells.hit() << " hit, " << found.cells.unknown()
            << " unknown; all others are proved empty\n";
  write_text<2>(std::cout, grid, found.cells, {});
  write_file("lemniscate.png", grid, found.cells);
}
