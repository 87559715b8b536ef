// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_LOCALIZATION_CONNECTED_COMPONENTS_H
#define CORRAL_LOCALIZATION_CONNECTED_COMPONENTS_H

#include <corral/localization/Raster.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace corral {

/// \brief The connected components of the closed cells that are not empty: cells with a common point are together.
///
/// Each is sorted, and they are sorted by their first cells. A component of the zero set lies in one of them.
/// \par Complexity  n log n and linear memory for n cells, those included that were not visited.
template <std::size_t D>
[[nodiscard]] std::vector<std::vector<Cell<D>>> connected_components(const Raster<D>& raster)
{
  std::vector<Cell<D>> cells;
  raster.for_each_sorted([&](const Cell<D>& cell, Verdict) { cells.push_back(cell); });
  std::vector<std::size_t> parent(cells.size()); // a forest in which no parent comes after its child
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t k) {
    while (parent[k] != k) k = parent[k] = parent[parent[k]];
    return k;
  };
  for (std::size_t k = 0; k < cells.size(); ++k)
    for (const auto& neighbour : raster.grid().neighbours(cells[k])) {
      if (!(neighbour < cells[k])) break; // they are sorted, and each pair is seen once
      const auto end = cells.begin() + static_cast<std::ptrdiff_t>(k);
      const auto found = std::lower_bound(cells.begin(), end, neighbour);
      if (found == end || *found != neighbour) continue;
      const std::size_t other = root(static_cast<std::size_t>(found - cells.begin()));
      const std::size_t own = root(k);
      parent[std::max(other, own)] = std::min(other, own);
    }
  std::vector<std::size_t> number(cells.size()); // of the component of a root
  std::vector<std::vector<Cell<D>>> components;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const std::size_t own = root(k);
    if (own == k) {
      number[k] = components.size();
      components.emplace_back();
    }
    components[number[own]].push_back(cells[k]);
  }
  return components;
}

} // namespace corral

#endif
