// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verification/check_witness.h"

#include <corral/errors.h>
#include <corral/polynomial/parse.h>
#include <corral/verification/ideal_raster.h>

#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <set>

namespace {

using namespace corral;

template <std::size_t D>
Cell_set<D> all_cells(const Resolution<D>& resolution)
{
  Cell_set<D> cells;
  Cell<D> block{};
  const auto blocks = [&](std::size_t axis) { return (resolution[axis] + block_side<D> - 1) / block_side<D>; };
  for (;;) {
    Cell_block<D> entry{block, 0, 0};
    for (unsigned bit = 0; bit < 64; ++bit) {
      const auto cell = cell_of<D>(block, bit);
      bool inside = true;
      for (std::size_t axis = 0; axis < D; ++axis) inside = inside && cell[axis] < resolution[axis];
      if (inside) entry.plotted |= std::uint64_t{1} << bit;
    }
    cells.append(entry);
    std::size_t axis = 0;
    while (axis < D && ++block[axis] == blocks(axis)) block[axis++] = 0;
    if (axis == D) break;
  }
  cells.finish();
  return cells;
}

template <std::size_t D>
struct Plot
{
  std::set<Cell<D>> hit;
  std::uint64_t unknown = 0;
  Rung_counts rungs;
};

template <std::size_t D>
Plot<D> plot(const std::string& text, const Rational_box<D>& box, std::uint32_t resolution)
{
  constexpr std::array<const char*, 3> names = {"x", "y", "z"};
  std::array<std::string, D> variables;
  for (std::size_t k = 0; k < D; ++k) variables[k] = names[k];
  Resolution<D> side;
  side.fill(resolution);
  const Grid<D> grid(box, side);
  const auto f = parse_polynomial<D>(text, variables);
  const auto start = std::chrono::steady_clock::now();
  const auto raster = ideal_raster(f, grid, all_cells<D>(side));
  if (std::getenv("CORRAL_TEST_VERBOSE") != nullptr)
    std::printf("%-40.40s %8.1f ms\n", text.c_str(),
                std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
  Cell_decider<D> decider(f, grid);
  const auto g = transform<Rational>(decider.square_free(), [](const Integer& c) { return Rational(c); });
  Plot<D> result;
  raster.cells.for_each([&](const Cell<D>& cell, Verdict verdict) {
    if (verdict == Verdict::hit) {
      result.hit.insert(cell);
      EXPECT_EQ(check::complaint<D>(decider.decide(cell).witness, g, grid.cell_box(cell)), "") << text;
    } else
      ++result.unknown;
  });
  result.rungs = raster.rungs;
  return result;
}

using Cells = std::set<Cell<2>>;
const Rational_box<2> around = {Rational_interval(-2, 2), Rational_interval(-2, 2)}; // cells of width 1 at resolution 4

TEST(Ideal_raster, finds_isolated_points_wherever_they_lie)
{
  // inside a cell, on an edge, on a corner
  EXPECT_EQ(plot<2>("(3*x-1)^2+(7*y-1)^2", around, 4).hit, (Cells{{2, 2}}));
  EXPECT_EQ(plot<2>("x^2+(7*y-1)^2", around, 4).hit, (Cells{{1, 2}, {2, 2}}));
  EXPECT_EQ(plot<2>("x^2+y^2", around, 4).hit, (Cells{{1, 1}, {1, 2}, {2, 1}, {2, 2}}));
  // irrational: (sqrt 2, sqrt 3) and its mirror images
  EXPECT_EQ(plot<2>("(x^2-2)^2+(y^2-3)^2", around, 4).hit, (Cells{{0, 0}, {0, 3}, {3, 0}, {3, 3}}));
  // an acnode with a branch elsewhere
  EXPECT_EQ(plot<2>("y^2-x^2*(x-1)", around, 4).hit.count({1, 1}), 1U);
  EXPECT_EQ(plot<2>("(2*x-1)^2+(2*y-1)^2-1/1000000000000000000000000000000", around, 4).hit, (Cells{{2, 2}}));
}

TEST(Ideal_raster, knows_that_there_is_no_real_point)
{
  EXPECT_EQ(plot<2>("x^2+y^2+1/1000000000000000000000000000000", around, 4).hit, Cells{});
  EXPECT_EQ(plot<2>("(x-y)^2+1/1000000000000000000000000000000", around, 4).hit, Cells{});
  EXPECT_EQ(plot<2>("(x^2+y^2-2)^2+1/10^40", around, 4).hit, Cells{});
  EXPECT_EQ(plot<2>("(x^2-2)^2+(y^2-3)^2+1/10^40", around, 4).hit, Cells{});
  EXPECT_EQ(plot<2>("x^2+y^2+7", around, 4).hit, Cells{});
  EXPECT_EQ(plot<2>("5", around, 4).hit, Cells{});
}

TEST(Ideal_raster, treats_multiple_components_as_simple_ones)
{
  const auto circle = plot<2>("x^2+y^2-2", around, 4).hit;
  EXPECT_EQ(plot<2>("(x^2+y^2-2)^2", around, 4).hit, circle);
  EXPECT_EQ(plot<2>("(x^2+y^2-2)^3*(x^2+y^2+1)", around, 4).hit, circle);
}

TEST(Ideal_raster, meets_grid_lines_and_grid_points_exactly)
{
  Cells column;
  for (std::uint32_t j = 0; j < 4; ++j) column.insert({{1, j}, {2, j}});
  EXPECT_EQ(plot<2>("x", around, 4).hit, column);
  EXPECT_EQ(plot<2>("x^2", around, 4).hit, column);
  Cells diagonal;
  for (std::uint32_t i = 0; i < 4; ++i)
    for (std::uint32_t j = 0; j < 4; ++j)
      if (i + 1 >= j && j + 1 >= i) diagonal.insert({i, j});
  EXPECT_EQ(plot<2>("x-y", around, 4).hit, diagonal);
  // tangent to the grid line x = 1 at (1, 1/2), from the left and with a gap of 1e-30
  const auto tangent = plot<2>("(x-1/2)^2+(y-1/2)^2-1/4", around, 4).hit;
  EXPECT_EQ(tangent.count({3, 2}), 1U);
  EXPECT_EQ(tangent.count({1, 2}), 1U);
  EXPECT_EQ(plot<2>("(x-1/2)^2+(y-1/2)^2-(1/2-1/10^30)^2", around, 4).hit, (Cells{{2, 2}}));
  // tangent at an irrational point of the grid line y = 0: y = (x^2-2)^2
  EXPECT_EQ(plot<2>("y-(x^2-2)^2", around, 4).hit.count({3, 1}), 1U);
  EXPECT_EQ(plot<2>("y-1/10^30-(x^2-2)^2", around, 4).hit.count({3, 1}), 0U);
}

TEST(Ideal_raster, tells_branches_apart_that_are_very_close)
{
  const auto two = plot<2>("(y-1/2*x-1/3)*(y-1/2*x-1/3-1/1000000000000)", around, 4);
  EXPECT_EQ(two.hit, plot<2>("y-1/2*x-1/3", around, 4).hit);
  EXPECT_EQ(two.unknown, 0U);
}

TEST(Ideal_raster, finds_cusps_and_crossings)
{
  EXPECT_EQ(plot<2>("(2*y-1)^2-(2*x-1)^3", around, 4).hit.count({2, 2}), 1U);
  EXPECT_EQ(plot<2>("(x^2+y^2)^2-2*(x^2-y^2)", around, 4).unknown, 0U);
}

/// Cells among those named where the four corners see a change of sign: what a careless decider would call the plot.
std::size_t seen_by_corners(const Polynomial<Rational, 2>& f, const Grid<2>& grid, const std::vector<Cell<2>>& cells)
{
  std::size_t count = 0;
  for (const auto& cell : cells) {
    const auto box = grid.cell_box(cell);
    bool positive = false;
    bool negative = false;
    for (const auto& x : {box[0].lower(), box[0].upper()})
      for (const auto& y : {box[1].lower(), box[1].upper()}) {
        const auto sign = sgn(evaluate(f, {x, y}));
        positive = positive || sign >= 0;
        negative = negative || sign <= 0;
      }
    count += positive && negative;
  }
  return count;
}

TEST(Ideal_raster, finds_the_egg_of_24a1)
{
  // The cubic has the roots -11 and 6 +- 12 sqrt 2, so the egg spans [-11, -10.97] about y = 0, a grid line.
  const Rational_box<2> box = {Rational_interval(-30, 60), Rational_interval(-300, 300)};
  const auto f = parse_polynomial<2>("y^2-x^3+x^2+384*x+2772", {"x", "y"});
  const Grid<2> grid(box, {1024, 1024});
  Cell_decider<2> decider(f, grid);
  std::vector<Cell<2>> hit;
  std::vector<Cell<2>> all;
  for (std::uint32_t i = 205; i < 225; ++i)
    for (std::uint32_t j = 505; j < 520; ++j) {
      all.push_back({i, j});
      if (decider.decide({i, j}).verdict == Verdict::hit) hit.push_back({i, j});
    }
  EXPECT_EQ(hit, (std::vector<Cell<2>>{{216, 511}, {216, 512}}));
  EXPECT_EQ(seen_by_corners(f, grid, all), 0U); // negative control: four corners lose the egg
}

} // namespace
