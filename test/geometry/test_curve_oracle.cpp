// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cgal_topology.h"
#include "mesh_checks.h"
#include "random_curves.h"
#include "rounds.h"

#include "geometry/components.h"

#include <corral/polynomial/print.h>

#include <algorithm>
#include <array>
#include <vector>

namespace corral {
namespace {

using test::Plane_topology;

Plane_topology topology(const Curve_mesh& mesh)
{
  return {mesh.components.size(), mesh.closed_components(), mesh.isolated_points(), mesh.boundary_points(),
          mesh.euler_characteristic()};
}

/// What is wrong with a mesh of a curve in a box that holds all of its topology; "" if nothing is.
std::string complaint(const Curve_mesh& mesh, const Plane_topology& expected)
{
  if (!mesh.is_certified()) return "not certified: " + mesh.uncertified.front().reason;
  const auto found = topology(mesh);
  if (found != expected) return to_string(found) + "; CGAL says " + to_string(expected);
  return test::find_loose_end(mesh);
}

Curve_mesh whole_mesh(const Polynomial<Integer, 2>& f)
{
  const Rational reach(test::cgal_reach(f));
  return mesh_curve(transform<Rational>(f, [](const Integer& c) { return Rational(c); }),
                    test::box(-reach, reach, -reach, reach), {reach / 20});
}

TEST(random_curves, have_the_topology_that_cgal_finds)
{
  test::Random_curves curves(2026);
  int singular = 0;
  int isolated = 0;
  const int rounds = test::rounds(600);
  for (int round = 0; round < rounds; ++round) {
    const auto f = curves.next();
    const auto mesh = whole_mesh(f);
    EXPECT_EQ(complaint(mesh, test::cgal_topology(f)), "") << "round " << round << ", " << to_string(f, {"x", "y"});
    singular += mesh.singular_points() > 0 ? 1 : 0;
    isolated += mesh.isolated_points() > 0 ? 1 : 0;
  }
  EXPECT_GT(singular, rounds / 4);
  EXPECT_GT(isolated, rounds / 40);
}

/// f at an affine map of the plane: x to a x + b y, y to c x + d y.
Polynomial<Integer, 2> mapped(const Polynomial<Integer, 2>& f, const std::array<Rational, 4>& m)
{
  const auto linear = [](const Rational& a, const Rational& b) {
    return collect<Rational, 2>({{{1, 0}, a}, {{0, 1}, b}});
  };
  Polynomial<Rational, 2> sum;
  for (const auto& term : f.terms())
    sum = sum
          + Rational(term.coefficient) * power(linear(m[0], m[1]), term.exponents[0])
                * power(linear(m[2], m[3]), term.exponents[1]);
  return integer_primitive(sum);
}

TEST(random_curves, do_not_depend_on_the_coordinates)
{
  test::Random_curves curves(7);
  for (int round = 0; round < test::rounds(60); ++round) {
    const auto f = curves.next();
    const auto own = whole_mesh(f);
    const auto expect_same = [&](const char* map, const std::array<Rational, 4>& m) {
      const auto mesh = whole_mesh(mapped(f, m));
      EXPECT_TRUE(mesh.is_certified());
      EXPECT_EQ(to_string(topology(mesh)), to_string(topology(own))) << map << ", " << to_string(f, {"x", "y"});
      EXPECT_EQ(mesh.singular_points(), own.singular_points()) << map << ", " << to_string(f, {"x", "y"});
    };
    expect_same("exchanged", {0, 1, 1, 0});
    expect_same("mirrored", {-1, 0, 0, 1});
    expect_same("sheared", {1, Rational(1, 3), 0, 1});
  }
}

/// The components of two meshes that share a side at x = cut, put together; -1 if they disagree about it.
long glued_components(const Curve_mesh& left, const Curve_mesh& right, const Rational& cut)
{
  const auto on_cut = [&](const Curve_mesh& mesh) {
    std::vector<const Curve_vertex*> result;
    for (const auto& vertex : mesh.vertices)
      if (vertex.point[0] == cut) result.push_back(&vertex);
    std::sort(result.begin(), result.end(), [](auto* a, auto* b) { return a->point[1] < b->point[1]; });
    return result;
  };
  const auto from_left = on_cut(left);
  const auto from_right = on_cut(right);
  if (from_left.size() != from_right.size()) return -1;
  Curve_mesh both; // a vertex for each component, an edge for each point that two share
  both.vertices.resize(left.components.size() + right.components.size());
  for (std::size_t k = 0; k < from_left.size(); ++k)
    both.edges.push_back({from_left[k]->component, left.components.size() + from_right[k]->component});
  geometry::find_components(both);
  return static_cast<long>(both.components.size());
}

TEST(random_curves, are_the_same_in_two_halves)
{
  test::Random_curves curves(3);
  for (int round = 0; round < test::rounds(60); ++round) {
    const auto f = curves.next();
    const auto g = transform<Rational>(f, [](const Integer& c) { return Rational(c); });
    const Rational tolerance(1, 4);
    for (const Rational& cut : {Rational(0), Rational(1, 3)}) {
      const auto whole = mesh_curve(g, test::box(-5, 5, -4, 4), {tolerance});
      const auto left = mesh_curve(g, test::box(-5, cut, -4, 4), {tolerance});
      const auto right = mesh_curve(g, test::box(cut, 5, -4, 4), {tolerance});
      EXPECT_TRUE(whole.is_certified() && left.is_certified() && right.is_certified());
      EXPECT_EQ(glued_components(left, right, cut), static_cast<long>(whole.components.size()))
          << "cut at " << cut << ", " << to_string(f, {"x", "y"});
    }
  }
}

// What the comparison must notice.
TEST(complaint, is_made_of_planted_faults)
{
  const auto f = integer_primitive(test::curve("(x^2 + y^2 - 1)*((x - 3)^2 + y^2 - 1)*(x^2 + (y - 3)^2)"));
  const auto expected = test::cgal_topology(f);
  EXPECT_EQ(expected, (Plane_topology{3, 3, 1, 0, 1}));
  const auto good = whole_mesh(f);
  ASSERT_EQ(complaint(good, expected), "");

  auto dropped = good; // a branch
  dropped.edges.pop_back();
  geometry::find_components(dropped);
  EXPECT_NE(complaint(dropped, expected), "");

  auto lost = good; // a component
  const auto point =
      std::find_if(lost.vertices.begin(), lost.vertices.end(), [](const Curve_vertex& v) { return v.branches == 0; });
  ASSERT_NE(point, lost.vertices.end());
  lost.components.erase(lost.components.begin() + static_cast<std::ptrdiff_t>(point->component));
  EXPECT_NE(complaint(lost, expected), "");

  auto swapped = good; // two branches
  const auto far = std::find_if(swapped.edges.begin(), swapped.edges.end(), [&](const auto& edge) {
    return good.vertices[edge[0]].component != good.vertices[good.edges[0][0]].component;
  });
  ASSERT_NE(far, swapped.edges.end());
  std::swap(swapped.edges[0][1], (*far)[1]);
  geometry::find_components(swapped);
  EXPECT_NE(complaint(swapped, expected), "");
}

} // namespace
} // namespace corral
