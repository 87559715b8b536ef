// SPDX-License-Identifier: LGPL-3.0-or-later
#include "all_cells.h"
#include "check_witness.h"

#include <corral/decision/ideal_raster.h>
#include <corral/errors.h>
#include <corral/localization/localize_fast.h>
#include <corral/polynomial/parse.h>

#include <gtest/gtest.h>

#include <set>

namespace {

using namespace corral;
using check::all_cells;

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
  const auto raster = ideal_raster(f, grid, all_cells<D>(side));
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

TEST(Ideal_raster, decides_hard_curves_completely)
{
  const std::vector<std::pair<const char*, std::size_t>> curves = {
      {"((x^2-2)^2+(x*y-1)^2)*(x^3+y^3-3*x*y-1/2)", 0}, // two irrational isolated points beside a cubic
      {"(x^3-3*x+1)^2+(y^3-x*y-1)^2", 3},               // three points with coordinates of degree 9
      {"(x^4-10*x^2+1)^2+(y^4-10*y^2+1)^2", 4},
      {"(x^2+y^2-1)*(x^2+y^2-1-1/1000000000000)", 0},
      {"(x^2+y^2)^5-(x^4-6*x^2*y^2+y^4)^2", 0},
      {"((8*x^4-8*x^2+1)-(16*y^5-20*y^3+5*y))^2+1/10^30", 0},
      {"(y-x^2)^2-x^5", 0},
      {"y^2-x^8", 0},
      {"x^60+y^60-1", 0}};
  for (const auto& [text, points] : curves) {
    const auto result = plot<2>(text, around, 16);
    EXPECT_EQ(result.unknown, 0U) << text;
    if (points > 0) {
      EXPECT_EQ(result.hit.size(), points) << text;
    }
  }
  EXPECT_TRUE(plot<2>("((8*x^4-8*x^2+1)-(16*y^5-20*y^3+5*y))^2+1/10^30", around, 16).hit.empty());
}

TEST(Ideal_raster, takes_coefficients_of_a_thousand_digits)
{
  std::string big = "1";
  for (int i = 0; i < 1000; ++i) big += static_cast<char>('0' + i * i % 10);
  const auto circle = "(" + big + ")*(x^2+y^2)-2*(" + big + ")-1/(" + big + ")";
  const auto result = plot<2>(circle, around, 16);
  EXPECT_EQ(result.unknown, 0U);
  EXPECT_EQ(result.hit, plot<2>("x^2+y^2-2-1/10^40", around, 16).hit);
  EXPECT_NE(result.hit, plot<2>("x^2+y^2-2+1/10^40", around, 16).hit); // the sign of 1e-1000 matters at grid points
}

TEST(Ideal_raster, decides_surfaces_with_singularities_completely)
{
  const Rational_box<3> box = {Rational_interval(-2, 2), Rational_interval(-2, 2), Rational_interval(-2, 2)};
  const std::vector<std::pair<const char*, std::size_t>> surfaces = {
      {"4*(x^3+y^3+z^3+1)-(x+y+z+1)^3", 1}, // Cayley
      {"81*(x^3+y^3+z^3)-189*(x^2*y+x^2*z+y^2*x+y^2*z+z^2*x+z^2*y)+54*x*y*z+126*(x*y+x*z+y*z)"
       "-9*(x^2+y^2+z^2)-9*(x+y+z)+1",
       1},                                                                                      // Clebsch
      {"x^4+y^4+z^4-(x^2+y^2+z^2)-(x^2*y^2+y^2*z^2+z^2*x^2)+1", 1},                             // Kummer
      {"x^4-5*x^2+y^4-5*y^2+z^4-5*z^2+59/5", 1},                                                // tanglecube
      {"x^2-y^2*z", 1},                                                                         // Whitney
      {"4*(233/89*x^2-y^2)*(233/89*y^2-z^2)*(233/89*z^2-x^2)-(1+233/72)*(x^2+y^2+z^2-1)^2", 1}, // near Barth's sextic
      {"(x+2*y-3*z)^2", 1},
      {"(3*x-1)^2+(7*y-1)^2+(5*z-1)^2", 1},
      {"(3*x-1)^2+(7*y-1)^2+(5*z-1)^2-1/10^30", 1},
      {"x^2*y^2+y^2*z^2+z^2*x^2", 1},
      {"(x^2+y^2-2)^2+(3*z-1)^2", 1},
      {"x^2+y^2+z^2+1/10^30", 0},
      {"(x+y+z)^2+1/10^30", 0}};
  for (const auto& [text, some] : surfaces) {
    const auto result = plot<3>(text, box, 6);
    EXPECT_EQ(result.unknown, 0U) << text;
    EXPECT_EQ(result.hit.empty(), some == 0) << text;
  }
}

/// sign * radicand^(1/order): an irrational coordinate that is compared with rationals by their powers alone.
struct Radical
{
  int sign;
  Rational radicand;
  unsigned order;

