// SPDX-License-Identifier: LGPL-3.0-or-later
#include "all_cells.h"
#include "check_witness.h"

#include <corral/decision/ideal_system.h>
#include <corral/errors.h>
#include <corral/polynomial/parse.h>

#include <gtest/gtest.h>

#include <set>

namespace {

using namespace corral;

template <std::size_t D>
struct Plot
{
  std::set<Cell<D>> hit;
  std::size_t unknown = 0;
};

/// Decides every cell of [-2, 2]^D and checks each witness against both polynomials.
template <std::size_t D>
Plot<D> plot(const std::string& f, const std::string& g, std::uint32_t resolution)
{
  constexpr std::array<const char*, 3> names = {"x", "y", "z"};
  std::array<std::string, D> variables;
  Rational_box<D> box;
  Resolution<D> side;
  for (std::size_t k = 0; k < D; ++k) {
    variables[k] = names[k];
    box[k] = Rational_interval(-2, 2);
    side[k] = resolution;
  }
  const std::vector<Polynomial<Rational, D>> system = {parse_polynomial<D>(f, variables),
                                                       parse_polynomial<D>(g, variables)};
  const Grid<D> grid(box, side);
  System_decider<D> decider(system, grid);
  Plot<D> result;
  for (const auto& [cell, open] : check::all_cells<D>(grid)) {
    const auto decision = decider.decide(cell);
    result.unknown += decision.verdict == Verdict::unknown;
    if (decision.verdict != Verdict::hit) continue;
    result.hit.insert(cell);
    if (std::holds_alternative<std::monostate>(decision.witness)) continue;
    for (const auto& p : system)
      EXPECT_EQ(check::complaint<D>(decision.witness, p, grid.cell_box(cell)), "") << f << " and " << g;
  }
  return result;
}

using Cells = std::set<Cell<2>>;

TEST(Ideal_system, finds_points_of_the_plane)
{
  EXPECT_EQ(plot<2>("x^2+y^2-2", "x-y", 4).hit,
            (Cells{{0, 0}, {0, 1}, {1, 0}, {1, 1}, {2, 2}, {2, 3}, {3, 2}, {3, 3}}));
  EXPECT_EQ(plot<2>("x^2+y^2-3", "x-y", 4).hit, (Cells{{0, 0}, {3, 3}})); // (sqrt 3/2, sqrt 3/2) and its mirror image
  EXPECT_EQ(plot<2>("x^2-2", "y^2-3", 4).hit, (Cells{{0, 0}, {0, 3}, {3, 0}, {3, 3}})); // two points over each x
  EXPECT_EQ(plot<2>("x^2+y^2-1", "x^2+y^2-1-1/10^20", 4).hit, Cells{});
  EXPECT_EQ(plot<2>("(2*x-1)^2+(2*y-1)^2-1/10", "2*x-1", 4).hit, (Cells{{2, 2}}));
}

TEST(Ideal_system, finds_contacts_that_are_not_crossings)
{
  EXPECT_EQ(plot<2>("y-(x^2-2)^2-1/2", "y-1/2", 4).hit, (Cells{{0, 2}, {3, 2}})); // at (+- sqrt 2, 1/2)
  EXPECT_EQ(plot<2>("y-(x^2-2)^2-1/2-1/10^25", "y-1/2", 4).hit, Cells{});
}

TEST(Ideal_system, treats_a_common_factor_as_a_curve)
{
  const auto both = plot<2>("(3*x-1)*(y-x)", "(3*x-1)*(x+y-1)", 4);
  EXPECT_EQ(both.unknown, 0U);
  Cells expected;
  for (std::uint32_t j = 0; j < 4; ++j) expected.insert({2, j});
  EXPECT_EQ(both.hit, expected); // the line x = 1/3 and the point (1/2, 1/2)
  EXPECT_EQ(plot<2>("x^2+y^2-2", "(x^2+y^2-2)^2", 4).hit, plot<2>("x^2+y^2-2", "x^2+y^2-2", 4).hit);
}

TEST(Ideal_system, finds_curves_in_space)
{
  // The twisted cubic meets the cells that its parameter runs through.
  const auto cubic = plot<3>("7*y-7*x^2-1", "11*z-11*x^3-3", 4);
  EXPECT_EQ(cubic.unknown, 0U);
  std::set<Cell<3>> sampled;
  for (int k = -2000; k <= 2000; ++k) {
    const double x = k / 1000.0;
    const double point[] = {x, x * x + 1.0 / 7, x * x * x + 3.0 / 11};
    Cell<3> cell;
    bool inside = true;
    for (std::size_t i = 0; i < 3; ++i) {
      inside = inside && point[i] > -2 && point[i] < 2;
      if (inside) cell[i] = static_cast<std::uint32_t>(point[i] + 2);
    }
    if (inside) sampled.insert(cell);
  }
  for (const auto& cell : sampled) EXPECT_TRUE(cubic.hit.count(cell)) << cell[0] << ' ' << cell[1] << ' ' << cell[2];
  EXPECT_LE(cubic.hit.size(), sampled.size() + 4); // and its ends on x = -1, 0, 1, where two cells share it

  const auto circle = plot<3>("x^2+y^2+z^2-2", "3*x+5*y+7*z-1", 8);
  EXPECT_EQ(circle.unknown, 0U);
  EXPECT_GT(circle.hit.size(), 20U);
  EXPECT_TRUE(plot<3>("x^2+y^2+z^2-1", "x^2+y^2+z^2-1-1/10^20", 4).hit.empty());
}

using Space_cells = std::set<Cell<3>>;

void expect_decided(const std::string& f, const std::string& g, std::uint32_t resolution, const Space_cells& truth)
{
  const auto found = plot<3>(f, g, resolution);
  EXPECT_EQ(found.hit, truth) << f << " and " << g;
  EXPECT_EQ(found.unknown, 0U) << f << " and " << g;
}

// At resolution 3 the middle cell of each axis is [-2/3, 2/3].
TEST(Ideal_system, finds_closed_curves_inside_a_cell)
{
  expect_decided("100*(x^2+y^2+z^2)-1", "3*x+5*y+7*z-1/10", 3, {{1, 1, 1}});
  expect_decided("100*(x^2+y^2+z^2)-1", "3*x+5*y+7*z-10", 3, {}); // the plane misses the sphere
  expect_decided("100*(x^2+y^2+z^2)-1", "x^3+y^3+z^3-x*y*z-1/100000", 3, {{1, 1, 1}});
  // a circle of radius about 1e-6, and two spheres with a gap of 1e-13
  expect_decided("(5*x-2)^2+(5*y-2)^2+(5*z-2)^2-1", "(5*x-2)^2+(5*y-2)^2+(5*z-3)^2-1/10^12", 2, {{1, 1, 1}});
  expect_decided("(5*x-2)^2+(5*y-2)^2+(5*z-2)^2-1/4", "(5*x-2)^2+(5*y-2)^2+(5*z-3)^2-1/4+1/10^12", 2, {});
}

TEST(Ideal_system, finds_contacts_in_single_points)
{
  // two spheres that touch at (2/5, 2/5, 1/2)
  expect_decided("(5*x-2)^2+(5*y-2)^2+(5*z-2)^2-1/4", "(5*x-2)^2+(5*y-2)^2+(5*z-3)^2-1/4", 2, {{1, 1, 1}});
  // irrational: (+- sqrt 2, +- sqrt 3, 1/7)
  const Space_cells four = {{0, 0, 1}, {0, 2, 1}, {2, 0, 1}, {2, 2, 1}};
  expect_decided("7*z-1", "7*z-1-(x^2-2)^2-(y^2-3)^2", 3, four);
  expect_decided("7*z-1", "7*z-1-(x^2-2)^2-(y^2-3)^2-1/10^25", 3, {});
  // two conjugate complex curves through a real point; the projection along z shows a smooth line
  expect_decided("7*y-1", "(7*z-1)^2+(7*x-1)^2", 3, {{1, 1, 1}});
  expect_decided("7*y-1", "(z^2-2)^2+(x^2-3)^2", 3, {{0, 1, 0}, {0, 1, 2}, {2, 1, 0}, {2, 1, 2}});
  // one equation is four lines, of which each meets the other surface once
  expect_decided("(x^2-2)^2+(y^2-3)^2", "z^3-x*y-1/7", 3, {{0, 0, 2}, {0, 2, 0}, {2, 0, 0}, {2, 2, 2}});
}

TEST(Ideal_system, leaves_no_cell_of_well_known_curves_unknown)
{
  const std::vector<std::pair<const char*, const char*>> curves = {
      {"x^2+y^2+z^2-4", "(x-1)^2+y^2-1"},           // Viviani
      {"(x^2+y^2+z^2+3/4)^2-4*(x^2+y^2)", "2*x-1"}, // a torus and the plane that touches it inside
      {"(x^2+y^2+z^2+3/4)^2-4*(x^2+y^2)", "2*z-1"}, // and the one that touches it along a circle
      {"x^2+y^2+z^2-2", "x+y-2"},                   // a sphere and the plane that touches it at (1, 1, 0)
      {"(3*x-1)^2+(3*y-1)^2+(3*z-1)^2-1", "(3*x-3)^2+(3*y-1)^2+(3*z-1)^2-1"}};
  for (const auto& [f, g] : curves) {
    const auto found = plot<3>(f, g, 12);
    EXPECT_EQ(found.unknown, 0U) << f << " and " << g;
    EXPECT_FALSE(found.hit.empty()) << f << " and " << g;
  }
}

TEST(Ideal_system, decides_one_polynomial_by_intervals_too)
{
  const auto f = parse_polynomial<2>("x^2+y^2-7/3", {"x", "y"});
  const auto all = check::all_cells<2>(Grid<2>({Rational_interval(-2, 2), Rational_interval(-2, 2)}, {16, 16}));
  const auto alone = ideal_raster(f, all);
  const auto system = ideal_raster(std::vector{f}, all);
  EXPECT_TRUE(system.raster == alone.raster);
  EXPECT_EQ(system.rungs.hit, alone.rungs.hit);
  EXPECT_EQ(system.rungs.empty, alone.rungs.empty);
  EXPECT_GT(system.rungs.empty[static_cast<std::size_t>(Rung::intervals)], 0U);
  EXPECT_THROW((void)ideal_raster(std::vector(1, Polynomial<Rational, 2>{}), all), Invalid_input);
}

TEST(Ideal_system, refuses_what_is_no_system_of_two)
{
  const Grid<2> grid({Rational_interval(0, 1), Rational_interval(0, 1)}, {4, 4});
  const auto f = parse_polynomial<2>("x-y", {"x", "y"});
  EXPECT_THROW((System_decider<2>({}, grid)), Invalid_input);
  EXPECT_THROW((System_decider<2>({f, f, f}, grid)), Invalid_input);
  EXPECT_THROW((System_decider<2>({f, {}}, grid)), Invalid_input);
}

} // namespace
