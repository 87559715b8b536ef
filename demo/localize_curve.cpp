// SPDX-License-Identifier: LGPL-3.0-or-later
/// \file
/// Finds the pixels that a lemniscate passes through, prints them as letters and draws them.
#include <corral/localization/localize.h>
#include <corral/output/all.h>
#include <corral/polynomial/parse.h>

#include <iostream>

int main()
{
  using namespace corral;
  const auto f = parse_polynomial<2>("(x^2 + y^2)^2 - 2*(x^2 - y^2)", {"x", "y"});
  const Grid grid({{-2, 2}, {-1, 1}}, {64, 32});

  const auto found = localize(f, grid);
  std::cout << found.plotted() << " pixels: " << found.hit() << " hit, " << found.unknown()
            << " unknown; all others are proved empty\n";
  write_text(std::cout, found, {});
  write_file("lemniscate.png", found);
}
