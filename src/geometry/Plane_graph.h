// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_GEOMETRY_PLANE_GRAPH_H
#define CORRAL_SRC_GEOMETRY_PLANE_GRAPH_H

#include "Side_zeros.h"

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace corral::geometry {

/// The vertices on the border of a rectangle, one list a side, in increasing order; a corner is in two lists.
struct Outline
{
  std::array<std::array<std::vector<std::size_t>, 2>, 2> side{}; ///< [normal axis][lower or upper]
};

/// \brief The pieces of a plane graph, put together from rectangles that share sides.
class Plane_graph
{
public:
  struct Node
  {
    std::array<Range, 2> box; ///< in the unit box
    int singular = -1;        ///< an index of the caller's, or -1
  };

  std::size_t add(const Node& node)
  {
    nodes_.push_back(node);
    parent_.push_back(parent_.size());
    return nodes_.size() - 1;
  }
  void connect(std::size_t a, std::size_t b) { edges_.emplace_back(a, b); }
  /// The names of one vertex are the same from now on.
  void unite(std::size_t a, std::size_t b);
  [[nodiscard]] std::size_t find(std::size_t node) const;

  /// The outline of two rectangles that share a side, across `axis`. \throw std::logic_error if what they say of that
  /// side differs.
  [[nodiscard]] Outline join(std::size_t axis, Outline lower, Outline upper);

  [[nodiscard]] const Node& node(std::size_t index) const { return nodes_[index]; }
  [[nodiscard]] Node& node(std::size_t index) { return nodes_[index]; }
  [[nodiscard]] std::size_t size() const { return nodes_.size(); }
  [[nodiscard]] const std::vector<std::pair<std::size_t, std::size_t>>& edges() const { return edges_; }

  /// Forgets what was added since the graph had so many nodes and edges. \pre None of them was united.
  void roll_back(std::size_t nodes, std::size_t edges);

private:
  std::vector<Node> nodes_;
  mutable std::vector<std::size_t> parent_;
  std::vector<std::pair<std::size_t, std::size_t>> edges_;
};

} // namespace corral::geometry

#endif
