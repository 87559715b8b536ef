// SPDX-License-Identifier: LGPL-3.0-or-later
#include "mesh_checks.h"
#include "reference_curves.h"
#include "stopping_run.h"

#include <corral/errors.h>
#include <corral/polynomial/arithmetic.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <ostream>
#include <vector>

namespace corral {
namespace {

using test::box;
using test::curve;

struct Case
{
  std::string name;
  std::string text;
  std::array<int, 4> sides; ///< x from, x to, y from, y to
  std::size_t components;
  std::size_t closed;
  std::size_t isolated;
  std::size_t singular;
  std::size_t boundary;

  friend std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }
};

class Known_curve : public testing::TestWithParam<Case>
{
};

TEST_P(Known_curve, has_its_topology)
{
  const Case& c = GetParam();
  const auto f = curve(c.text);
  const Rational tolerance(1, 10);
  const auto mesh = mesh_curve(f, box(c.sides[0], c.sides[1], c.sides[2], c.sides[3]), tolerance);
  EXPECT_TRUE(mesh.is_certified());
  EXPECT_EQ(mesh.components.size(), c.components);
  EXPECT_EQ(mesh.closed_components(), c.closed);
  EXPECT_EQ(mesh.isolated_points(), c.isolated);
  EXPECT_EQ(mesh.singular_points(), c.singular);
  EXPECT_EQ(mesh.boundary_points(), c.boundary);
  EXPECT_EQ(test::find_crossing(mesh), "");
  EXPECT_EQ(test::find_stray(mesh, f, tolerance), "");
}

INSTANTIATE_TEST_SUITE_P(
    Plane, Known_curve,
    testing::Values(Case{"circle", "x^2 + y^2 - 1", {-2, 2, -2, 2}, 1, 1, 0, 0, 0},
                    Case{"squared_circle", "(x^2 + y^2 - 1)^2", {-2, 2, -2, 2}, 1, 1, 0, 0, 0},
                    Case{"touches_from_inside", "x^2 + y^2 - 1", {-1, 1, -1, 1}, 1, 0, 0, 0, 4},
                    Case{"touches_from_outside", "x^2 + y^2 - 1", {1, 2, -1, 1}, 1, 0, 1, 0, 1},
                    Case{"touches_a_corner", "x + y", {0, 1, 0, 1}, 1, 0, 1, 0, 1},
                    Case{"through_corners", "x - y", {0, 1, 0, 1}, 1, 0, 0, 0, 2},
                    Case{"side_and_half_circle", "x*(x^2 + y^2 - 1)", {0, 2, -2, 2}, 1, 0, 0, 2, 4},
                    Case{"all_sides", "x*(x - 1)*y*(y - 1)", {0, 1, 0, 1}, 1, 0, 0, 4, 4},
                    Case{"axis_lines", "(2*x - 1)*(3*y - 1)", {0, 1, 0, 1}, 1, 0, 0, 1, 4},
                    Case{"three_lines", "x*y*(x + y)", {-1, 1, -1, 1}, 1, 0, 0, 1, 6},
                    Case{"node", "y^2 - x^2*(x + 1)", {-2, 2, -4, 4}, 1, 0, 0, 1, 2},
                    Case{"cusp", "y^2 - x^3", {-1, 1, -2, 2}, 1, 0, 0, 1, 2},
                    Case{"tacnode", "y*(y - x^2)", {-1, 1, -1, 2}, 1, 0, 0, 1, 4},
                    Case{"contact_of_order_four", "y*(y - x^4)", {-1, 1, -1, 2}, 1, 0, 0, 1, 4},
                    Case{"acnode", "y^2 + x^2*(1 - x)", {-1, 2, -4, 4}, 2, 1, 1, 1, 2},
                    Case{"irrational_acnodes", "(x^2 - 2)^2 + (y^2 - 3)^2", {-2, 2, -2, 2}, 4, 4, 4, 4, 0},
                    Case{"trifolium", "(x^2 + y^2)^2 - x^3 + 3*x*y^2", {-2, 2, -2, 2}, 1, 1, 0, 1, 0},
                    Case{"quadrifolium", "(x^2 + y^2)^3 - 4*x^2*y^2", {-2, 2, -2, 2}, 1, 1, 0, 1, 0},
                    Case{"node_on_a_side", "y^2 - x^2*(x + 1)", {0, 2, -4, 4}, 1, 0, 0, 1, 3},
                    Case{"cusp_in_a_corner", "y^2 - x^3", {0, 1, 0, 2}, 1, 0, 0, 1, 2},
                    Case{"irrational_triple_points", "(x^2 - 2)*(y^2 - 2)*(x - y)", {-2, 2, -2, 2}, 1, 0, 0, 4, 10},
                    Case{"flat_triple_point_in_a_corner",
                         "x^9 - x^7*y + 3*x^2*y^6 - y^3 + y^5 + y^4*x - 4*y^4*x^3",
                         {0, 1, 0, 1},
                         2,
                         0,
                         0,
                         1,
                         4},
                    Case{"none", "x^2 + y^2 + 1", {-2, 2, -2, 2}, 0, 0, 0, 0, 0},
                    Case{"nested", "(x^2 + y^2 - 1)*(x^2 + y^2 - 2)", {-2, 2, -2, 2}, 2, 2, 0, 0, 0},
                    Case{"close_circles", "(x^2 + y^2 - 1)*(x^2 + y^2 - 1 - 1/1000)", {-2, 2, -2, 2}, 2, 2, 0, 0, 0},
                    Case{"tiny_oval", "1000000*(x^2 + y^2) - 1", {-2, 2, -2, 2}, 1, 1, 0, 0, 0}),
    [](const auto& tested) { return tested.param.name; });

TEST(mesh_curve, counts_the_pieces_of_known_curves)
{
  for (const auto& known : test::reference_curves(CORRAL_TEST_DATA)) {
    const auto mesh = mesh_curve(known.f, known.box, {Rational(1, 20)});
    EXPECT_TRUE(mesh.is_certified()) << known.name;
    EXPECT_EQ(mesh.components.size(), known.components) << known.name;
    EXPECT_EQ(mesh.closed_components(), known.closed) << known.name;
    EXPECT_EQ(mesh.isolated_points(), known.isolated) << known.name;
    EXPECT_EQ(test::find_loose_end(mesh), "") << known.name;
  }
}

TEST(mesh_curve, counts_do_not_depend_on_the_coordinates)
{
  const std::vector<std::string> texts{"(x^2 + y^2)^2 - 2*(x^2 - y^2)", "y^2 - x^3 + x", "(x^2 - 2)*(y^2 - 3) - 1/7",
                                       "(x - y^2)*(x^2 + y^2 - 1)"};
  for (const auto& text : texts) {
    const auto f = curve(text);
    const auto counts = [&](const Polynomial<Rational, 2>& g) {
      const auto mesh = mesh_curve(g, box(-4, 4, -4, 4), {Rational(1, 10)});
      EXPECT_TRUE(mesh.is_certified());
      return std::array{mesh.components.size(), mesh.closed_components(), mesh.isolated_points(),
                        mesh.singular_points(), mesh.boundary_points()};
    };
    const auto own = counts(f);
    std::vector<Polynomial<Rational, 2>::Term> swapped;
    std::vector<Polynomial<Rational, 2>::Term> mirrored;
    for (const auto& term : f.terms()) {
      swapped.push_back({{term.exponents[1], term.exponents[0]}, term.coefficient});
      mirrored.push_back({term.exponents, Rational(term.exponents[0] % 2 == 0 ? term.coefficient : -term.coefficient)});
    }
    EXPECT_EQ(counts(collect<Rational, 2>(swapped)), own) << text;
    EXPECT_EQ(counts(collect<Rational, 2>(mirrored)), own) << text;
  }
}

TEST(mesh_curve, keeps_the_tolerance)
{
  const auto f = curve("(x^2 + y^2)^2 - 2*(x^2 - y^2)");
  for (const Rational& tolerance : {Rational(1, 2), Rational(1, 30), Rational(1, 500)}) {
    const auto mesh = mesh_curve(f, box(-2, 2, -1, 1), {tolerance});
    EXPECT_EQ(test::find_stray(mesh, f, tolerance), "");
  }
}

TEST(mesh_curve, says_what_is_uncertain)
{
  const auto mesh =
      mesh_curve(curve("(x^2 + y^2)^2 - 2*(x^2 - y^2)"), box(-2, 2, -2, 2), Rational(1, 100), {.cell_budget = 10});
  EXPECT_FALSE(mesh.is_certified());
  EXPECT_FALSE(mesh.uncertified.front().reason.empty());
}

// The part that is certified when it is stopped is one of the whole mesh.
TEST(mesh_curve, keeps_what_is_certified_when_stopped)
{
  const auto f =
      curve("((x - 1/3)^2 + y^2)^2 - 2*((x - 1/3)^2 - y^2)*(x^3 - 2)"); // a singular point that takes algebra
  const auto whole_box = box(-2, 2, -2, 2);
  const Rational tolerance(1, 1000);
  const test::Stopping_run never(~std::uint64_t{0});
  const auto whole = mesh_curve(f, whole_box, tolerance, never.options);
  EXPECT_TRUE(whole.is_certified());
  ASSERT_GT(*never.reports, 4U);
  for (std::uint64_t report = 1; report <= *never.reports; ++report) {
    const auto mesh = mesh_curve(f, whole_box, tolerance, test::stopping_at(report));
    EXPECT_FALSE(mesh.is_certified());
    for (const auto& region : mesh.uncertified) EXPECT_EQ(region.reason, "stopped on request");
    for (const auto& vertex : whole.vertices) { // each is in the mesh or in a part that is not certified
      const auto is_same = [&](const Curve_vertex& other) { return other.point == vertex.point; };
      const auto may_hold = [&](const Uncertified_region& region) {
        return contains(region.box[0], vertex.point[0]) && contains(region.box[1], vertex.point[1]);
      };
      EXPECT_TRUE(std::any_of(mesh.vertices.begin(), mesh.vertices.end(), is_same)
                  || std::any_of(mesh.uncertified.begin(), mesh.uncertified.end(), may_hold));
    }
  }
}

TEST(mesh_curve, leaves_branches_closer_than_doubles_uncertain)
{
  const auto close = curve("(x^2 + y^2 - 1)*(x^2 + y^2 - 1 - 1/1000000000000000000000)");
  Run_options run;
  run.cell_budget = 20000;
  const auto mesh = mesh_curve(close, box(-2, 2, -2, 2), Rational(1, 10), run);
  EXPECT_FALSE(mesh.is_certified());
  const auto whole = mesh_curve(curve("(x^2 + y^2 - 1)*(x - 7)"), box(-2, 2, -2, 2), Rational(1, 10), run);
  EXPECT_TRUE(whole.is_certified());
}

/// The parents of the components, from left to right, as numbers in that order; -1 for none.
std::vector<int> parents(const Curve_mesh& mesh)
{
  std::vector<std::size_t> order(mesh.components.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto left = [&](std::size_t component) {
    std::optional<Rational> least;
    for (const auto& vertex : mesh.vertices)
      if (vertex.component == component && (!least || vertex.point[0] < *least)) least = vertex.point[0];
    return *least;
  };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return left(a) < left(b); });
  std::vector<int> result;
  for (const std::size_t component : order) {
    const auto parent = mesh.components[component].parent;
    result.push_back(parent ? static_cast<int>(std::find(order.begin(), order.end(), *parent) - order.begin()) : -1);
  }
  return result;
}

