// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_LOCALIZATION_FAST_GRID_PART_H
#define CORRAL_SRC_LOCALIZATION_FAST_GRID_PART_H

#include "Fast_plan.h"

#include <corral/localization/Cell_set.h>
#include <corral/localization/Grid.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace corral::fast {

/// The part of a grid that a node covers.
template <std::size_t D>
[[nodiscard]] Grid<D> part(const Grid<D>& grid, const Plan<D>& plan, const Hidden_node<D>& node)
{
  Rational_box<D> box;
  Resolution<D> cells;
  for (std::size_t axis = 0; axis < D; ++axis) {
    const std::uint32_t first = node.corner[axis];
    const std::uint32_t last = std::min(first + plan.span(node.level, axis), grid.resolution()[axis]);
    box[axis] = Rational_interval(grid.line(axis, first), grid.line(axis, last));
    cells[axis] = last - first;
  }
  return {std::move(box), cells};
}

/// Adds the cells of the part with this corner to blocks of the whole grid. \pre The corner is one of a block.
template <std::size_t D>
void append_part(const Cell_set<D>& cells, const std::array<std::uint32_t, D>& corner, Block_list<D>& blocks)
{
  for (auto block : cells.blocks()) {
    for (std::size_t axis = 0; axis < D; ++axis) block.index[axis] += corner[axis] / block_side<D>;
    blocks.add(block);
  }
}

} // namespace corral::fast

#endif