  /// The sign of the number minus q.
  [[nodiscard]] int compare(const Rational& q) const
  {
    if (sgn(q) != sign) return sign > sgn(q) ? 1 : -1;
    Rational power = 1;
    for (unsigned k = 0; k < order; ++k) power *= abs(q);
    return sign * (radicand > power ? 1 : radicand < power ? -1 : 0);
  }
};
using Radical_point = std::array<Radical, 3>;

std::set<Cell<3>> cells_of(const std::vector<Radical_point>& points, const Grid<3>& grid)
{
  std::set<Cell<3>> result;
  check::all_cells<3>(grid.resolution()).for_each([&](const Cell<3>& cell, Verdict) {
    const auto box = grid.cell_box(cell);
    for (const auto& point : points) {
      bool inside = true;
      for (std::size_t k = 0; k < 3; ++k)
        inside = inside && point[k].compare(box[k].lower()) >= 0 && point[k].compare(box[k].upper()) <= 0;
      if (inside) result.insert(cell);
    }
  });
  return result;
}

/// A sum of squares that vanishes just where its parts do, and those points.
struct Isolated
{
  const char* polynomial;
  std::vector<Radical_point> points;
};

std::vector<Radical_point> with_all_signs(const Rational& x, const Rational& y, const Rational& z)
{
  std::vector<Radical_point> result;
  for (const int i : {-1, 1})
    for (const int j : {-1, 1})
      for (const int k : {-1, 1}) result.push_back({{{i, x, 2}, {j, y, 2}, {k, z, 2}}});
  return result;
}

const std::vector<Isolated>& isolated_points_of_space()
{
  const Rational third(2, 3);
  static const std::vector<Isolated> cases = {
      {"(x^2-2)^2+(y^2-3)^2+(z^2-5)^2", with_all_signs(2, 3, 5)},
      {"(x^2+y^2+z^2-2)^2+(x-y)^2+(y-z)^2",
       {{{{1, third, 2}, {1, third, 2}, {1, third, 2}}}, {{{-1, third, 2}, {-1, third, 2}, {-1, third, 2}}}}},
      {"(x^3-2)^2+(y^3-3)^2+(z-x*y)^2", {{{{1, 2, 3}, {1, 3, 3}, {1, 6, 3}}}}},
      {"(x^5-2)^2+(y^5-3)^2+(z^5-7)^2", {{{{1, 2, 5}, {1, 3, 5}, {1, 7, 5}}}}},
      // a twofold point beside a simple one over the same point of the plane, and a cylinder that has no real point
      {"((x^2-2)^2+(z^2-3)^2+(y^2-2)^2)*((x^2-2)^2+(y^2-2)^2+(z^3-7)^2)*(x^2+1)",
       {{{{1, 2, 2}, {1, 2, 2}, {1, 7, 3}}},
        {{{1, 2, 2}, {-1, 2, 2}, {1, 7, 3}}},
        {{{-1, 2, 2}, {1, 2, 2}, {1, 7, 3}}},
        {{{-1, 2, 2}, {-1, 2, 2}, {1, 7, 3}}},
        {{{1, 2, 2}, {1, 2, 2}, {1, 3, 2}}},
        {{{1, 2, 2}, {1, 2, 2}, {-1, 3, 2}}},
        {{{1, 2, 2}, {-1, 2, 2}, {1, 3, 2}}},
        {{{1, 2, 2}, {-1, 2, 2}, {-1, 3, 2}}},
        {{{-1, 2, 2}, {1, 2, 2}, {1, 3, 2}}},
        {{{-1, 2, 2}, {1, 2, 2}, {-1, 3, 2}}},
        {{{-1, 2, 2}, {-1, 2, 2}, {1, 3, 2}}},
        {{{-1, 2, 2}, {-1, 2, 2}, {-1, 3, 2}}}}}};
  return cases;
}

const Rational_box<3> room = {Rational_interval(-3, 3), Rational_interval(-3, 3), Rational_interval(-3, 3)};

TEST(Ideal_raster, finds_isolated_irrational_points_of_space)
{
  for (const std::uint32_t resolution : {3U, 4U})
    for (const auto& [text, points] : isolated_points_of_space()) {
      const auto truth = cells_of(points, Grid<3>(room, {resolution, resolution, resolution}));
      const auto found = plot<3>(text, room, resolution);
      EXPECT_EQ(found.hit, truth) << text;
      EXPECT_EQ(found.unknown, 0U) << text;
    }
}

TEST(Ideal_raster, tells_tiny_spheres_from_near_misses)
{
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& [text, points] = isolated_points_of_space()[k];
    const auto truth = cells_of(points, Grid<3>(room, {3, 3, 3}));
    const auto spheres = plot<3>(std::string(text) + "-1/10^30", room, 3);
    EXPECT_EQ(spheres.hit, truth) << text;
    EXPECT_EQ(spheres.unknown, 0U) << text;
    const auto misses = plot<3>(std::string(text) + "+1/10^30", room, 3); // the negative control
    EXPECT_TRUE(misses.hit.empty()) << text;
    EXPECT_EQ(misses.unknown, 0U) << text;
  }
}