TEST(mesh_curve, tells_what_lies_inside_what)
{
  const auto nested = [](const char* text, int side) {
    const auto mesh = mesh_curve(curve(text), box(-side, side, -side, side), {Rational(1, 20)});
    EXPECT_TRUE(mesh.is_certified()) << text;
    return parents(mesh);
  };
  EXPECT_EQ(nested("(x^2+y^2-1)*(x^2+y^2-4)*(x^2+y^2-9)", 4), (std::vector{-1, 0, 1}));
  EXPECT_EQ(nested("((x+2)^2+y^2-1)*((x-2)^2+y^2-1)*(x^2+y^2-16)", 5), (std::vector{-1, 0, 0}));
  EXPECT_EQ(nested("((x+1)^2+y^2-4)*((x-1)^2+y^2-4)*(16*x^2+16*y^2-1)*((x-2)^2+y^2)", 5), (std::vector{-1, 0, 0}));
  EXPECT_EQ(nested("(y^2 - x^2*(x + 1))*((2*x+1)^2+4*y^2-1/100)*((x-3)^2+(y-7)^2-1/100)", 8),
            (std::vector{-1, 0, -1})); // in the loop of a curve that leaves the box, and beside it
  EXPECT_EQ(nested("x^2+y^2-1", 2), (std::vector{-1}));
  EXPECT_EQ(nested("(x^4+y^4-16)*(x^2+y^2)*((x-1)^2+(y-1/2)^2-1/16)*((x-1)^2+(y-1/2)^2)", 3),
            (std::vector{-1, 0, 0, 2}));
}

