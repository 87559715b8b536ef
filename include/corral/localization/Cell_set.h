// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_LOCALIZATION_CELL_SET_H
#define CORRAL_LOCALIZATION_CELL_SET_H

#include <corral/errors.h>
#include <corral/localization/Grid.h>
#include <corral/localization/Verdict.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace corral {

/// Side of a block of cells: the largest power of two whose D-th power is at most 64.
template <std::size_t D>
inline constexpr std::uint32_t block_side = D == 1   ? 64
                                            : D == 2 ? 8
                                            : D == 3 ? 4
                                            : D <= 6 ? 2
                                                     : 1;

/// \brief A cube of `block_side<D>` cells a side, one bit a cell.
///
/// Bit number sum_k (cell[k] mod side) * side^(D-1-k): the last axis runs fastest. `hit` is a
/// subset of `plotted`; a plotted cell that is not a hit is unknown.
template <std::size_t D>
struct Cell_block
{
  std::array<std::uint32_t, D> index{}; ///< cell index divided by `block_side<D>`
  std::uint64_t plotted = 0;
  std::uint64_t hit = 0;
  friend bool operator==(const Cell_block&, const Cell_block&) = default;
};

/// The bit of a cell in its block.
template <std::size_t D>
[[nodiscard]] constexpr unsigned bit_of(const Cell<D>& cell)
{
  unsigned bit = 0;
  for (std::size_t axis = 0; axis < D; ++axis) bit = bit * block_side<D> + cell[axis] % block_side<D>;
  return bit;
}

/// The cell of one bit of a block.
template <std::size_t D>
[[nodiscard]] constexpr Cell<D> cell_of(const std::array<std::uint32_t, D>& block, unsigned bit)
{
  Cell<D> cell{};
  for (std::size_t axis = D; axis-- > 0; bit /= block_side<D>)
    cell[axis] = block[axis] * block_side<D> + bit % block_side<D>;
  return cell;
}

/// \brief The cells of a grid that are not `empty`, each with its verdict.
///
/// Memory is proportional to the blocks that hold such cells, never to the grid. Blocks are
/// sorted by index, lexicographically from axis 0, and each occurs once, when `finish` has run.
template <std::size_t D>
class Cell_set
{
public:
  using Block = Cell_block<D>;

  /// Adds the cells of a block. \throw Invalid_input if it holds none, or a hit that is not plotted.
  void append(const Block& block)
  {
    require_form(block);
    blocks_.push_back(block);
    is_finished_ = false;
  }

  /// \brief Adds one cell; memory for a block unless the last cell was in the same one.
  /// \throw Invalid_input if `verdict` is `empty`.
  void append(const Cell<D>& cell, Verdict verdict)
  {
    if (verdict == Verdict::empty) detail::refuse_input("Cell_set: given an empty cell; expected one that is not");
    is_finished_ = false;
    std::array<std::uint32_t, D> index;
    for (std::size_t axis = 0; axis < D; ++axis) index[axis] = cell[axis] / block_side<D>;
    if (blocks_.empty() || blocks_.back().index != index) blocks_.push_back({index, 0, 0});
    const std::uint64_t mask = std::uint64_t{1} << bit_of<D>(cell);
    blocks_.back().plotted |= mask;
    if (verdict == Verdict::hit) blocks_.back().hit |= mask;
  }

  /// Adds all cells of `other`.
  void append(const Cell_set& other)
  {
    blocks_.insert(blocks_.end(), other.blocks_.begin(), other.blocks_.end());
    is_finished_ = false;
  }

  /// Adds the cells of many blocks; if these are the first and in order, the set is finished. \throw Invalid_input as
  /// for one.
  void append(std::vector<Block>&& blocks)
  {
    for (const Block& block : blocks) require_form(block);
    is_finished_ = blocks_.empty() && is_in_order(blocks);
    if (blocks_.empty())
      blocks_ = std::move(blocks);
    else
      blocks_.insert(blocks_.end(), blocks.begin(), blocks.end());
  }

  /// \brief Says of which grid the cells are, so that they are not taken for those of another one.
  void set_grid(const Grid<D>& grid) { grid_ = std::make_shared<const Grid<D>>(grid); }

  /// \throw Invalid_input in the name of `who` if a cell is not of this grid, or the set was made on another one.
  void require_grid(const Grid<D>& grid, const char* who) const
  {
    if (grid_ && !(*grid_ == grid))
      throw Invalid_input(std::string(who) + ": given cells of another grid; expected those of the grid given");
    for (const Block& block : blocks_) {
      if (grid.contains(cell_of<D>(block.index, last_bit))) continue;
      for (std::uint64_t rest = block.plotted; rest != 0; rest &= rest - 1)
        grid.require(cell_of<D>(block.index, static_cast<unsigned>(std::countr_zero(rest))), who);
    }
  }

