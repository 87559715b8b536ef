// SPDX-License-Identifier: LGPL-3.0-or-later
#include "mesh_checks.h"

#include <corral/geometry/boost_graph.h>
#include <corral/geometry/cgal_arrangement.h>

#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <boost/graph/connected_components.hpp>
#include <boost/graph/graph_concepts.hpp>

#include <algorithm>
#include <vector>

namespace corral {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Arrangement = CGAL::Arrangement_2<CGAL::Arr_segment_traits_2<Kernel>>;

Curve_mesh mesh_of(const char* text, int side)
{
  return mesh_curve(test::curve(text), test::box(-side, side, -side, side), {Rational(1, 20)});
}

TEST(cgal_arrangement, has_the_faces_that_euler_counts)
{
  // circles that cross, one within, an isolated point
  const auto mesh = mesh_of("((x+1)^2+y^2-4)*((x-1)^2+y^2-4)*(16*x^2+16*y^2-1)*((x-2)^2+y^2)", 4);
  const auto arrangement = cgal_arrangement<Arrangement>(mesh);
  EXPECT_TRUE(arrangement.is_valid());
  EXPECT_EQ(arrangement.number_of_faces(), 5U);
  EXPECT_EQ(arrangement.number_of_isolated_vertices(), 1U);
  EXPECT_EQ(static_cast<long>(arrangement.number_of_faces()),
            1 + static_cast<long>(mesh.components.size()) - mesh.euler_characteristic());
}

TEST(cgal_polylines, keep_the_points)
{
  const auto mesh = mesh_of("y^2 - x^2*(x + 1)", 2);
  const auto lines = polylines(mesh);
  const auto points = cgal_polylines<CGAL::Simple_cartesian<Rational>>(mesh);
  ASSERT_EQ(points.size(), lines.size());
  for (std::size_t k = 0; k < lines.size(); ++k) {
    ASSERT_EQ(points[k].size(), lines[k].size());
    for (std::size_t i = 0; i < lines[k].size(); ++i) {
      EXPECT_EQ(points[k][i].x(), mesh.vertices[lines[k][i]].point[0]);
      EXPECT_EQ(points[k][i].y(), mesh.vertices[lines[k][i]].point[1]);
    }
  }
}

BOOST_CONCEPT_ASSERT((boost::IncidenceGraphConcept<Curve_graph>));
BOOST_CONCEPT_ASSERT((boost::AdjacencyGraphConcept<Curve_graph>));
BOOST_CONCEPT_ASSERT((boost::VertexListGraphConcept<Curve_graph>));
BOOST_CONCEPT_ASSERT((boost::EdgeListGraphConcept<Curve_graph>));

TEST(Curve_graph, has_the_components_of_the_mesh)
{
  const auto mesh = mesh_of("(x^2+y^2-1)*(x^2+y^2-4)*(y-x^2)*((x-3)^2+(y-3)^2)", 4);
  const Curve_graph graph(mesh);
  std::vector<int> component(num_vertices(graph));
  const int count = boost::connected_components(graph, component.data());
  EXPECT_EQ(static_cast<std::size_t>(count), mesh.components.size());
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) EXPECT_EQ(out_degree(v, graph), mesh.vertices[v].branches);
  for (const auto& [a, b] : mesh.edges) EXPECT_EQ(component[a], component[b]);
  auto damaged = mesh; // control: a line less, a component more
  std::erase_if(damaged.edges, [&](const auto& edge) { return mesh.vertices[edge[0]].component == 0; });
  EXPECT_NE(boost::connected_components(Curve_graph(damaged), component.data()), count);
}

} // namespace
} // namespace corral
