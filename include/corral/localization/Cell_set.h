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
/// sorted by index, lexicographically from axis 0, once `finish` has run.
template <std::size_t D>
class Cell_set
{
public:
  using Block = Cell_block<D>;

  /// Adds a block that no earlier call has added. \pre block.plotted != 0; hit is a subset of plotted.
  void append(const Block& block) { blocks_.push_back(block); }

  /// \brief Adds one cell.
  /// \pre `verdict` is not `empty`; cells of one block are added in succession.
  void append(const Cell<D>& cell, Verdict verdict)
  {
    std::array<std::uint32_t, D> index;
    for (std::size_t axis = 0; axis < D; ++axis) index[axis] = cell[axis] / block_side<D>;
    if (blocks_.empty() || blocks_.back().index != index) blocks_.push_back({index, 0, 0});
    const std::uint64_t mask = std::uint64_t{1} << bit_of<D>(cell);
    blocks_.back().plotted |= mask;
    if (verdict == Verdict::hit) blocks_.back().hit |= mask;
  }

  /// Adds all cells of `other`, which shares no block with this set.
  void append(const Cell_set& other) { blocks_.insert(blocks_.end(), other.blocks_.begin(), other.blocks_.end()); }

  /// Adds blocks that no earlier call has added.
  void append(std::vector<Block>&& blocks)
  {
    if (blocks_.empty())
      blocks_ = std::move(blocks);
    else
      blocks_.insert(blocks_.end(), blocks.begin(), blocks.end());
  }

  /// \brief Sorts the blocks.
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
  }

  [[nodiscard]] const std::vector<Block>& blocks() const { return blocks_; }

  /// How many cells are not empty, and how many of these are hits.
  [[nodiscard]] std::uint64_t plotted() const { return count(&Block::plotted); }
  [[nodiscard]] std::uint64_t hit() const { return count(&Block::hit); }
  [[nodiscard]] std::uint64_t unknown() const { return plotted() - hit(); }

  /// The verdict of one cell. \pre `finish` has run. \par Complexity  logarithmic.
  [[nodiscard]] Verdict at(const Cell<D>& cell) const
  {
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
  /// \pre `finish` has run. \par Complexity  n log n for n cells; memory for one layer of blocks.
  template <class Visitor>
  void for_each_sorted(Visitor&& visit) const
  {
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

  friend bool operator==(const Cell_set&, const Cell_set&) = default;

private:
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
};

} // namespace corral

#endif