  /// \brief Sorts the blocks and joins those of the same cells: a cell that is a hit in one of them is a hit.
  /// \par Complexity  Linear in the blocks and the largest index if there are many blocks, else n log n.
  void finish()
  {
    std::uint32_t largest = 0;
    for (const Block& block : blocks_)
      largest = std::max(largest, *std::max_element(block.index.begin(), block.index.end()));
    if (blocks_.size() < 64 || largest / 4 > blocks_.size())
      std::sort(blocks_.begin(), blocks_.end(), [](const Block& a, const Block& b) { return a.index < b.index; });
    else
      for (std::size_t axis = D; axis-- > 0;) sort_by(axis, largest);
    join_blocks();
    is_finished_ = true;
  }

  [[nodiscard]] const std::vector<Block>& blocks() const { return blocks_; }

  /// How many cells are not empty, and how many of these are hits.
  [[nodiscard]] std::uint64_t plotted() const { return count(&Block::plotted); }
  [[nodiscard]] std::uint64_t hit() const { return count(&Block::hit); }
  [[nodiscard]] std::uint64_t unknown() const { return plotted() - hit(); }

  /// The verdict of one cell. \throw Invalid_input unless `finish` has run. \par Complexity  logarithmic.
  [[nodiscard]] Verdict at(const Cell<D>& cell) const
  {
    require_finished();
    std::array<std::uint32_t, D> index;
    for (std::size_t axis = 0; axis < D; ++axis) index[axis] = cell[axis] / block_side<D>;
    const auto found = std::lower_bound(blocks_.begin(), blocks_.end(), index,
                                        [](const Block& block, const auto& key) { return block.index < key; });
    if (found == blocks_.end() || found->index != index) return Verdict::empty;
    return verdict(*found, bit_of<D>(cell));
  }

  /// Calls `visit(cell, verdict)` for every plotted cell, block by block.
  template <class Visitor>
  void for_each(Visitor&& visit) const
  {
    for (const Block& block : blocks_)
      for (std::uint64_t rest = block.plotted; rest != 0; rest &= rest - 1) {
        const auto bit = static_cast<unsigned>(std::countr_zero(rest));
        visit(cell_of<D>(block.index, bit), verdict(block, bit));
      }
  }

  /// \brief Calls `visit(cell, verdict)` for every plotted cell in lexicographic order of the index.
  /// \throw Invalid_input unless `finish` has run.
  /// \par Complexity  n log n for n cells; memory for one layer of blocks.
  template <class Visitor>
  void for_each_sorted(Visitor&& visit) const
  {
    require_finished();
    std::vector<std::pair<Cell<D>, Verdict>> layer;
    for (std::size_t first = 0; first < blocks_.size();) {
      layer.clear();
      const std::uint32_t layer_index = blocks_[first].index[0];
      for (; first < blocks_.size() && blocks_[first].index[0] == layer_index; ++first)
        for (std::uint64_t rest = blocks_[first].plotted; rest != 0; rest &= rest - 1) {
          const auto bit = static_cast<unsigned>(std::countr_zero(rest));
          layer.emplace_back(cell_of<D>(blocks_[first].index, bit), verdict(blocks_[first], bit));
        }
      std::sort(layer.begin(), layer.end());
      for (const auto& [cell, what] : layer) visit(cell, what);
    }
  }

  /// Whether both have the same cells.
  friend bool operator==(const Cell_set& a, const Cell_set& b) { return a.blocks_ == b.blocks_; }

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
      detail::refuse_input("Cell_set: given a block without cells or with a hit that is not plotted; expected neither");
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
  void require_finished() const
  {
    if (!is_finished_) detail::refuse_input("Cell_set: asked before finish() has run; expected it to have");
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
  static Verdict verdict(const Block& block, unsigned bit)
  {
    if ((block.plotted >> bit & 1) == 0) return Verdict::empty;
    return (block.hit >> bit & 1) != 0 ? Verdict::hit : Verdict::unknown;
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
  [[nodiscard]] std::uint64_t count(std::uint64_t Block::*mask) const
  {
    std::uint64_t sum = 0;
    for (const Block& block : blocks_) sum += static_cast<std::uint64_t>(std::popcount(block.*mask));
    return sum;
  }

  std::vector<Block> blocks_;
  bool is_finished_ = true;
  std::shared_ptr<const Grid<D>> grid_{};
};

} // namespace corral

#endif
