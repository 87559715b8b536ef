// SPDX-License-Identifier: LGPL-3.0-or-later
/// \file
/// The two components of an elliptic curve: their topology is proved, and they are drawn.
#include <corral/geometry/mesh_curve.h>
#include <corral/output/Output_file.h>
#include <corral/output/curve_meshes.h>
#include <corral/polynomial/parse.h>

#include <iostream>

int main()
{
  using namespace corral;
  const std::string text = "y^2 - x^3 + x";
  const auto mesh =
      mesh_curve(parse_polynomial<2>(text, {"x", "y"}), {Rational_interval(-2, 2), Rational_interval(-2, 2)});
  std::cout << mesh.components.size() << " components, " << mesh.closed_components() << " of them closed, "
            << (mesh.is_certified() ? "proved" : "not all of it proved") << '\n';
  for (const auto& component : mesh.components)
    std::cout << (component.is_closed ? "  an oval of " : "  a branch of ") << component.edges << " edges\n";
  write_whole_files({{"elliptic_curve.svg", [&](std::ostream& out) { draw_meshes_svg(out, {{text, mesh}}, {}); }}});
}
