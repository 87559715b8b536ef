// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_LOCALIZATION_FAST_COMMON_NODES_H
#define CORRAL_SRC_LOCALIZATION_FAST_COMMON_NODES_H

#include "Fast_plan.h"

#include <corral/localization/Cell_block.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

namespace corral::fast {

/// What one polynomial of a system says of a node that it does not drop.
template <std::size_t D>
struct Open_node
{
  enum Kind { smooth, rough, hidden };
  Cell<D> corner;
  Kind kind;
  Seed<D> seed; ///< empty if the node is hidden
};

/// By polynomial the nodes of one level, sorted by corner.
template <std::size_t D>
using Open_nodes = std::vector<std::vector<Open_node<D>>>;

/// The nodes that a worker has left, sorted by corner.
template <std::size_t D>
[[nodiscard]] std::vector<Open_node<D>> open_nodes(Harvest<D>&& harvest)
{
  std::vector<Open_node<D>> nodes;
  nodes.reserve(harvest.seeds.size() + harvest.rough.size() + harvest.hidden.size());
  const auto add = [&](std::vector<Seed<D>>& seeds, typename Open_node<D>::Kind kind) {
    for (auto& seed : seeds) {
      const auto corner = seed.corner;
      nodes.push_back({corner, kind, std::move(seed)});
    }
  };
  add(harvest.seeds, Open_node<D>::smooth);
  add(harvest.rough, Open_node<D>::rough);
  for (const auto& node : harvest.hidden) nodes.push_back({node.corner, Open_node<D>::hidden, {}});
  std::sort(nodes.begin(), nodes.end(), [](const auto& a, const auto& b) { return a.corner < b.corner; });
  return nodes;
}

/// Drops the nodes that are not in all lists.
template <std::size_t D>
void keep_common(Open_nodes<D>& nodes)
{
  std::vector<std::size_t> at(nodes.size(), 0);
  std::size_t kept = 0;
  for (; at[0] < nodes[0].size(); ++at[0]) {
    const auto corner = nodes[0][at[0]].corner;
    bool in_all = true;
    for (std::size_t p = 1; in_all && p < nodes.size(); ++p) {
      while (at[p] < nodes[p].size() && nodes[p][at[p]].corner < corner) ++at[p];
      in_all = at[p] < nodes[p].size() && nodes[p][at[p]].corner == corner;
    }
    if (!in_all) continue;
    for (std::size_t p = 0; p < nodes.size(); ++p)
      if (at[p] != kept) nodes[p][kept] = std::move(nodes[p][at[p]]);
    ++kept;
  }
  for (auto& list : nodes) list.resize(kept);
}

/// Drops the nodes that are hidden from a polynomial and returns them. \pre The lists have the same nodes.
template <std::size_t D>
[[nodiscard]] std::vector<Hidden_node<D>> take_hidden(Open_nodes<D>& nodes, unsigned level)
{
  std::vector<Hidden_node<D>> taken;
  std::size_t kept = 0;
  for (std::size_t n = 0; n < nodes[0].size(); ++n) {
    if (std::any_of(nodes.begin(), nodes.end(), [&](const auto& l) { return l[n].kind == Open_node<D>::hidden; })) {
      taken.push_back({level, nodes[0][n].corner});
      continue;
    }
    for (auto& list : nodes)
      if (n != kept) list[kept] = std::move(list[n]);
    ++kept;
  }
  for (auto& list : nodes) list.resize(kept);
  return taken;
}

/// \brief The cells that are plotted in both; no verdict carries over but `empty`. \pre Both are sorted by index.
template <std::size_t D>
[[nodiscard]] std::vector<Cell_block<D>> common_cells(const std::vector<Cell_block<D>>& a,
                                                      const std::vector<Cell_block<D>>& b)
{
  std::vector<Cell_block<D>> result;
  auto other = b.begin();
  for (const auto& block : a) {
    while (other != b.end() && other->index < block.index) ++other;
    if (other == b.end()) break;
    if (other->index == block.index && (other->plotted & block.plotted) != 0)
      result.push_back({block.index, other->plotted & block.plotted, 0});
  }
  return result;
}

} // namespace corral::fast

#endif
