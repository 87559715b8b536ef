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

/// y^2 + a1 x y + a3 y = x^3 + a2 x^2 + a4 x + a6.
struct Weierstrass
{
  long a1, a2, a3, a4, a6;

  [[nodiscard]] Integer discriminant() const
  {
    const Integer b2 = a1 * a1 + 4 * a2;
    const Integer b4 = 2 * a4 + a1 * a3;
    const Integer b6 = a3 * a3 + 4 * a6;
    const Integer b8 = a1 * a1 * a6 + 4 * a2 * a6 - a1 * a3 * a4 + a2 * a3 * a3 - a4 * a4;
    return -b2 * b2 * b8 - 8 * b4 * b4 * b4 - 27 * b6 * b6 + 9 * b2 * b4 * b6;
  }
  [[nodiscard]] Polynomial<Rational, 2> polynomial() const
  {
    return collect<Rational, 2>(
        {{{0, 2}, 1}, {{1, 1}, a1}, {{0, 1}, a3}, {{3, 0}, -1}, {{2, 0}, -a2}, {{1, 0}, -a4}, {{0, 0}, -a6}});
  }
};

TEST(elliptic_curves, have_two_components_iff_the_discriminant_is_positive)
{
  std::mt19937 random(11);
  const auto pick = [&](long low, long high) {
    return low + static_cast<long>(random() % static_cast<unsigned long>(high - low + 1));
  };
  int smooth = 0;
  int both = 0;
  while (smooth < test::rounds(300)) {
    const Weierstrass e{pick(0, 1), pick(-1, 1), pick(0, 1), pick(-40, 40), pick(-60, 60)};
    const Integer discriminant = e.discriminant();
    if (discriminant == 0) continue;
    ++smooth;
    // All compact parts have |x| < 16, and |y| < 80 there.
    const auto mesh = mesh_curve(e.polynomial(), box(-16, 16, -100, 100), {Rational(1)});
    const std::size_t expected = discriminant > 0 ? 2 : 1;
    both += discriminant > 0 ? 1 : 0;
    EXPECT_TRUE(mesh.is_certified());
    EXPECT_EQ(mesh.components.size(), expected) << e.a1 << ' ' << e.a2 << ' ' << e.a3 << ' ' << e.a4 << ' ' << e.a6;
    EXPECT_EQ(mesh.closed_components(), expected - 1);
  }
  EXPECT_GT(both, smooth / 10);
  EXPECT_LT(both, smooth - smooth / 10);
}

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
  const auto pick = [&] { return Rational(static_cast<long>(random() % 15) - 7, 3); };
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
