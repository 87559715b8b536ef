// SPDX-License-Identifier: LGPL-3.0-or-later
/// \file
/// The common points of two conics, exactly, with the multiplicities of the intersection.
#include <corral/geometry/solve.h>
#include <corral/polynomial/parse.h>

#include <iostream>

int main()
{
  using namespace corral;
  const auto conic = [](const char* text) { return parse_polynomial<2>(text, {"x", "y"}); };
  auto zeros = solve(conic("x^2 + y^2 - 4"), conic("y - x^2 + 2"));
  for (auto& point : zeros.points) {
    if (const auto rational = point.rational())
      std::cout << '(' << (*rational)[0] << ", " << (*rational)[1] << ')';
    else {
      point.refine_to(Rational(1, 1000000000));
      std::cout << "near (" << point.box()[0].lower().get_d() << ", " << point.box()[1].lower().get_d() << ')';
    }
    std::cout << ", multiplicity " << point.multiplicity() << '\n';
  }
}
