// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_LOCALIZATION_RASTER_H
#define CORRAL_LOCALIZATION_RASTER_H

#include <corral/localization/Cell_block.h>
#include <corral/localization/Cell_range.h>

#include <algorithm>
#include <bit>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace corral {

/// What a raster cost. Additions and multiplications are 0 where the number type does not count them.
struct Work_counters
{
  std::uint64_t bounds = 0;       ///< boxes bounded, for one polynomial each
  std::uint64_t subdivisions = 0; ///< boxes cut, cells cut into subcells included
  std::uint64_t additions = 0;
  std::uint64_t multiplications = 0;
  double seconds = 0;
};

/// A cell that is not `empty`.
template <std::size_t D>
struct Plotted_cell
{
  Cell<D> cell{};
  Verdict verdict = Verdict::unknown;
  friend auto operator<=>(const Plotted_cell&, const Plotted_cell&) = default;
};

template <std::size_t D>
class Raster_builder;

/// \brief What is known of every cell of a grid: a range of the cells that are not `empty`. It never changes.
///
/// Memory is proportional to the blocks of cells that are not empty, never to the grid. Cells of ranges that were not
/// visited, since the run was stopped, are `unknown` like others and counted and listed with them, however many.
/// Made by a `Raster_builder`, which has checked that every cell is one of the grid.
template <std::size_t D>
class Raster
{
public:
  using Block = Cell_block<D>;
  class Iterator;

  [[nodiscard]] const Grid<D>& grid() const { return grid_; }
  /// The visited cells that are not empty: sorted by index, lexicographically from axis 0, each block once.
  [[nodiscard]] const std::vector<Block>& blocks() const { return blocks_; }
  /// The cells that were not visited; no two ranges share a cell, and none has one with `blocks`.
  [[nodiscard]] const std::vector<Cell_range<D>>& unvisited() const { return unvisited_; }
  /// Whether the verdicts, `empty` included, are proofs.
  [[nodiscard]] bool is_guaranteed() const { return is_guaranteed_; }
  /// Whether the run was stopped before all cells were decided as well as it could.
  [[nodiscard]] bool was_stopped() const { return was_stopped_; }
  [[nodiscard]] const Work_counters& counters() const { return counters_; }

  /// The cells that are not empty, block by block and then those not visited.
  [[nodiscard]] Iterator begin() const { return {*this, 0, 0}; }
  [[nodiscard]] Iterator end() const { return {*this, blocks_.size(), unvisited_.size()}; }
  [[nodiscard]] std::uint64_t size() const { return plotted(); }
  [[nodiscard]] bool empty() const { return blocks_.empty() && unvisited_.empty(); }

  /// How many cells are not empty, and how many of these are hits; 2^64 - 1 if there are more. \par Complexity  linear
  /// in the blocks.
  [[nodiscard]] std::uint64_t plotted() const { return plus_unvisited(count(&Block::plotted)); }
  [[nodiscard]] std::uint64_t hit() const { return count(&Block::hit); }
  [[nodiscard]] std::uint64_t unknown() const { return plus_unvisited(count(&Block::plotted) - hit()); }
  /// How many of the unknown cells were not visited.
  [[nodiscard]] std::uint64_t unvisited_cells() const { return plus_unvisited(0); }

  /// The verdict of one cell. \throw Invalid_input unless it is one of the grid. \par Complexity  logarithmic in the
  /// blocks, linear in the ranges not visited.
  [[nodiscard]] Verdict verdict(const Cell<D>& cell) const
  {
    grid_.require(cell, "raster");
    const auto index = block_of(cell);
    const auto found = std::lower_bound(blocks_.begin(), blocks_.end(), index,
                                        [](const Block& block, const auto& key) { return block.index < key; });
    if (found != blocks_.end() && found->index == index)
      if (const Verdict known = verdict_of(*found, bit_of<D>(cell)); known != Verdict::empty) return known;
    const bool is_left =
        std::any_of(unvisited_.begin(), unvisited_.end(), [&](const auto& r) { return r.contains(cell); });
    return is_left ? Verdict::unknown : Verdict::empty;
  }

  /// The closed cell as a box. \throw Invalid_input unless it is one of the grid.
  [[nodiscard]] Rational_box<D> box(const Cell<D>& cell) const
  {
    grid_.require(cell, "raster");
    return grid_.cell_box(cell);
  }

  /// The closed cells of the grid that contain a point, with their verdicts, in order: one to 2^D, none if the point
  /// lies outside the grid.
  [[nodiscard]] std::vector<Plotted_cell<D>> cells_at(const Rational_point<D>& point) const
  {
    return with_verdicts(grid_.cells_at(point));
  }

  /// The cells of the grid that share a point with this one, with their verdicts, in order: at most 3^D - 1.
  /// \throw Invalid_input unless it is one of the grid.
  [[nodiscard]] std::vector<Plotted_cell<D>> neighbours(const Cell<D>& cell) const
  {
    return with_verdicts(grid_.neighbours(cell));
  }

  /// Calls `visit(cell, verdict)` for every visited cell that is not empty, block by block.
  template <class Visitor>
  void for_each_visited(Visitor&& visit) const
  {
    for (const Block& block : blocks_)
      for (std::uint64_t rest = block.plotted; rest != 0; rest &= rest - 1) {
        const auto bit = static_cast<unsigned>(std::countr_zero(rest));
        visit(cell_of<D>(block.index, bit), verdict_of(block, bit));
      }
  }

  /// \brief Calls `visit(cell, verdict)` for every cell that is not empty in lexicographic order of the index.
  /// \par Complexity  n log n for n cells; memory for one layer of blocks.
  template <class Visitor>
  void for_each_sorted(Visitor&& visit) const;

