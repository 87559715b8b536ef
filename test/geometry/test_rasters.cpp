// SPDX-License-Identifier: LGPL-3.0-or-later
#include "mesh_checks.h"
#include "random_curves.h"
#include "rounds.h"

#include <corral/decision/ideal_raster.h>
#include <corral/localization/connected_components.h>
#include <corral/localization/localize.h>
#include <corral/polynomial/print.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

/// \file
/// Meshes against ideal rasters, which share no code of geometry with them.
namespace corral {
namespace {

constexpr std::uint32_t cells = 96;

Raster<2> ideal(const Polynomial<Rational, 2>& f, const Rational_box<2>& box)
{
  return ideal_raster(f, localize(f, Grid<2>(box, {cells, cells}))).raster;
}

/// Whether a segment meets a closed box: its line separates no corners from others, or its ends do not lie beyond a
/// side.
bool meets(const Rational_box<2>& box, const Rational_point<2>& a, const Rational_point<2>& b)
{
  for (std::size_t k = 0; k < 2; ++k)
    if (std::max(a[k], b[k]) < box[k].lower() || std::min(a[k], b[k]) > box[k].upper()) return false;
  std::array<int, 3> seen{};
  for (const Rational& x : {box[0].lower(), box[0].upper()})
    for (const Rational& y : {box[1].lower(), box[1].upper()})
      ++seen[static_cast<std::size_t>(test::orientation(a, b, {x, y}) + 1)];
  return seen[1] > 0 || (seen[0] > 0 && seen[2] > 0);
}

/// Whether a mesh comes as near to a cell as `reach`.
bool is_near(const Curve_mesh& mesh, const Rational_box<2>& cell, const Rational& reach)
{
  Rational_box<2> wide;
  for (std::size_t k = 0; k < 2; ++k) wide[k] = {cell[k].lower() - reach, cell[k].upper() + reach};
  return std::any_of(mesh.vertices.begin(), mesh.vertices.end(),
                     [&](const auto& v) { return meets(wide, v.point, v.point); })
         || std::any_of(mesh.edges.begin(), mesh.edges.end(), [&](const auto& e) {
              return meets(wide, mesh.vertices[e[0]].point, mesh.vertices[e[1]].point);
            });
}

// Curves whose components are further apart than two cells.
TEST(rasters, have_the_pieces_of_the_mesh)
{
  for (const char* text : {"(x^2+y^2-1)*(x^2+y^2-4)", "y^2-x^3+x", "(x^2+y^2)^2-2*(x^2-y^2)", "(x^2-2)^2+(y^2-3)^2",
                           "((x-1)^2+y^2-1/4)*((x+1)^2+y^2-1/4)*(y-2)", "x*y-1", "y^2-x^3", "x^4+y^4-1"}) {
    const auto f = test::curve(text);
    const auto box = test::box(-3, 3, -3, 3);
    const auto mesh = mesh_curve(f, box, Rational(1, 20));
    const auto raster = ideal(f, box);
    EXPECT_EQ(mesh.components.size(), connected_components(raster).size()) << text;
  }
}

// Any curve: the mesh comes within the tolerance of every cell that is hit.
TEST(rasters, are_covered_by_the_mesh)
{
  test::Random_curves curves(5);
  const auto box = test::box(-3, 3, -3, 3);
  const Rational side = Rational(6) / cells;
  std::size_t hits = 0;
  for (int round = 0; round < test::rounds(12); ++round) {
    const auto f = transform<Rational>(curves.next(), [](const Integer& c) { return Rational(c); });
    const Rational tolerance(1, 50);
    auto mesh = mesh_curve(f, box, tolerance);
    const auto raster = ideal(f, box);
    const auto is_covered = [&](std::uint32_t i, std::uint32_t j) {
      const auto from = [&](std::uint32_t k) { return Rational(k * side - 3); };
      return is_near(mesh, {Rational_interval(from(i), from(i + 1)), Rational_interval(from(j), from(j + 1))},
                     tolerance);
    };
    std::optional<std::array<std::uint32_t, 2>> last;
    for (std::uint32_t i = 0; i < cells; i += 5)
      for (std::uint32_t j = 0; j < cells; ++j) {
        if (raster.verdict({i, j}) != Verdict::hit) continue;
        ++hits;
        last = {i, j};
        EXPECT_TRUE(is_covered(i, j)) << to_string(f, {"x", "y"}) << ", cell " << i << ' ' << j;
      }
    mesh.vertices.clear(); // control
    mesh.edges.clear();
    EXPECT_TRUE(!last || !is_covered((*last)[0], (*last)[1]));
  }
  EXPECT_GT(hits, 100U);
}

} // namespace
} // namespace corral
