// SPDX-License-Identifier: LGPL-3.0-or-later
/// \file
/// Localises a line, whose cells are known, writes a picture, and has a certificate checked: a part of each library.
#include <corral/certificate/certificate.h>
#include <corral/localization/localize.h>
#include <corral/output/all.h>
#include <corral/polynomial/parse.h>
#include <corral_check/check.h>

#include <iostream>

int main()
{
  using namespace corral;
  const auto f = parse_polynomial<2>("x - y - 1/8", {"x", "y"});
  const Grid grid({{0, 1}, {0, 1}}, 4);

  const auto found = localize(f, grid);
  write_file("line.svg", found);
  std::cout << found.plotted() << " cells plotted, " << found.hit() << " hit\n";
  const auto proved = corral_check::check(to_json(certify(f, grid), {"x", "y"})).counts;
  const bool is_right = found.plotted() == 7 && found.hit() == 7 && proved.hit == 7 && proved.empty == 9;
  return is_right ? 0 : 1; // four on the diagonal, three below it
}
