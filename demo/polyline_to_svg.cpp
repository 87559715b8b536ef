// SPDX-License-Identifier: LGPL-3.0-or-later
/// \file
/// The polylines of a curve, taken as points and written to an SVG picture by hand.
#include <corral/geometry/mesh_curve.h>
#include <corral/geometry/polylines.h>
#include <corral/polynomial/parse.h>

#include <fstream>
#include <iostream>

int main()
{
  using namespace corral;
  const auto rose = parse_polynomial<2>("(x^2 + y^2)^3 - 4*x^2*y^2", {"x", "y"});
  const auto mesh = mesh_curve(rose, {Rational_interval(-1, 1), Rational_interval(-1, 1)}, {Rational(1, 500)});
  const auto lines = polylines(mesh);
  std::ofstream picture("rose.svg");
  picture << "<svg xmlns='http://www.w3.org/2000/svg' width='480' height='480' viewBox='-1.05 -1.05 2.1 2.1'>\n";
  for (const auto& line : lines) {
    picture << "<polyline fill='none' stroke='black' stroke-width='0.008' points='";
    for (const std::size_t v : line)
      picture << mesh.vertices[v].point[0].get_d() << ',' << -mesh.vertices[v].point[1].get_d() << ' ';
    picture << "'/>\n";
  }
  picture << "</svg>\n";
  std::cout << lines.size() << " lines of " << mesh.vertices.size() << " points together\n";
}
