// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_TEST_DECISION_ALL_CELLS_H
#define CORRAL_TEST_DECISION_ALL_CELLS_H

#include <corral/localization/Raster_builder.h>

#include <cstddef>
#include <cstdint>
#include <utility>

namespace check {

using namespace corral;

/// Every cell of a grid, unknown: a localisation that knows nothing.
template <std::size_t D>
Raster<D> all_cells(const Grid<D>& grid)
{
  const Resolution<D>& resolution = grid.resolution();
  Raster_builder<D> cells;
  Cell<D> block{};
  const auto blocks = [&](std::size_t axis) { return (resolution[axis] + block_side<D> - 1) / block_side<D>; };
  for (;;) {
    Cell_block<D> entry{block, 0, 0};
    for (unsigned bit = 0; bit < 64; ++bit) {
      const auto cell = cell_of<D>(block, bit);
      bool inside = true;
      for (std::size_t axis = 0; axis < D; ++axis) inside = inside && cell[axis] < resolution[axis];
      if (inside) entry.plotted |= std::uint64_t{1} << bit;
    }
    cells.append(entry);
    std::size_t axis = 0;
    while (axis < D && ++block[axis] == blocks(axis)) block[axis++] = 0;
    if (axis == D) break;
  }
  return std::move(cells).finish(grid, true);
}

} // namespace check

#endif