TEST(Ideal_raster, finds_closed_curves_inside_a_cell)
{
  // two circles of radius 1/10 at the heights +- sqrt 2, each in the middle of a cell's base
  const auto circles = plot<3>("(x^2+y^2-1/100)^2+(z^2-2)^2", room, 3);
  EXPECT_EQ(circles.hit, (std::set<Cell<3>>{{1, 1, 0}, {1, 1, 2}}));
  EXPECT_EQ(circles.unknown, 0U);
  EXPECT_TRUE(plot<3>("(x^2+y^2-1/100)^2+(z^2-2)^2+1/10^20", room, 3).hit.empty());
  // a surface elsewhere changes nothing
  const auto both = plot<3>("((x^2-2)^2+(y^2-3)^2+(z^2-5)^2)*(10*x+1)", room, 3);
  auto expected = cells_of(with_all_signs(2, 3, 5), Grid<3>(room, {3, 3, 3}));
  for (std::uint32_t j = 0; j < 3; ++j)
    for (std::uint32_t k = 0; k < 3; ++k) expected.insert({1, j, k});
  EXPECT_EQ(both.hit, expected);
  EXPECT_EQ(both.unknown, 0U);
}

TEST(Ideal_raster, says_unknown_with_a_reason_where_degrees_are_too_high)
{
  const auto f = parse_polynomial<3>("((x^5-2)*(1+y+z))^2+((y^5-3)*(1+x+z))^2+((z^5-7)*(1+x+y))^2", {"x", "y", "z"});
  const auto decision = Cell_decider<3>(f, Grid<3>(room, {3, 3, 3})).decide({2, 2, 2});
  EXPECT_EQ(decision.verdict, Verdict::unknown);
  EXPECT_NE(decision.reason.find("degree is too high"), std::string::npos) << decision.reason;
}

struct Paper_example
{
  const char* polynomial;
  std::size_t ideal; ///< cells at the paper's resolution that hold a zero
};

