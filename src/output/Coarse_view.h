// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_OUTPUT_COARSE_VIEW_H
#define CORRAL_OUTPUT_COARSE_VIEW_H

#include <corral/localization/Cell_set.h>

#include <algorithm>
#include <array>
#include <map>

namespace corral {

/// The cells of a grid as they look from afar: several cells share one.
template <std::size_t D>
struct Coarse_view
{
  Resolution<D> resolution;
  Cell_set<D> cells;
};

/// \brief Merges cells until no axis has more than `limit` of them. A merged cell is as strong as the strongest cell in
/// it: a zero in a cell is a zero in every region around it, so that `hit` stays true, and no plotted cell vanishes.
/// \par Complexity  one look-up a cell; memory for the merged blocks.
template <std::size_t D>
[[nodiscard]] Coarse_view<D> coarsen(const Grid<D>& grid, const Cell_set<D>& cells, const Resolution<D>& limit)
{
  Coarse_view<D> view;
  for (std::size_t axis = 0; axis < D; ++axis) view.resolution[axis] = std::min(grid.resolution()[axis], limit[axis]);
  if (view.resolution == grid.resolution()) {
    view.cells = cells;
    return view;
  }
  std::map<std::array<std::uint32_t, D>, Cell_block<D>> blocks;
  cells.for_each([&](const Cell<D>& cell, Verdict verdict) {
    Cell<D> merged;
    Cell_block<D> block;
    for (std::size_t axis = 0; axis < D; ++axis) {
      merged[axis] =
          static_cast<std::uint32_t>(std::uint64_t{cell[axis]} * view.resolution[axis] / grid.resolution()[axis]);
      block.index[axis] = merged[axis] / block_side<D>;
    }
    Cell_block<D>& found = blocks.try_emplace(block.index, block).first->second;
    const std::uint64_t mask = std::uint64_t{1} << bit_of<D>(merged);
    found.plotted |= mask;
    if (verdict == Verdict::hit) found.hit |= mask;
  });
  for (const auto& [index, block] : blocks) view.cells.append(block);
  view.cells.finish();
  return view;
}

} // namespace corral

#endif
