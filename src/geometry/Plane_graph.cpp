// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Plane_graph.h"

#include <stdexcept>

namespace corral::geometry {

void Plane_graph::unite(std::size_t a, std::size_t b)
{
  a = find(a);
  b = find(b);
  if (a == b) return;
  if (b < a) std::swap(a, b);
  parent_[b] = a;
  if (nodes_[a].singular < 0) nodes_[a].singular = nodes_[b].singular;
}

std::size_t Plane_graph::find(std::size_t node) const
{
  while (parent_[node] != node) node = parent_[node] = parent_[parent_[node]];
  return node;
}

Outline Plane_graph::join(std::size_t axis, Outline lower, Outline upper)
{
  const auto& below = lower.side[axis][1];
  const auto& above = upper.side[axis][0];
  if (below.size() != above.size()) throw std::logic_error("mesh_curve: two cells disagree on the zeros between them");
  for (std::size_t k = 0; k < below.size(); ++k) unite(below[k], above[k]);
  Outline result;
  result.side[axis][0] = std::move(lower.side[axis][0]);
  result.side[axis][1] = std::move(upper.side[axis][1]);
  for (const std::size_t end : {0U, 1U}) {
    auto& list = result.side[1 - axis][end] = std::move(lower.side[1 - axis][end]);
    const auto& more = upper.side[1 - axis][end];
    const bool shares_corner = !list.empty() && !more.empty() && find(list.back()) == find(more.front());
    list.insert(list.end(), more.begin() + (shares_corner ? 1 : 0), more.end());
  }
  return result;
}

void Plane_graph::roll_back(std::size_t nodes, std::size_t edges)
{
  nodes_.resize(nodes);
  parent_.resize(nodes);
  edges_.resize(edges);
}

} // namespace corral::geometry