TEST(Ideal_raster, knows_the_ideal_rasters_of_the_curves_of_the_paper)
{
  const std::vector<Paper_example> examples = {
      {"15/4+8*x-16*x^2+8*y-112*x*y+128*x^2*y-16*y^2+128*x*y^2-128*x^2*y^2", 522},
      {"20160*x^5-30176*x^4+14156*x^3-2344*x^2+151*x+237-480*y", 432},
      {"945/1000*x*y-943214/100000*x^2*y^3+74554/10000*x^3*y^2+y^4-x^3", 592},
      {"x^9-x^7*y+3*x^2*y^6-y^3+y^5+y^4*x-4*y^4*x^3", 770},
      {"-1801/50+280*x-816*x^2+1056*x^3-512*x^4+1601/25*y-512*x*y+1536*x^2*y-2048*x^3*y+1024*x^4*y", 456},
      {"601/9-872/3*x+544*x^2-512*x^3+256*x^4-2728/9*y+2384/3*x*y-768*x^2*y+5104/9*y^2-2432/"
       "3*x*y^2+768*x^2*y^2-512*y^3+256*y^4",
       454},
      {"-13+32*x-288*x^2+512*x^3-256*x^4+64*y-112*y^2+256*x*y^2-256*x^2*y^2", 422},
      {"-169/64+51/8*x-11*x^2+8*x^3+9*y-8*x*y-9*y^2+8*x*y^2", 804},
      {"476/10-2208/10*x+4768/10*x^2-512*x^3+256*x^4-2208/10*y+512*x*y-512*x^2*y+4768/"
       "10*y^2-512*x*y^2+512*x^2*y^2-512*y^3+256*y^4",
       1080},
      {"55/256-x+2*x^2-2*x^3+x^4-55/64*y+2*x*y-2*x^2*y+119/64*y^2-2*x*y^2+2*x^2*y^2-2*y^3+y^4", 772}};
  for (const auto& [text, ideal] : examples) {
    const auto f = parse_polynomial<2>(text, {"x", "y"});
    const Grid<2> grid({Rational_interval(0, 1), Rational_interval(0, 1)}, {256, 256});
    const auto raster = ideal_raster(f, grid, localize_fast(f, grid).cells);
    EXPECT_EQ(raster.cells.unknown(), 0U) << text;
    EXPECT_EQ(raster.cells.hit(), ideal) << text;
  }
}

TEST(Ideal_raster, knows_the_ideal_rasters_of_the_surfaces_of_the_paper)
{
  const std::vector<Paper_example> examples = {
      {"x+2*y+3*z-2", 1791},
      {"100*x^2+100*y^2+100*z^2-81", 3944},
      {"100*x^2+100*y^2-81", 3712},
      {"100*x^2+100*y^2-81*z^2", 3152},
      {"64-500*x^2+625*x^4-500*y^2+1250*x^2*y^2+625*y^4+400*z^2+1250*x^2*z^2+1250*y^2*z^2+625*z^4", 1840},
      {"-459+15600*x-55000*x^2+90000*x^4-45000*y^2+180000*x^2*y^2+90000*y^4+12600*z^2+180000*x^2*z^2+180000*y^2*z^2+"
       "90000*z^4",
       2032},
      {"16-32*x-25*x^2+50*x^3-25*y^2+50*x*y^2-25*z^2+50*x*z^2", 4852},
      {"1296-3625*x^2+2500*x^4-3625*y^2+5000*x^2*y^2+2500*y^4-3625*z^2+5000*x^2*z^2+5000*y^2*z^2+2500*z^4", 6976},
      {"-16*x^2+25*x^4+50*x^2*y^2+25*y^4+50*x^2*z^2+50*y^2*z^2+25*z^4", 1544},
      {"-1+4*x-4*x^2+2*y^2-8*x*y^2+8*x^2*y^2+8*z^2", 3200}};
  const Rational_interval side(-1, 1);
  for (const auto& [text, ideal] : examples) {
    const auto f = parse_polynomial<3>(text, {"x", "y", "z"});
    const Grid<3> grid({side, side, side}, {32, 32, 32});
    const auto raster = ideal_raster(f, grid, localize_fast(f, grid).cells);
    EXPECT_EQ(raster.cells.unknown(), 0U) << text;
    EXPECT_EQ(raster.cells.hit(), ideal) << text;
  }
}

