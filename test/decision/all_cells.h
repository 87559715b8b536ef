// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_TEST_DECISION_ALL_CELLS_H
#define CORRAL_TEST_DECISION_ALL_CELLS_H

#include <corral/localization/Cell_set.h>

#include <cstddef>
#include <cstdint>

namespace check {

using namespace corral;

/// Every cell of a grid, unknown: a localisation that knows nothing.
template <std::size_t D>
Cell_set<D> all_cells(const Resolution<D>& resolution)
{
  Cell_set<D> cells;
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
  cells.finish();
  return cells;
}

} // namespace check

#endif