TEST(mesh_curve, refuses_what_it_cannot_mesh)
{
  const auto f = curve("x^2 + y^2 - 1");
  EXPECT_THROW((void)mesh_curve(Polynomial<Rational, 2>(), box(0, 1, 0, 1)), Invalid_input);
  EXPECT_THROW((void)mesh_curve(f, box(0, 0, 0, 1)), Invalid_input);
  EXPECT_THROW((void)mesh_curve(f, box(0, 1, 0, 1), {Rational(0)}), Invalid_input);
}

// The checks themselves can fail.
TEST(mesh_checks, notice_planted_faults)
{
  const auto f = curve("(x^2 + y^2 - 1)*(x^2 + y^2 - 4)");
  const Rational tolerance(1, 10);
  const auto good = mesh_curve(f, box(-3, 3, -3, 3), tolerance);
  ASSERT_EQ(test::find_crossing(good), "");
  ASSERT_EQ(test::find_stray(good, f, tolerance), "");

  auto swapped = good; // two branches exchanged
  const auto start = [&](const auto& edge) -> const Curve_vertex& { return good.vertices[edge[0]]; };
  const auto far = std::find_if(swapped.edges.begin(), swapped.edges.end(), [&](const auto& edge) {
    return start(edge).component != start(good.edges[0]).component
           && start(edge).point[0] * start(good.edges[0]).point[0] < -1;
  });
  ASSERT_NE(far, swapped.edges.end());
  std::swap(swapped.edges[0][1], (*far)[1]);
  EXPECT_TRUE(!test::find_crossing(swapped).empty() || !test::find_stray(swapped, f, tolerance).empty());

  auto moved = good; // a vertex off the curve
  for (auto& side : moved.vertices[0].box) side += Rational_interval(Rational(1, 5));
  EXPECT_NE(test::find_stray(moved, f, tolerance), "");
}

} // namespace
} // namespace corral