TEST(Ideal_raster, keeps_what_is_proved_when_stopped)
{
  const auto f = parse_polynomial<2>("x^2+y^2-2", {"x", "y"});
  const Grid<2> grid(around, {64, 64});
  int reports = 0;
  Ideal_raster_options options;
  options.progress = [&](std::uint64_t done, std::uint64_t total) {
    EXPECT_LE(done, total);
    return ++reports < 20;
  };
  const auto whole = ideal_raster(f, grid, all_cells<2>({64, 64})).cells;
  const auto raster = ideal_raster(f, grid, all_cells<2>({64, 64}), options);
  EXPECT_GT(raster.cells.unknown(), 0U);
  EXPECT_EQ(raster.reasons.size(), 1U);
  raster.cells.for_each([&](const Cell<2>& cell, Verdict verdict) {
    if (verdict == Verdict::hit) {
      EXPECT_EQ(whole.at(cell), Verdict::hit);
    }
  });
  whole.for_each([&](const Cell<2>& cell, Verdict) { EXPECT_NE(raster.cells.at(cell), Verdict::empty); });
}

/// Stops a decision again and again, each time later, until it comes to an end.
template <std::size_t D>
std::pair<Verdict, int> decide_with_stops(const std::string& text, const Rational_box<D>& box, std::uint32_t resolution,
                                          const Cell<D>& cell)
{
  constexpr std::array<const char*, 3> names = {"x", "y", "z"};
  std::array<std::string, D> variables;
  for (std::size_t k = 0; k < D; ++k) variables[k] = names[k];
  Resolution<D> side;
  side.fill(resolution);
  long left = 0;
  Cell_decider<D> decider(parse_polynomial<D>(text, variables), Grid<D>(box, side), [&left] {
    if (left-- <= 0) throw Cancelled("stopped by the test");
  });
  int stops = 0;
  for (long calls = 0;; calls += 1 + calls / 4, ++stops) {
    left = calls;
    try {
      return {decider.decide(cell).verdict, stops};
    } catch (const Cancelled&) {
    }
  }
}

TEST(Ideal_raster, decides_right_after_it_was_stopped_anywhere)
{
  const auto check = [](std::pair<Verdict, int> result, Verdict truth, const std::string& text) {
    EXPECT_EQ(result.first, truth) << text;
    EXPECT_GT(result.second, 10) << text; // it was stopped at all
  };
  const std::string point = "(x^2-2)^2+(y^2-3)^2";
  check(decide_with_stops<2>(point, around, 4, {3, 3}), Verdict::hit, point);
  const std::string valley = "((8*x^4-8*x^2+1)-(16*y^5-20*y^3+5*y))^2+1/10^30";
  check(decide_with_stops<2>(valley, around, 4, {2, 2}), Verdict::empty, valley);
  const std::string space = "(x^2-2)^2+(y^2-3)^2+(z^2-5)^2";
  check(decide_with_stops<3>(space, room, 3, {2, 2, 2}), Verdict::hit, space);
}

TEST(Ideal_raster, refuses_the_zero_polynomial)
{
  EXPECT_THROW((void)ideal_raster(Polynomial<Rational, 2>(), Grid<2>(around, {4, 4}), {}), Invalid_input);
}

