// SPDX-License-Identifier: LGPL-3.0-or-later
#include "mesh_checks.h"

#include "rounds.h"

#include <corral/geometry/solve.h>
#include <corral/polynomial/arithmetic.h>

#include <numeric>
#include <random>

namespace corral {
namespace {

using test::box;
using test::curve;

struct Circle
{
  Rational x, y, r;

  [[nodiscard]] Polynomial<Rational, 2> polynomial() const
  {
    return collect<Rational, 2>(
        {{{2, 0}, 1}, {{0, 2}, 1}, {{1, 0}, -2 * x}, {{0, 1}, -2 * y}, {{0, 0}, Rational(x * x + y * y - r * r)}});
  }
};

/// How many points two different circles share.
int common_points(const Circle& a, const Circle& b)
{
  const Rational d = (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
  const Rational outer = (a.r + b.r) * (a.r + b.r);
  const Rational inner = (a.r - b.r) * (a.r - b.r);
  if (d > outer || d < inner) return 0;
  return d == outer || d == inner ? 1 : 2;
}

TEST(products_of_circles, have_the_components_that_the_distances_tell)
{
  std::mt19937 random(5);
  for (int round = 0; round < test::rounds(60); ++round) {
    const std::size_t count = 2 + random() % 3;
    std::vector<Circle> circles;
    while (circles.size() < count) {
      const auto coordinate = [&](unsigned long n) { return Rational(static_cast<long>(random() % n), 8); };
      const Circle next{coordinate(17) - 1, coordinate(17) - 1, Rational(1, 4) + coordinate(8)};
      const auto is_same = [&](const Circle& c) { return c.x == next.x && c.y == next.y && c.r == next.r; };
      if (std::none_of(circles.begin(), circles.end(), is_same)) circles.push_back(next);
    }
    std::vector<std::size_t> parent(count);
    std::iota(parent.begin(), parent.end(), std::size_t{0});
    Polynomial<Rational, 2> f = constant<Rational, 2>(1);
    for (std::size_t i = 0; i < count; ++i) {
      f = f * circles[i].polynomial();
      for (std::size_t j = 0; j < i; ++j)
        if (common_points(circles[i], circles[j]) > 0) {
          const std::size_t from = parent[i];
          const std::size_t to = parent[j];
          std::replace(parent.begin(), parent.end(), from, to);
        }
    }
    std::sort(parent.begin(), parent.end());
    const auto expected = static_cast<std::size_t>(std::unique(parent.begin(), parent.end()) - parent.begin());
    const auto mesh = mesh_curve(f, box(-3, 4, -3, 4), {Rational(1, 10)});
    EXPECT_TRUE(mesh.is_certified()) << round;
    EXPECT_EQ(mesh.components.size(), expected) << round;
    EXPECT_EQ(mesh.closed_components(), expected) << round;
  }
}

TEST(sums_of_squares, are_the_common_zeros)
{
  std::mt19937 random(7);
  const auto pick = [&] { return Rational(Rational(static_cast<long>(random() % 15) - 7) / 3); };
  for (int round = 0; round < test::rounds(40); ++round) {
    const auto conic = [&] {
      return collect<Rational, 2>(
          {{{2, 0}, pick()}, {{1, 1}, pick()}, {{0, 2}, pick()}, {{1, 0}, pick()}, {{0, 1}, pick()}, {{0, 0}, pick()}});
    };
    const auto a = conic();
    const auto b = conic();
    const auto plane = box(-3, 3, -3, 3);
    const auto zeros = solve(a, b, plane);
    if (!zeros.common_curve.is_constant()) continue;
    const auto mesh = mesh_curve(a * a + b * b, plane, {Rational(1, 10)});
    EXPECT_TRUE(mesh.is_certified()) << round;
    EXPECT_EQ(mesh.components.size(), zeros.points.size()) << round;
    EXPECT_EQ(mesh.isolated_points(), zeros.points.size()) << round;
  }
}

} // namespace
} // namespace corral
