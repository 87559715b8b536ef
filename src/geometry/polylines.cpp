// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/geometry/polylines.h>

#include <utility>

namespace corral {

std::vector<std::vector<std::size_t>> polylines(const Curve_mesh& mesh)
{
  std::vector<std::vector<std::size_t>> edges_at(mesh.vertices.size());
  for (std::size_t e = 0; e < mesh.edges.size(); ++e)
    for (const std::size_t v : mesh.edges[e]) edges_at[v].push_back(e);
  std::vector<bool> used(mesh.edges.size());
  std::vector<std::vector<std::size_t>> lines;
  const auto follow = [&](std::size_t vertex, std::size_t edge) {
    std::vector<std::size_t> line{vertex};
    for (;;) {
      used[edge] = true;
      vertex = mesh.edges[edge][mesh.edges[edge][0] == vertex ? 1 : 0];
      line.push_back(vertex);
      if (edges_at[vertex].size() != 2) break;
      edge = edges_at[vertex][edges_at[vertex][0] == edge ? 1 : 0];
      if (used[edge]) break;
    }
    lines.push_back(std::move(line));
  };
  for (const bool ends_only : {true, false})
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
      if (ends_only && edges_at[v].empty()) lines.push_back({v});
      if (ends_only && edges_at[v].size() == 2) continue;
      for (const std::size_t e : edges_at[v])
        if (!used[e]) follow(v, e);
    }
  return lines;
}

} // namespace corral