TEST(Ideal_raster, counts_the_rung_that_decided)
{
  const auto total = [](const std::array<std::uint64_t, rung_count>& counts, Rung rung) {
    return counts[static_cast<std::size_t>(rung)];
  };
  const auto circle = plot<2>("x^2+y^2-7/3", around, 16).rungs;
  EXPECT_GT(total(circle.hit, Rung::integers), 0U); // signs of corners
  EXPECT_GT(total(circle.empty, Rung::intervals), 0U);
  const auto oval = plot<2>("(x-1/2)^2+(y-1/2)^2-1/3", around, 4).rungs; // crosses edges, not beyond corners
  EXPECT_GT(total(oval.hit, Rung::intervals), 0U);
  const auto point = plot<2>("(x^2-2)^2+(y^2-3)^2", around, 4).rungs;
  EXPECT_EQ(total(point.hit, Rung::algebra), 4U);
  const auto corner = plot<2>("x*(y-1)", around, 4).rungs; // zero at corners, which intervals cannot tell
  EXPECT_GT(total(corner.hit, Rung::integers), 0U);
  const auto fine = plot<2>("10^700*(x^2+y^2-7/3)+10^680*x-y", around, 16).rungs;
  EXPECT_EQ(total(fine.empty, Rung::integers) + total(fine.empty, Rung::algebra), 0U);
  const auto narrow =
      plot<2>("(x-1/2)^2+(y-1/2)^2-1/4+1/10^30+1/10^400", around, 4).rungs; // for doubles it touches edges
  EXPECT_GT(total(narrow.empty, Rung::mpfr), 0U);
}

/// The verdicts of all cells, unless that takes more than so many steps, each of which asks whether to go on.
template <std::size_t D>
Ideal_raster<D> decide_within(int steps, const std::string& text, const Rational_interval& side, std::uint32_t cells)
{
  constexpr std::array<const char*, 3> names = {"x", "y", "z"};
  std::array<std::string, D> variables;
  std::copy_n(names.begin(), D, variables.begin());
  Rational_box<D> box;
  box.fill(side);
  Resolution<D> resolution;
  resolution.fill(cells);
  Ideal_raster_options options;
  options.progress = [&](std::uint64_t, std::uint64_t) { return steps-- > 0; };
  return ideal_raster(parse_polynomial<D>(text, variables), Grid<D>(box, resolution), all_cells<D>(resolution),
                      options);
}

// The gradient vanishes along the whole surface s = 0 of s^2 + r: no subdivision and no outline would end soon.
TEST(Ideal_raster, near_misses_along_a_surface_are_seen_at_once)
{
  for (const auto* const text : {"((x^2+y^2-z)*(x+y-z+1/3))^2+1/10^9", "(x^2+y^2+z^2-1)^2+1/10^8"}) {
    const auto raster = decide_within<3>(2000, text, {-1, 1}, 32);
    EXPECT_EQ(raster.cells.plotted(), 0U) << text;
    EXPECT_GT(raster.rungs.empty[static_cast<std::size_t>(Rung::algebra)], 0U) << text;
  }
}

std::size_t allocations = 0; // of numbers
void* allocate(std::size_t size)
{
  ++allocations;
  return std::malloc(size);
}
void* reallocate(void* memory, std::size_t, std::size_t size) { return std::realloc(memory, size); }
void release(void* memory, std::size_t) { std::free(memory); }

/// The numbers that a decision makes.
template <std::size_t D>
std::pair<Cell_decision<D>, std::size_t> counted(Cell_decider<D>& decider, const Cell<D>& cell)
{
  allocations = 0;
  mp_set_memory_functions(allocate, reallocate, release);
  auto decision = decider.decide(cell);
  mp_set_memory_functions(nullptr, nullptr, nullptr);
  return {std::move(decision), allocations};
}

/// The least and the greatest value of |x|^n on a side.
std::pair<Rational, Rational> range_of_power(const Rational_interval& side, unsigned long n)
{
  const auto power = [n](const Rational& x) {
    Rational result;
    mpz_pow_ui(result.get_num_mpz_t(), x.get_num_mpz_t(), n);
    mpz_pow_ui(result.get_den_mpz_t(), x.get_den_mpz_t(), n);
    return result;
  };
  const Rational low = power(abs(side.lower()));
  const Rational high = power(abs(side.upper()));
  const bool holds_zero = sgn(side.lower()) * sgn(side.upper()) <= 0;
  return {holds_zero ? Rational(0) : std::min(low, high), std::max(low, high)};
}

