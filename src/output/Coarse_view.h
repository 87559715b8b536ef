// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_OUTPUT_COARSE_VIEW_H
#define CORRAL_OUTPUT_COARSE_VIEW_H

#include <corral/localization/Raster_builder.h>

#include <algorithm>
#include <array>
#include <map>

namespace corral {

/// \brief The cells of a grid as they look from afar: merges them until no axis has more than `limit` of them. A merged
/// cell is as strong as the strongest cell in it: a zero in a cell is a zero in every region around it, so that `hit`
/// stays true, and no plotted cell vanishes. \par Complexity  one look-up a cell; memory for the merged blocks.
template <std::size_t D>
[[nodiscard]] Raster<D> coarsen(const Raster<D>& raster, const Resolution<D>& limit)
{
  const Resolution<D>& fine = raster.grid().resolution();
  Resolution<D> coarse;
  for (std::size_t axis = 0; axis < D; ++axis) coarse[axis] = std::min(fine[axis], limit[axis]);
  if (coarse == fine) return raster;
  std::map<std::array<std::uint32_t, D>, Cell_block<D>> blocks;
  for (const auto& [cell, verdict] : raster) {
    Cell<D> merged;
    Cell_block<D> block;
    for (std::size_t axis = 0; axis < D; ++axis) {
      merged[axis] = static_cast<std::uint32_t>(std::uint64_t{cell[axis]} * coarse[axis] / fine[axis]);
      block.index[axis] = merged[axis] / block_side<D>;
    }
    Cell_block<D>& found = blocks.try_emplace(block.index, block).first->second;
    const std::uint64_t mask = std::uint64_t{1} << bit_of<D>(merged);
    found.plotted |= mask;
    if (verdict == Verdict::hit) found.hit |= mask;
  }
  Raster_builder<D> view;
  for (const auto& [index, block] : blocks) view.append(block);
  return std::move(view).finish(Grid<D>(raster.grid().box(), coarse), raster.is_guaranteed());
}

} // namespace corral

#endif