  /// Whether both say the same of the cells of the same grid; what that cost, and whether it is proved, does not
  /// matter.
  friend bool operator==(const Raster& a, const Raster& b)
  {
    return a.grid_ == b.grid_ && a.blocks_ == b.blocks_ && a.unvisited_ == b.unvisited_;
  }

  /// One line with the numbers of cells.
  friend std::ostream& operator<<(std::ostream& out, const Raster& raster)
  {
    out << "raster of ";
    for (std::size_t axis = 0; axis < D; ++axis) out << (axis == 0 ? "" : " x ") << raster.grid_.resolution()[axis];
    out << " cells: " << raster.hit() << " hit, " << raster.unknown() << " unknown, all others empty";
    if (!raster.is_guaranteed_) out << "; not guaranteed";
    if (raster.was_stopped_) out << "; stopped";
    return out;
  }

private:
  friend class Raster_builder<D>;
  Raster(Grid<D> grid, std::vector<Block>&& blocks, std::vector<Cell_range<D>>&& unvisited)
      : grid_(std::move(grid)), blocks_(std::move(blocks)), unvisited_(std::move(unvisited))
  {}

  [[nodiscard]] std::uint64_t count(std::uint64_t Block::*mask) const
  {
    std::uint64_t sum = 0;
    for (const Block& block : blocks_) sum += static_cast<std::uint64_t>(std::popcount(block.*mask));
    return sum;
  }
  [[nodiscard]] std::uint64_t plus_unvisited(std::uint64_t visited) const
  {
    constexpr auto most = std::numeric_limits<std::uint64_t>::max();
    for (const auto& range : unvisited_) visited = range.size() > most - visited ? most : visited + range.size();
    return visited;
  }
  [[nodiscard]] std::vector<Plotted_cell<D>> with_verdicts(const std::vector<Cell<D>>& cells) const
  {
    std::vector<Plotted_cell<D>> result;
    for (const auto& cell : cells) result.push_back({cell, verdict(cell)});
    return result;
  }

  Grid<D> grid_;
  std::vector<Block> blocks_;
  std::vector<Cell_range<D>> unvisited_;
  bool is_guaranteed_ = false;
  bool was_stopped_ = false;
  Work_counters counters_;
};

/// A place among the cells of a raster that are not empty, valid as long as the raster. Model of
/// `std::forward_iterator`.
template <std::size_t D>
class Raster<D>::Iterator
{
public:
  using value_type = Plotted_cell<D>;
  using difference_type = std::ptrdiff_t;
  using iterator_concept = std::forward_iterator_tag;

  Iterator() = default;

  [[nodiscard]] Plotted_cell<D> operator*() const
  {
    if (block_ == raster_->blocks_.size()) return {cell_, Verdict::unknown};
    const Block& block = raster_->blocks_[block_];
    const auto bit = static_cast<unsigned>(std::countr_zero(rest_));
    return {cell_of<D>(block.index, bit), verdict_of(block, bit)};
  }
  Iterator& operator++()
  {
    if (block_ < raster_->blocks_.size()) {
      rest_ &= rest_ - 1;
      if (rest_ == 0) enter(block_ + 1, 0);
    } else if (!raster_->unvisited_[range_].advance(cell_))
      enter(block_, range_ + 1);
    return *this;
  }
  Iterator operator++(int)
  {
    Iterator before = *this;
    ++*this;
    return before;
  }
  friend bool operator==(const Iterator&, const Iterator&) = default;

private:
  friend class Raster;
  Iterator(const Raster& raster, std::size_t block, std::size_t range) : raster_(&raster) { enter(block, range); }

  void enter(std::size_t block, std::size_t range)
  {
    block_ = block;
    range_ = range;
    rest_ = block < raster_->blocks_.size() ? raster_->blocks_[block].plotted : 0;
    cell_ = rest_ == 0 && range < raster_->unvisited_.size() ? raster_->unvisited_[range].first : Cell<D>{};
  }

  const Raster* raster_ = nullptr;
  std::size_t block_ = 0;
  std::uint64_t rest_ = 0; ///< of the block's cells, this one and those after it
  std::size_t range_ = 0;
  Cell<D> cell_{}; ///< in the range, when all blocks are done
};

template <std::size_t D>
template <class Visitor>
void Raster<D>::for_each_sorted(Visitor&& visit) const
{
  std::vector<Plotted_cell<D>> layer;
  auto block = blocks_.begin();
  for (std::uint32_t index = 0; index <= (grid_.resolution()[0] - 1) / block_side<D>; ++index) {
    if (unvisited_.empty()) { // nothing lies between the blocks
      if (block == blocks_.end()) return;
      index = block->index[0];
    }
    layer.clear();
    for (; block != blocks_.end() && block->index[0] == index; ++block)
      for (std::uint64_t rest = block->plotted; rest != 0; rest &= rest - 1) {
        const auto bit = static_cast<unsigned>(std::countr_zero(rest));
        layer.push_back({cell_of<D>(block->index, bit), verdict_of(*block, bit)});
      }
    for (const auto& range : unvisited_) {
      const auto part = range.between(index * block_side<D>, (index + 1) * block_side<D>);
      if (part.is_empty()) continue;
      Cell<D> cell = part.first;
      do layer.push_back({cell, Verdict::unknown});
      while (part.advance(cell));
    }
    std::sort(layer.begin(), layer.end());
    for (const auto& [cell, what] : layer) visit(cell, what);
  }
}

} // namespace corral

#endif
