// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_LOCALIZATION_FAST_GRID_PART_H
#define CORRAL_SRC_LOCALIZATION_FAST_GRID_PART_H

#include "Block_list.h"
#include "Fast_plan.h"

#include <corral/localization/Cell_range.h>
#include <corral/localization/Grid.h>
#include <corral/localization/Raster_builder.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace corral::fast {

/// A box of cells of a grid.
template <std::size_t D>
struct Grid_part
{
  Cell<D> corner;
  Resolution<D> size;
};

/// What a node covers of the grid.
template <std::size_t D>
[[nodiscard]] Grid_part<D> part_of(const Plan<D>& plan, const Hidden_node<D>& node)
{
  Grid_part<D> part{node.corner, {}};
  for (std::size_t axis = 0; axis < D; ++axis)
    part.size[axis] = std::min(plan.span(node.level, axis), plan.resolution[axis] - node.corner[axis]);
  return part;
}

/// The part as a grid of its own.
template <std::size_t D>
[[nodiscard]] Grid<D> grid_of(const Grid<D>& grid, const Grid_part<D>& part)
{
  Rational_box<D> box;
  for (std::size_t axis = 0; axis < D; ++axis)
    box[axis] =
        Rational_interval(grid.line(axis, part.corner[axis]), grid.line(axis, part.corner[axis] + part.size[axis]));
  return {std::move(box), part.size};
}

/// A part of a part, as one of the grid.
template <std::size_t D>
[[nodiscard]] Grid_part<D> moved(Grid_part<D> part, const Cell<D>& by)
{
  for (std::size_t axis = 0; axis < D; ++axis) part.corner[axis] += by[axis];
  return part;
}

/// The levels of a tree that has the part as its root.
template <std::size_t D>
[[nodiscard]] int levels_of(const Grid_part<D>& part)
{
  return static_cast<int>(std::bit_width(*std::max_element(part.size.begin(), part.size.end()) - 1));
}

/// The cells of a part of a grid.
template <std::size_t D>
[[nodiscard]] Cell_range<D> range_of(const Grid_part<D>& part)
{
  Cell_range<D> range{part.corner, part.corner};
  for (std::size_t axis = 0; axis < D; ++axis) range.end[axis] += part.size[axis];
  return range;
}

/// Adds the cells of the part with this corner to blocks of the whole grid. \pre The corner is one of a block.
template <std::size_t D>
void append_part(const std::vector<Cell_block<D>>& part, const Cell<D>& corner, Block_list<D>& blocks)
{
  for (auto block : part) {
    for (std::size_t axis = 0; axis < D; ++axis) block.index[axis] += corner[axis] / block_side<D>;
    blocks.add(block);
  }
}

} // namespace corral::fast

#endif
