// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_GEOMETRY_BOOST_GRAPH_H
#define CORRAL_GEOMETRY_BOOST_GRAPH_H

#include <corral/geometry/Curve_mesh.h>

#include <boost/graph/adjacency_iterator.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/iterator/counting_iterator.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <utility>
#include <vector>

/// \file
/// The graph of a mesh for the algorithms of Boost.Graph. Costs nothing unless it is included.
namespace corral {

/// \brief The edges of a mesh as an undirected graph; vertices are the indices of the mesh's.
///
/// Model of Boost.Graph's `IncidenceGraph`, `AdjacencyGraph`, `VertexListGraph` and `EdgeListGraph`, with an interior
/// `vertex_index`. A value of its own: the mesh may go.
class Curve_graph
{
public:
  /// Edge `index` of the mesh, as seen from `source`.
  struct edge_descriptor
  {
    std::size_t source = 0;
    std::size_t target = 0;
    std::size_t index = 0;
    friend bool operator==(const edge_descriptor& a, const edge_descriptor& b) { return a.index == b.index; }
  };
  struct traversal_category : boost::incidence_graph_tag,
                              boost::adjacency_graph_tag,
                              boost::vertex_list_graph_tag,
                              boost::edge_list_graph_tag
  {
  };
  using vertex_descriptor = std::size_t;
  using directed_category = boost::undirected_tag;
  using edge_parallel_category = boost::allow_parallel_edge_tag;
  using vertices_size_type = std::size_t;
  using edges_size_type = std::size_t;
  using degree_size_type = std::size_t;
  using vertex_iterator = boost::counting_iterator<std::size_t>;
  using edge_iterator = std::vector<edge_descriptor>::const_iterator;
  using out_edge_iterator = edge_iterator;
  using adjacency_iterator =
      boost::adjacency_iterator_generator<Curve_graph, vertex_descriptor, out_edge_iterator>::type;

  static vertex_descriptor null_vertex() { return static_cast<std::size_t>(-1); }

  explicit Curve_graph(const Curve_mesh& mesh) : first_(mesh.vertices.size() + 1), out_(2 * mesh.edges.size())
  {
    for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
      const auto [a, b] = mesh.edges[e];
      edges_.push_back({a, b, e});
      ++first_[a];
      ++first_[b];
    }
    for (std::size_t v = 0; v + 1 < first_.size(); ++v) first_[v + 1] += first_[v];
    for (const auto& edge : edges_) {
      out_[--first_[edge.source]] = edge;
      out_[--first_[edge.target]] = {edge.target, edge.source, edge.index};
    }
  }

  friend std::size_t num_vertices(const Curve_graph& g) { return g.first_.size() - 1; }
  friend std::size_t num_edges(const Curve_graph& g) { return g.edges_.size(); }
  friend std::pair<vertex_iterator, vertex_iterator> vertices(const Curve_graph& g)
  {
    return {vertex_iterator(0), vertex_iterator(num_vertices(g))};
  }
  friend std::pair<edge_iterator, edge_iterator> edges(const Curve_graph& g)
  {
    return {g.edges_.begin(), g.edges_.end()};
  }
  friend std::size_t source(const edge_descriptor& e, const Curve_graph&) { return e.source; }
  friend std::size_t target(const edge_descriptor& e, const Curve_graph&) { return e.target; }
  friend std::pair<out_edge_iterator, out_edge_iterator> out_edges(std::size_t v, const Curve_graph& g)
  {
    const auto at = [&](std::size_t place) { return g.out_.begin() + static_cast<std::ptrdiff_t>(place); };
    return {at(g.first_[v]), at(g.first_[v + 1])};
  }
  friend std::size_t out_degree(std::size_t v, const Curve_graph& g) { return g.first_[v + 1] - g.first_[v]; }
  friend std::pair<adjacency_iterator, adjacency_iterator> adjacent_vertices(std::size_t v, const Curve_graph& g)
  {
    const auto [begin, end] = out_edges(v, g);
    return {adjacency_iterator(begin, &g), adjacency_iterator(end, &g)};
  }
  friend boost::typed_identity_property_map<std::size_t> get(boost::vertex_index_t, const Curve_graph&) { return {}; }
  friend std::size_t get(boost::vertex_index_t, const Curve_graph&, std::size_t v) { return v; }

private:
  std::vector<edge_descriptor> edges_;
  std::vector<std::size_t> first_; ///< of a vertex in `out_`
  std::vector<edge_descriptor> out_;
};

} // namespace corral

namespace boost {

template <>
struct property_map<corral::Curve_graph, vertex_index_t>
{
  using type = typed_identity_property_map<std::size_t>;
  using const_type = type;
};

} // namespace boost

#endif
