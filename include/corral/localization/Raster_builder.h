// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_LOCALIZATION_RASTER_BUILDER_H
#define CORRAL_LOCALIZATION_RASTER_BUILDER_H

#include <corral/localization/Raster.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace corral {

/// \brief Collects the cells that are not `empty`, in any order, and makes a `Raster` of them.
template <std::size_t D>
class Raster_builder
{
public:
  using Block = Cell_block<D>;

  /// Adds the cells of a block. \throw Invalid_input if it holds none, or a hit that is not plotted.
  void append(const Block& block)
  {
    require_form(block);
    is_ordered_ = is_ordered_ && (blocks_.empty() || blocks_.back().index < block.index);
    blocks_.push_back(block);
  }

  /// \brief Adds one cell; memory for a block unless the last cell was in the same one.
  /// \throw Invalid_input if `verdict` is `empty`.
  void append(const Cell<D>& cell, Verdict verdict)
  {
    if (verdict == Verdict::empty) detail::refuse_input("raster: given an empty cell; expected one that is not");
    const std::uint64_t mask = std::uint64_t{1} << bit_of<D>(cell);
    const auto index = block_of(cell);
    if (blocks_.empty() || blocks_.back().index != index) append(Block{index, mask, 0});
    blocks_.back().plotted |= mask;
    if (verdict == Verdict::hit) blocks_.back().hit |= mask;
  }

  /// Adds the cells of many blocks, which are taken over if they are the first. \throw Invalid_input as for one.
  void append(std::vector<Block>&& blocks)
  {
    for (const Block& block : blocks) require_form(block);
    is_ordered_ = blocks_.empty() && is_in_order(blocks);
    if (blocks_.empty())
      blocks_ = std::move(blocks);
    else
      blocks_.insert(blocks_.end(), blocks.begin(), blocks.end());
  }

  /// The run was stopped before it visited these cells: none of them is added otherwise.
  void leave(const Cell_range<D>& range)
  {
    unvisited_.push_back(range);
    was_stopped_ = true;
  }
  /// The run was stopped, though it had visited all cells.
  void stop() { was_stopped_ = true; }

  /// What there is so far, in order.
  [[nodiscard]] const std::vector<Block>& blocks()
  {
    if (!is_ordered_) order();
    return blocks_;
  }
  [[nodiscard]] const std::vector<Cell_range<D>>& unvisited() const { return unvisited_; }

  /// \brief The raster. The builder is empty after that.
  /// \param is_guaranteed  whether all cells that were not added are proved empty, and all hits proved.
  /// \throw Invalid_input if a cell is not one of the grid, or (where assertions are on) is visited and left.
  /// \par Complexity  Nothing if the blocks are in order; else linear in them and the largest index if there are many,
  ///      else n log n.
  [[nodiscard]] Raster<D> finish(const Grid<D>& grid, bool is_guaranteed, const Work_counters& counters = {}) &&
  {
    if (!is_ordered_) order();
    require_grid(grid);
    std::sort(unvisited_.begin(), unvisited_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    Raster<D> result(grid, std::move(blocks_), std::move(unvisited_));
    result.is_guaranteed_ = is_guaranteed;
    result.was_stopped_ = was_stopped_;
    result.counters_ = counters;
    *this = {};
    return result;
  }

private:
  /// Of the cell of a block that is last along every axis.
  static constexpr unsigned last_bit = [] {
    unsigned cells = 1;
    for (std::size_t axis = 0; axis < D; ++axis) cells *= block_side<D>;
    return cells - 1;
  }();

  static void require_form(const Block& block)
  {
    if (block.plotted == 0 || (block.hit & ~block.plotted) != 0)
      detail::refuse_input("raster: given a block without cells or with a hit that is not plotted; expected neither");
  }

  void require_grid(const Grid<D>& grid) const
  {
    for (const Block& block : blocks_) {
      if (grid.contains(cell_of<D>(block.index, last_bit))) continue;
      for (std::uint64_t rest = block.plotted; rest != 0; rest &= rest - 1)
        grid.require(cell_of<D>(block.index, static_cast<unsigned>(std::countr_zero(rest))), "raster");
    }
    for (const auto& range : unvisited_) {
      if (range.is_empty()) detail::refuse_input("raster: given a range without cells; expected some");
      Cell<D> last = range.end;
      for (auto& index : last) --index;
      grid.require(last, "raster");
    }
    CORRAL_PRECONDITION(leaves_none_twice(),
                        "raster: given a cell as visited and left, or left twice; expected neither");
  }

  /// \par Complexity  The ranges times all blocks and ranges.
  [[nodiscard]] bool leaves_none_twice() const
  {
    for (const auto& range : unvisited_) {
      for (const Block& block : blocks_)
        for (std::uint64_t rest = block.plotted; rest != 0; rest &= rest - 1)
          if (range.contains(cell_of<D>(block.index, static_cast<unsigned>(std::countr_zero(rest))))) return false;
      for (const auto& other : unvisited_)
        if (&other != &range && range.meets(other)) return false;
    }
    return true;
  }

  static bool is_in_order(const std::vector<Block>& blocks)
  {
    const auto precedes = [](const Block& a, const Block& b) { // std::array compares more slowly
      std::size_t axis = 0;
      while (axis + 1 < D && a.index[axis] == b.index[axis]) ++axis;
      return a.index[axis] < b.index[axis];
    };
    return std::adjacent_find(blocks.begin(), blocks.end(), std::not_fn(precedes)) == blocks.end();
  }

  /// Sorts the blocks and joins those of the same cells: a cell that is a hit in one of them is a hit.
  void order()
  {
    std::uint32_t largest = 0;
    for (const Block& block : blocks_)
      largest = std::max(largest, *std::max_element(block.index.begin(), block.index.end()));
    if (blocks_.size() < 64 || largest / 4 > blocks_.size())
      std::sort(blocks_.begin(), blocks_.end(), [](const Block& a, const Block& b) { return a.index < b.index; });
    else
      for (std::size_t axis = D; axis-- > 0;) sort_by(axis, largest);
    join_blocks();
    is_ordered_ = true;
  }
  /// \pre The blocks are sorted.
  void join_blocks()
  {
    const auto same = [](const Block& a, const Block& b) { return a.index == b.index; };
    auto last = std::adjacent_find(blocks_.begin(), blocks_.end(), same);
    if (last == blocks_.end()) return;
    for (auto next = last + 1; next != blocks_.end(); ++next)
      if (same(*last, *next)) {
        last->plotted |= next->plotted;
        last->hit |= next->hit;
      } else
        *++last = *next;
    blocks_.erase(last + 1, blocks_.end());
  }
  /// Counting sort by the index of one axis; stable. \pre No index exceeds `largest`.
  void sort_by(std::size_t axis, std::uint32_t largest)
  {
    std::vector<std::size_t> position(largest + std::size_t{2});
    for (const Block& block : blocks_) ++position[block.index[axis] + std::size_t{1}];
    for (std::size_t k = 1; k < position.size(); ++k) position[k] += position[k - 1];
    std::vector<Block> sorted(blocks_.size());
    for (const Block& block : blocks_) sorted[position[block.index[axis]]++] = block;
    blocks_.swap(sorted);
  }

  std::vector<Block> blocks_;
  bool is_ordered_ = true;
  std::vector<Cell_range<D>> unvisited_;
  bool was_stopped_ = false;
};

} // namespace corral

#endif
