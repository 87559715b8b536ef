// SPDX-License-Identifier: LGPL-3.0-or-later
#include "mesh_checks.h"

#include <corral/errors.h>
#include <corral/geometry/solve.h>
#include <corral/polynomial/arithmetic.h>

#include <numeric>
#include <random>

namespace corral {
namespace {

using test::box;
using test::curve;

unsigned total_multiplicity(const Plane_zeros& zeros)
{
  return std::accumulate(zeros.points.begin(), zeros.points.end(), 0U,
                         [](unsigned sum, const Algebraic_point& p) { return sum + p.multiplicity(); });
}

TEST(solve, finds_all_zeros_with_multiplicities)
{
  // Bezout: all zeros of these are real and finite.
  const auto grid = solve(curve("(x-1)*(x-2)*(x-3)"), curve("(y-1)^2*(y+1)"));
  EXPECT_EQ(grid.points.size(), 6U);
  EXPECT_EQ(total_multiplicity(grid), 9U);
  const auto tangent = solve(curve("y - x^2"), curve("y"));
  ASSERT_EQ(tangent.points.size(), 1U);
  EXPECT_EQ(tangent.points[0].multiplicity(), 2U);
  EXPECT_EQ(tangent.points[0].rational(), (Rational_point<2>{0, 0}));
  const auto cusps = solve(curve("y^2 - x^3"), curve("x^2 - y^3"));
  EXPECT_EQ(cusps.points.size(), 2U);
  EXPECT_EQ(cusps.points[0].multiplicity(), 4U);
  const auto circles = solve(curve("x^2 + y^2 - 4"), curve("(x-1)^2 + y^2 - 4"));
  EXPECT_EQ(circles.points.size(), 2U); // one above the other
  EXPECT_LT(circles.points[0], circles.points[1]);
  EXPECT_EQ(circles.points[0].coordinate(0).polynomial(), circles.points[1].coordinate(0).polynomial());
}

TEST(solve, keeps_to_the_closed_box)
{
  const auto f = curve("x^2 + y^2 - 2");
  const auto g = curve("x - y");
  EXPECT_EQ(solve(f, g).points.size(), 2U);
  EXPECT_EQ(solve(f, g, box(0, 1, 0, 1)).points.size(), 1U); // a corner
  EXPECT_EQ(solve(f, g, box(-1, 1, -1, 1)).points.size(), 2U);
  EXPECT_EQ(solve(f, g, box(2, 3, -3, 3)).points.size(), 0U);
}

TEST(solve, reports_common_curves)
{
  const auto zeros = solve(curve("(x^2 + y^2 - 1)*(x - 2)"), curve("(x^2 + y^2 - 1)*(y - 3)"));
  EXPECT_EQ(zeros.common_curve.total_degree(), 2U);
  ASSERT_EQ(zeros.points.size(), 1U);
  EXPECT_EQ(zeros.points[0].rational(), (Rational_point<2>{2, 3}));
  EXPECT_THROW((void)solve(curve("x"), Polynomial<Rational, 2>()), Invalid_input);
}

TEST(Algebraic_point, refines_compares_and_knows_signs)
{
  const auto first = solve(curve("x^2 - 2"), curve("y^2 - 3"));
  ASSERT_EQ(first.points.size(), 4U);
  EXPECT_TRUE(std::is_sorted(first.points.begin(), first.points.end()));
  auto p = first.points.back();
  EXPECT_FALSE(p.rational());
  p.refine_to(Rational(1, 1000000000));
  EXPECT_LE(p.box()[0].upper() - p.box()[0].lower(), Rational(1, 1000000000));
  EXPECT_TRUE(contains(p.box()[0] * p.box()[0], 2));
  EXPECT_EQ(p.sign_of(curve("x^2*y^2 - 6")), 0);
  EXPECT_EQ(p.sign_of(curve("x*y - 2")), 1);
  EXPECT_EQ(p.sign_of(curve("x*y - 245/100")), -1); // the root of six is 2.4494...
  const auto second = solve(curve("x*y*x*y - 6"), curve("y - x^3/2*y"), box(1, 2, 1, 2)); // another way to other points
  const auto same = solve(curve("x^2*y^2 - 6"), curve("3*x^2 - 2*y^2"), box(1, 2, 1, 2));
  ASSERT_EQ(same.points.size(), 1U);
  EXPECT_EQ(same.points[0], p);
  for (const auto& q : second.points) EXPECT_NE(q, p);
}

TEST(solve, agrees_with_products_of_known_roots_in_random_coordinates)
{
  std::mt19937 random(3);
  for (int round = 0; round < 20; ++round) {
    const auto pick = [&] { return Rational(static_cast<long>(random() % 19) - 9); };
    // Lines through chosen points: every pair of lines of f and g meets in one real point.
    Polynomial<Rational, 2> f = constant<Rational, 2>(1);
    Polynomial<Rational, 2> g = constant<Rational, 2>(1);
    for (int k = 0; k < 3; ++k) {
      f = f * collect<Rational, 2>({{{1, 0}, pick()}, {{0, 1}, 10 + pick()}, {{0, 0}, pick()}});
      g = g * collect<Rational, 2>({{{1, 0}, 31 + pick()}, {{0, 1}, pick()}, {{0, 0}, pick()}});
    }
    const auto zeros = solve(f, g);
    if (zeros.common_curve.is_constant()) {
      EXPECT_EQ(total_multiplicity(zeros), 9U) << round;
    }
    for (const auto& p : zeros.points) {
      EXPECT_TRUE(p.rational());
      EXPECT_EQ(p.sign_of(f), 0);
      EXPECT_EQ(p.sign_of(g), 0);
    }
  }
}

TEST(singular_points, are_found_with_their_order)
{
  const auto find = [](const char* text) { return singular_points(curve(text)); };
  const auto trifolium = find("(x^2 + y^2)^2 - x^3 + 3*x*y^2");
  ASSERT_EQ(trifolium.size(), 1U);
  EXPECT_EQ(trifolium[0].order, 3U);
  EXPECT_EQ(find("(x^2 - 2)^2 + (y^2 - 3)^2").size(), 4U);
  EXPECT_EQ(find("x^2 + y^2 - 1").size(), 0U);
  EXPECT_EQ(find("(x + 3*y)*(x - y)").size(), 1U); // a line along the first direction tried
}

TEST(isolated_points, have_no_branches)
{
  const auto acnode = isolated_points(curve("y^2 + x^2*(1 - x)"));
  ASSERT_EQ(acnode.size(), 1U);
  EXPECT_EQ(acnode[0].rational(), (Rational_point<2>{0, 0}));
  EXPECT_EQ(isolated_points(curve("y^2 - x^2*(x + 1)")).size(), 0U);
  EXPECT_EQ(isolated_points(curve("(x^2 - 2)^2 + (y^2 - 3)^2")).size(), 4U);
  EXPECT_EQ(isolated_points(curve("(x^2 - 2)^2 + (y^2 - 3)^2"), box(0, 2, -2, 2)).size(), 2U);
  EXPECT_EQ(isolated_points(curve("((x^2 - 2)^2 + (y^2 - 3)^2)*(x*y - 1)*(x - y)")).size(), 4U);
  EXPECT_EQ(isolated_points(curve("(x^2 - 2)^2 + (y - 1)^2*(x^2 - y)")).size(), 0U + 2U);
}

TEST(tangent_points, are_smooth)
{
  const auto circle = curve("x^2 + y^2 - 2");
  EXPECT_EQ(tangent_points(circle, 0).size(), 2U);
  EXPECT_EQ(tangent_points(circle, 1).size(), 2U);
  EXPECT_EQ(tangent_points(curve("y^2 - x^3"), 1).size(), 0U);
}

} // namespace
} // namespace corral