/// The sum of |x|^n over all axes takes all values between its least and its greatest one: whether 1 is among them.
template <std::size_t D>
bool meets_ball(const Rational_box<D>& box, unsigned long n)
{
  Rational least = 0;
  Rational most = 0;
  for (const auto& side : box) {
    const auto [low, high] = range_of_power(side, n);
    least += low;
    most += high;
  }
  return least <= 1 && most >= 1;
}

/// Every cell that floats leave open is decided rightly, and its dense form is not made.
template <std::size_t D>
void expect_ball(const std::string& text, unsigned long n, const Rational_interval& side, std::uint32_t cells,
                 std::size_t most_numbers)
{
  SCOPED_TRACE(text);
  constexpr std::array<const char*, 3> names = {"x", "y", "z"};
  std::array<std::string, D> variables;
  std::copy_n(names.begin(), D, variables.begin());
  Rational_box<D> box;
  box.fill(side);
  Resolution<D> resolution;
  resolution.fill(cells);
  const Grid<D> grid(box, resolution);
  const auto f = parse_polynomial<D>(text, variables);
  Cell_decider<D> decider(f, grid);
  std::size_t open = 0;
  localize_fast(f, grid).cells.for_each([&](const Cell<D>& cell, Verdict known) {
    const auto where = grid.cell_box(cell);
    const auto truth = meets_ball<D>(where, n) ? Verdict::hit : Verdict::empty;
    if (known == Verdict::hit) {
      EXPECT_EQ(truth, known);
      return;
    }
    ++open;
    const auto [decision, numbers] = counted(decider, cell);
    EXPECT_EQ(decision.verdict, truth);
    if (truth == Verdict::hit) {
      EXPECT_EQ(check::complaint<D>(decision.witness, f, where), "");
    }
    EXPECT_LT(numbers, most_numbers);
  });
  EXPECT_GT(open, 0U);
}

