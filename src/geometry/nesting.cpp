// SPDX-License-Identifier: LGPL-3.0-or-later
#include "nesting.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace corral::geometry {

namespace {

constexpr std::size_t none = static_cast<std::size_t>(-1);

/// A mesh as half-edges: edge e runs from edges[e][0] as 2 e and back as 2 e + 1.
class Faces
{
public:
  explicit Faces(const Curve_mesh& mesh) : mesh_(mesh), around_(mesh.vertices.size()), is_outer_(2 * mesh.edges.size())
  {
    near_.reserve(mesh.vertices.size());
    for (const auto& vertex : mesh.vertices) near_.push_back({vertex.point[0].get_d(), vertex.point[1].get_d()});
    for (std::size_t h = 0; h < 2 * mesh.edges.size(); ++h) around_[start(h)].push_back(h);
    place_.resize(2 * mesh.edges.size());
    for (auto& list : around_) {
      if (list.size() > 2) sort(list); // of two, each is the next
      for (std::size_t k = 0; k < list.size(); ++k) place_[list[k]] = k;
    }
  }

  /// The vertex of each component that is leftmost, and of these lowest.
  [[nodiscard]] std::vector<std::size_t> leftmost() const
  {
    std::vector<std::size_t> result(mesh_.components.size(), none);
    for (std::size_t v = 0; v < mesh_.vertices.size(); ++v) {
      std::size_t& best = result[mesh_.vertices[v].component];
      if (best == none || point(v) < point(best)) best = v;
    }
    return result;
  }

  /// Marks the half-edges on whose left the unbounded face of their own component lies.
  void mark_outer(const std::vector<std::size_t>& leftmost)
  {
    for (const std::size_t v : leftmost) {
      if (around_[v].empty()) continue;
      if (around_[v].size() == 2) sort(around_[v]);
      // Edges around a leftmost vertex start from straight down, so the face before the first one is outside.
      const std::size_t first = around_[v].back();
      std::size_t h = first;
      do {
        is_outer_[h] = true;
        h = next(h);
      } while (h != first);
    }
  }

  /// The half-edge that has on its left what lies left of v, in the closest edge of another component; none if there is
  /// no edge.
  [[nodiscard]] std::size_t left_of(std::size_t v) const
  {
    std::size_t best = none;
    Rational best_x;
    for (std::size_t e = 0; e < mesh_.edges.size(); ++e) {
      const auto [a, b] = mesh_.edges[e];
      if (mesh_.vertices[a].component == mesh_.vertices[v].component || is_above(a, v) == is_above(b, v)) continue;
      if (near_[a][0] > near_[v][0] && near_[b][0] > near_[v][0]) continue;
      const Rational x =
          point(a)[0] + (point(b)[0] - point(a)[0]) * (point(v)[1] - point(a)[1]) / (point(b)[1] - point(a)[1]);
      if (x >= point(v)[0] || (best != none && x <= best_x)) continue;
      best = is_above(b, v) ? 2 * e + 1 : 2 * e; // downwards, so that its left is towards v
      best_x = x;
    }
    return best;
  }

  [[nodiscard]] std::size_t component(std::size_t half_edge) const
  {
    return mesh_.vertices[start(half_edge)].component;
  }
  [[nodiscard]] bool is_outer(std::size_t half_edge) const { return is_outer_[half_edge]; }

private:
  [[nodiscard]] const Rational_point<2>& point(std::size_t v) const { return mesh_.vertices[v].point; }
  [[nodiscard]] std::size_t start(std::size_t h) const { return mesh_.edges[h / 2][h % 2]; }
  [[nodiscard]] std::size_t end(std::size_t h) const { return start(h ^ 1U); }

  /// Whether a lies above the horizontal line a little above v.
  [[nodiscard]] bool is_above(std::size_t a, std::size_t v) const
  {
    if (near_[a][1] != near_[v][1]) return near_[a][1] > near_[v][1]; // rounding keeps the order
    return point(a)[1] > point(v)[1];
  }
  /// The half-edge after h with the same face on its left.
  [[nodiscard]] std::size_t next(std::size_t h) const
  {
    const auto& list = around_[end(h)];
    const std::size_t place = place_[h ^ 1U];
    return list[(place + list.size() - 1) % list.size()];
  }
  /// Counterclockwise, from straight down.
  void sort(std::vector<std::size_t>& list) const
  {
    const auto direction = [&](std::size_t h) {
      return Rational_point<2>{point(end(h))[0] - point(start(h))[0], point(end(h))[1] - point(start(h))[1]};
    };
    const auto is_left = [](const Rational_point<2>& d) { return d[0] < 0 || (d[0] == 0 && d[1] > 0); };
    std::sort(list.begin(), list.end(), [&](std::size_t a, std::size_t b) {
      const auto d = direction(a);
      const auto e = direction(b);
      if (is_left(d) != is_left(e)) return is_left(e);
      return d[0] * e[1] - d[1] * e[0] > 0;
    });
  }

  const Curve_mesh& mesh_;
  std::vector<std::array<double, 2>> near_;
  std::vector<std::vector<std::size_t>> around_; ///< half-edges from each vertex, counterclockwise
  std::vector<std::size_t> place_;
  std::vector<bool> is_outer_;
};

} // namespace

void find_nesting(Curve_mesh& mesh)
{
  for (auto& component : mesh.components) component.parent.reset();
  if (mesh.components.size() < 2) return;
  Faces faces(mesh);
  const auto leftmost = faces.leftmost();
  faces.mark_outer(leftmost);
  // From left to right: what a component is compared with starts further left, and has its parent already.
  std::vector<std::size_t> order(mesh.components.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return mesh.vertices[leftmost[a]].point[0] < mesh.vertices[leftmost[b]].point[0];
  });
  for (const std::size_t component : order) {
    const std::size_t half_edge = faces.left_of(leftmost[component]);
    if (half_edge == none) continue;
    const std::size_t neighbour = faces.component(half_edge);
    mesh.components[component].parent =
        faces.is_outer(half_edge) ? mesh.components[neighbour].parent : std::optional(neighbour);
  }
}

} // namespace corral::geometry
