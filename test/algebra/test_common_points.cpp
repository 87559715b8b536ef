// SPDX-License-Identifier: LGPL-3.0-or-later
#include "../decision/check_witness.h"
#include "exact_values.h"

#include <algebra/Extreme_points.h>
#include <algebra/Plane_system.h>

#include <corral/polynomial/arithmetic.h>

#include <gtest/gtest.h>

#include <set>

namespace {

using namespace corral;
using namespace corral::exact;

Rational_box<2> square(const Rational& from, const Rational& to)
{
  return {Rational_interval(from, to), Rational_interval(from, to)};
}
Rational_box<3> cube(const Rational& from, const Rational& to)
{
  return {Rational_interval(from, to), Rational_interval(from, to), Rational_interval(from, to)};
}

/// Lines a x + b y + c with full coefficients: their common points are known by Cramer's rule.
struct Line
{
  Integer a;
  Integer b;
  Integer c;

  [[nodiscard]] Polynomial<Integer, 2> polynomial() const
  {
    return collect<Integer, 2>({{{1, 0}, a}, {{0, 1}, b}, {{0, 0}, c}});
  }
};

Rational_point<2> common(const Line& p, const Line& q)
{
  const Rational determinant = p.a * q.b - q.a * p.b;
  return {Rational(p.b * q.c - q.b * p.c) / determinant, Rational(q.a * p.c - p.a * q.c) / determinant};
}

TEST(Plane_system, finds_the_common_points_of_lines)
{
  truth::Random_polynomials random(21);
  for (int round = 0; round < 10; ++round) {
    std::array<std::vector<Line>, 2> lines;
    std::array<Polynomial<Integer, 2>, 2> system{constant<Integer, 2>(1), constant<Integer, 2>(1)};
    for (std::size_t k = 0; k < 2; ++k)
      for (int count = 0; count < 3; ++count) {
        lines[k].push_back({random.integer(40), random.integer(40), random.integer(40)});
        system[k] = system[k] * lines[k].back().polynomial();
      }
    const auto box = square(-1, 1);
    std::set<Rational_point<2>> expected;
    for (const Line& p : lines[0])
      for (const Line& q : lines[1]) {
        const auto point = common(p, q);
        if (abs(point[0]) <= 1 && abs(point[1]) <= 1) expected.insert(point);
      }
    Plane_system points(system[0], system[1]);
    const auto zeros = points.zeros_in(box, false, true, {});
    EXPECT_EQ(zeros.size(), expected.size());
    for (const auto& zero : zeros) {
      const auto is_inside = [&](const Rational_point<2>& point) {
        return contains(zero.box[0], point[0]) && contains(zero.box[1], point[1]);
      };
      EXPECT_EQ(std::count_if(expected.begin(), expected.end(), is_inside), 1);
      for (const auto& f : system) EXPECT_EQ(check::complaint<2>(zero, truth::over_rationals(f), box), "");
    }
    const auto nothing = check::complaint<2>(zeros.empty() ? Triangular_zero<2>{} : zeros.front(),
                                             truth::over_rationals(truth::plane("x^2 + y^2 + 1")), box);
    EXPECT_NE(nothing, ""); // negative control
  }
}

TEST(Plane_system, counts_a_tangent_point_once_and_no_complex_one)
{
  const auto count = [](const char* f, const char* g, const Rational_box<2>& box) {
    return Plane_system(truth::plane(f), truth::plane(g)).zeros_in(box, false, true, {}).size();
  };
  EXPECT_EQ(count("x^2 + y^2 - 2", "x + y - 2", square(-3, 3)), 1U);
  EXPECT_EQ(count("x^2 + y^2 - 2", "x + y - 2 - 1/10^30", square(-3, 3)), 0U);
  EXPECT_EQ(count("x^2 + y^2 - 2", "x + y - 2 + 1/10^30", square(-3, 3)), 2U);
  EXPECT_EQ(count("x^2 + y^2 - 5", "x*y - 2", square(-3, 3)), 4U);
  EXPECT_EQ(count("x^2 + y^2 - 5", "x*y - 2", square(1, 2)), 2U); // at two corners
  EXPECT_EQ(count("y^2 - x^3", "y^2 - x^5", square(-2, 2)), 3U);  // cusps at the origin, and (1, 1), (1, -1)
  EXPECT_EQ(count("x^2 - 2", "(y - x)*(y + 3)", square(-2, 2)), 2U);
}

TEST(Inner_pieces, are_found_strictly_inside_a_box_and_proved)
{
  struct Case
  {
    std::vector<const char*> system;
    Rational from;
    Rational to;
    bool has_piece;
  };
  const std::vector<Case> cases = {
      {{"x^2 + y^2 + z^2 - 1"}, -2, 2, true},
      {{"x^2 + y^2 + z^2 - 1"}, Rational(-1, 10), Rational(1, 10), false},
      {{"x^2 + y^2 + z^2 + 1"}, -2, 2, false},
      {{"(x - 1/3)^2 + (y - 1/7)^2 + (z - 1/5)^2"}, -1, 1, true}, // a point
      {{"(x^2 + y^2 + z^2 - 1/10^6)*(x^2 + y^2 + z^2 - 100)"}, -1, 1, true},
      {{"(x^2 + y^2 + z^2 + 1/10^6)*(x^2 + y^2 + z^2 - 100)"}, -1, 1, false},
      {{"x^2 + y^2 + z^2 - 1", "3*z - 1"}, -2, 2, true}, // a circle
      {{"x^2 + y^2 + z^2 - 1", "2*z - 3"}, -2, 2, false},
      {{"x^2 + y^2 + z^2 - 1", "z - 1"}, -2, 2, true}, // a tangent plane
  };
  for (const auto& given : cases) {
    SCOPED_TRACE(given.system.front());
    std::vector<Polynomial<Integer, 3>> system;
    for (const char* text : given.system) system.push_back(truth::space(text));
    Inner_pieces pieces(system, {});
    const auto box = cube(given.from, given.to);
    if (pieces.excluded(box)) {
      EXPECT_FALSE(given.has_piece);
      continue;
    }
    ASSERT_TRUE(pieces.is_feasible());
    const auto zero = pieces.zero_in(box);
    ASSERT_EQ(zero.has_value(), given.has_piece);
    if (!zero) continue;
    for (const auto& f : system) EXPECT_EQ(check::complaint<3>(*zero, truth::over_rationals(f), box), "");
    EXPECT_NE(check::complaint<3>(*zero, truth::over_rationals(truth::space("x^2 + y^2 + z^2 - 2")), box), "");
  }
}

} // namespace