// Of a million coefficients three or four are not zero.
TEST(Ideal_raster, few_terms_of_high_degree_are_decided_by_their_terms)
{
  expect_ball<3>("x^50 + y^50 + z^50 - 1", 50, {-2, 2}, 32, 50'000);
  expect_ball<3>("x^50 + y^50 + z^50 - 1", 50, {Rational(-9, 4), Rational(7, 4)}, 32, 50'000);
  expect_ball<3>("x^100 + y^100 + z^100 - 1", 100, {-2, 2}, 32, 50'000);
  expect_ball<2>("x^1000 + y^1000 - 1", 1000, {-2, 2}, 64, 50'000);
  expect_ball<2>("x^1000 + y^1000 - 1", 1000, {-2, 2}, 100, 50'000);
}

TEST(Ideal_raster, zeros_that_corners_do_not_show_are_found_by_terms)
{
  // circles of the norm of degree 100 and 60 around the centre of a cell, and what they would be for a larger constant
  const Grid<2> one({Rational_interval(-1, 1), Rational_interval(-2, 1)}, {1, 1});
  const auto decide = [&](const std::string& text) {
    Cell_decider<2> decider(parse_polynomial<2>(text, {"x", "y"}), one);
    auto [decision, numbers] = counted(decider, {0, 0});
    EXPECT_LT(numbers, 50'000U) << text;
    if (decision.verdict == Verdict::hit) {
      const auto g = transform<Rational>(decider.square_free(), [](const Integer& c) { return Rational(c); });
      EXPECT_EQ(check::complaint<2>(decision.witness, g, one.cell_box({0, 0})), "") << text;
    }
    return decision.verdict;
  };
  EXPECT_EQ(decide("x^100 + y^100 - 1/3^100"), Verdict::hit);
  EXPECT_EQ(decide("x^100 + y^100 + 1/10^200"), Verdict::empty);
  EXPECT_EQ(decide("x^60*y^60 + x^80 + y^80 - x*y/10^9"), Verdict::hit);
  EXPECT_EQ(decide("x^61 - y^80 + 2^81"), Verdict::empty);
  EXPECT_EQ(decide("x^61 - y^80 + 2^80"), Verdict::hit);
}

TEST(Ideal_raster, where_values_lie_beyond_doubles)
{
  const Rational_interval side(-2, 2);
  const Grid<2> grid({side, side}, {64, 64});
  const auto f = parse_polynomial<2>("x^1000*y^1000+x-y/3", {"x", "y"});
  const auto candidates = localize_fast(f, grid).cells;
  const auto raster = ideal_raster(f, grid, candidates);
  EXPECT_EQ(raster.cells.unknown(), 0U);
  Cell_decider<2> decider(f, grid);
  candidates.for_each([&](const Cell<2>& cell, Verdict) {
    const auto [decision, numbers] = counted(decider, cell);
    EXPECT_EQ(decision.verdict, raster.cells.at(cell));
    EXPECT_LT(numbers, 250'000U);
    if (decision.verdict == Verdict::hit) {
      EXPECT_EQ(check::complaint<2>(decision.witness, f, grid.cell_box(cell)), "");
    }
  });
  EXPECT_EQ(raster.cells.at({32, 32}), Verdict::hit); // the origin
  EXPECT_EQ(raster.cells.at({0, 63}), Verdict::empty);
}

// A dense form has 10^9 coefficients: a cell that needs it stays open, and the others do not.
TEST(Ideal_raster, more_coefficients_than_memory_holds_cost_one_cell)
{
  const Rational_interval side(-1, 1);
  const Grid<3> grid({side, side, side}, {4, 4, 4});
  Cell_decider<3> decider(parse_polynomial<3>("x^1000*y^1000*z^1000 + (3*x-1)^2 + (5*y-1)^2", {"x", "y", "z"}), grid);
  EXPECT_EQ(decider.decide({0, 0, 0}).verdict, Verdict::empty);
  EXPECT_EQ(decider.decide({3, 3, 3}).verdict, Verdict::empty);
  const auto decision = decider.decide({2, 2, 2}); // with the zero (1/3, 1/5, 0)
  EXPECT_EQ(decision.verdict, Verdict::unknown);
  EXPECT_NE(decision.reason.find("1003003001 coefficients"), std::string::npos) << decision.reason;
}

// The gradient is constant along x = y = -z: only the boundaries of cells are asked.
TEST(Ideal_raster, nearly_a_power_of_a_plane)
{
  const auto raster = decide_within<3>(4000, "(x+y+z-1/3)^16+x/10^20", {-1, 1}, 8);
  EXPECT_EQ(raster.cells.unknown(), 0U);
  Rational_box<3> box;
  box.fill(Rational_interval(-1, 1));
  const Grid<3> grid(box, {8, 8, 8});
  // zeros are where x <= 0 and |x+y+z-1/3| = (-x/10^20)^(1/16)
  raster.cells.for_each([&](const Cell<3>& cell, Verdict) { EXPECT_LE(grid.cell_box(cell)[0].lower(), 0); });
  std::uint64_t sure = 0;
  check::all_cells<3>({8, 8, 8}).for_each([&](const Cell<3>& cell, Verdict) {
    const auto sides = grid.cell_box(cell);
    const Rational least = sides[0].lower() + sides[1].lower() + sides[2].lower() - Rational(1, 3);
    const Rational most = sides[0].upper() + sides[1].upper() + sides[2].upper() - Rational(1, 3);
    const Rational far(1, 17); // 17^16 < 10^20
    const bool near = sides[0].lower() <= 0 && least <= far && most >= -far;
    if (!near) {
      EXPECT_EQ(raster.cells.at(cell), Verdict::empty);
    }
    if (sides[0].upper() <= 0 && least < -far && most > far) {
      ++sure;
      EXPECT_EQ(raster.cells.at(cell), Verdict::hit);
    }
  });
  EXPECT_GT(sure, 10U);
}

} // namespace
