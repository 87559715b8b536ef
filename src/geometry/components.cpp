// SPDX-License-Identifier: LGPL-3.0-or-later
#include "components.h"

#include <algorithm>
#include <numeric>

namespace corral {

namespace geometry {

namespace {

std::size_t root(std::vector<std::size_t>& parent, std::size_t vertex)
{
  while (parent[vertex] != vertex) vertex = parent[vertex] = parent[parent[vertex]];
  return vertex;
}

} // namespace

void find_components(Curve_mesh& mesh)
{
  std::vector<std::size_t> parent(mesh.vertices.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  for (auto& vertex : mesh.vertices) vertex.branches = 0;
  for (const auto& [a, b] : mesh.edges) {
    ++mesh.vertices[a].branches;
    ++mesh.vertices[b].branches;
    parent[root(parent, a)] = root(parent, b);
  }
  mesh.components.clear();
  std::vector<std::size_t> number(mesh.vertices.size());
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    if (root(parent, v) == v) {
      number[v] = mesh.components.size();
      mesh.components.push_back({});
    }
  for (std::size_t v = mesh.vertices.size(); v-- > 0;) {
    auto& vertex = mesh.vertices[v];
    vertex.component = number[root(parent, v)];
    auto& component = mesh.components[vertex.component];
    component.first_vertex = v;
    ++component.vertices;
    component.is_closed = component.is_closed && !vertex.is_on_boundary;
  }
  for (const auto& edge : mesh.edges) ++mesh.components[mesh.vertices[edge[0]].component].edges;
}

} // namespace geometry

std::size_t Curve_mesh::closed_components() const
{
  return static_cast<std::size_t>(
      std::count_if(components.begin(), components.end(), [](const auto& c) { return c.is_closed; }));
}

std::size_t Curve_mesh::isolated_points() const
{
  return static_cast<std::size_t>(
      std::count_if(components.begin(), components.end(), [](const auto& c) { return c.is_point(); }));
}

std::size_t Curve_mesh::singular_points() const
{
  return static_cast<std::size_t>(
      std::count_if(vertices.begin(), vertices.end(), [](const auto& v) { return v.is_singular; }));
}

std::size_t Curve_mesh::boundary_points() const
{
  return static_cast<std::size_t>(
      std::count_if(vertices.begin(), vertices.end(), [](const auto& v) { return v.is_on_boundary; }));
}

long Curve_mesh::euler_characteristic() const
{
  return static_cast<long>(vertices.size()) - static_cast<long>(edges.size());
}

} // namespace corral
