// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/bounders/Recursive_taylor_bounder.h>
#include <corral/localization/localize.h>
#include <corral/localization/localize_with_bounder.h>
#include <corral/number/Outward_interval.h>
#include <corral/polynomial/evaluate.h>
#include <corral/polynomial/parse.h>

#include "exact_cells.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// \file
/// Curves in which two surfaces meet, with many of their points as exact rationals: no cell that holds one may be lost.
namespace {

using namespace corral;
using Point = std::array<Rational, 3>;
using System = std::vector<Polynomial<Rational, 3>>;

struct Space_curve
{
  System system;
  Rational half_side; // of the box about the origin
  std::vector<Point> points;
};

System surfaces(const char* first, const char* second)
{
  return {parse_polynomial<3>(first, {"x", "y", "z"}), parse_polynomial<3>(second, {"x", "y", "z"})};
}

// The cosine c and the sine s of an angle with the tangent u of its half give (2 c^2, 2 s c, 2 s).
Space_curve viviani()
{
  Space_curve curve{surfaces("x^2 + y^2 + z^2 - 4", "(x - 1)^2 + y^2 - 1"), 2, {}};
  for (int k = -300; k <= 300; ++k) {
    const Rational u = Rational(k) / 300;
    const Rational c = (1 - u * u) / (1 + u * u);
    const Rational s = 2 * u / (1 + u * u);
    for (const int side : {-1, 1}) curve.points.push_back({2 * c * c, 2 * side * s * c, 2 * s});
  }
  return curve;
}

// In the plane x = 1/2 lies the lemniscate (y^2 + z^2)^2 = 2 (y^2 - z^2), with a double point where the plane touches.
// Inversion in the unit circle makes it the hyperbola (y - z) (y + z) = 1/2.
Space_curve torus_and_plane()
{
  Space_curve curve{
      surfaces("(x^2 + y^2 + z^2 + 3/4)^2 - 4*(x^2 + y^2)", "x - 1/2"), Rational(3, 2), {{Rational(1, 2), 0, 0}}};
  for (int k = 1; k <= 300; ++k)
    for (const int side : {-1, 1})
      for (const auto& difference : {Rational(Rational(side * k) / 300), Rational(Rational(side * 150) / k)}) {
        const Rational sum = 1 / (2 * difference);
        const Rational y = (sum + difference) / 2;
        const Rational z = (sum - difference) / 2;
        const Rational norm = y * y + z * z;
        curve.points.push_back({Rational(1, 2), y / norm, z / norm});
      }
  return curve;
}

Space_curve tangent_spheres() // at a grid point, which eight cells share
{
  return {surfaces("(x - 1)^2 + y^2 + z^2 - 1", "(x + 1)^2 + y^2 + z^2 - 1"), 2, {{0, 0, 0}}};
}

Space_curve tangent_spheres_within_a_cell()
{
  return {surfaces("(x - 8/7)^2 + (y - 1/5)^2 + (z + 1/3)^2 - 1", "(x + 6/7)^2 + (y - 1/5)^2 + (z + 1/3)^2 - 1"),
          2,
          {{Rational(1, 7), Rational(1, 5), Rational(-1, 3)}}};
}

Grid<3> grid_of(const Space_curve& curve, std::uint32_t resolution)
{
  const Rational_interval side(-curve.half_side, curve.half_side);
  return {{side, side, side}, {resolution, resolution, resolution}};
}

// How many of the cells that hold a known point of the curve the set lacks.
std::size_t lost_cells(const Space_curve& curve, const Grid<3>& grid, const Raster<3>& cells)
{
  std::size_t lost = 0;
  for (const Point& p : curve.points) lost += test::lost_cells(cells, grid, p);
  return lost;
}

struct Named_curve
{
  const char* name;
  Space_curve curve;
};

const std::vector<Named_curve>& curves()
{
  static const std::vector<Named_curve> all{{"viviani", viviani()},
                                            {"torus and plane", torus_and_plane()},
                                            {"tangent spheres", tangent_spheres()},
                                            {"tangent spheres within a cell", tangent_spheres_within_a_cell()}};
  return all;
}

using Bounder = Recursive_taylor_bounder<Outward_interval, 3>;

TEST(Space_curves, have_the_points_that_the_tests_take_for_theirs)
{
  for (const auto& [name, curve] : curves())
    for (const Point& point : curve.points)
      for (const auto& f : curve.system) ASSERT_EQ(evaluate(f, point), 0) << name;
}

TEST(Space_curves, lose_no_point_by_subdivision)
{
  for (const auto& [name, curve] : curves())
    for (const std::uint32_t resolution : {64U, 100U, 256U}) {
      const auto grid = grid_of(curve, resolution);
      const auto found = localize<Bounder>(curve.system, grid, {}, {.sample = true, .refine_depth = 1});
      EXPECT_TRUE(found.is_guaranteed());
      EXPECT_EQ(lost_cells(curve, grid, found), 0U) << name << " at " << resolution;
      EXPECT_LT(found.plotted(), 16U * resolution) << name << " at " << resolution;
    }
}

TEST(Space_curves, lose_no_point_by_the_fast_engine)
{
  for (const auto& [name, curve] : curves())
    for (const std::uint32_t resolution : {64U, 100U, 256U, 4096U, 60000U}) {
      const auto grid = grid_of(curve, resolution);
      const auto cells = localize(curve.system, grid);
      EXPECT_EQ(lost_cells(curve, grid, cells), 0U) << name << " at " << resolution;
      EXPECT_LT(cells.plotted(), 25U * resolution) << name << " at " << resolution;
    }
}

// Negative control: of slightly smaller surfaces, points of the curves are missed.
TEST(Space_curves, lose_points_if_the_surfaces_are_moved)
{
  for (const auto& [name, curve] : curves()) {
    System moved = curve.system;
    moved[0] = moved[0] + constant<Rational, 3>(Rational(1, 8));
    const auto grid = grid_of(curve, 64);
    EXPECT_GT(lost_cells(curve, grid, localize<Bounder>(moved, grid)), 0U) << name;
    EXPECT_GT(lost_cells(curve, grid, localize(moved, grid)), 0U) << name;
  }
}

} // namespace
