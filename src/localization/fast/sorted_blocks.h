// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_LOCALIZATION_FAST_SORTED_BLOCKS_H
#define CORRAL_SRC_LOCALIZATION_FAST_SORTED_BLOCKS_H

#include "Block_list.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace corral::fast {

/// \brief Puts the blocks of some lists in order: first into layers by axis 0, then each layer by the other axes.
template <std::size_t D>
class Block_sorter
{
public:
  using Block = Cell_block<D>;
  using Lists = std::span<const Block_list<D>>;

  /// \brief Writes the blocks of all lists to `to`. \pre No two have the same index.
  /// \par Complexity  Linear in the blocks and the indices that they span if there are many blocks, else n log n.
  void sort(Lists lists, Block* to)
  {
    std::size_t count = 0;
    std::array<std::uint32_t, D> last{};
    first_.fill(std::numeric_limits<std::uint32_t>::max());
    visit(lists, [&](const Block& block) {
      ++count;
      for (std::size_t axis = 0; axis < D; ++axis) {
        first_[axis] = std::min(first_[axis], block.index[axis]);
        last[axis] = std::max(last[axis], block.index[axis]);
      }
    });
    if (count == 0) return;
    for (std::size_t axis = 0; axis < D; ++axis) extent_[axis] = last[axis] - first_[axis] + std::size_t{1};
    if (extent_[0] / 4 > count) {
      Block* next = to;
      visit(lists, [&](const Block& block) { *next++ = block; });
      std::ranges::sort(to, next, {}, &Block::index);
      return;
    }
    into_layers(lists, to);
    for (std::size_t layer = 0, begin = 0; layer < extent_[0]; begin = layer_[layer++])
      sort_layer(to + begin, to + layer_[layer]);
  }

private:
  template <class Visit>
  static void visit(Lists lists, const Visit& visit)
  {
    for (const auto& list : lists) list.visit(visit);
  }

  /// After this layer_[k] is where layer k ends.
  void into_layers(Lists lists, Block* to)
  {
    layer_.assign(extent_[0], 0);
    visit(lists, [&](const Block& block) { ++layer_[block.index[0] - first_[0]]; });
    std::size_t next = 0;
    for (auto& layer : layer_) next += std::exchange(layer, next);
    visit(lists, [&](const Block& block) { to[layer_[block.index[0] - first_[0]]++] = block; });
  }

  /// The indices along all axes but the first.
  static std::uint64_t rest(const Block& block)
  {
    std::uint64_t key = 0;
    for (std::size_t axis = 1; axis < D; ++axis) key = key << 32 | block.index[axis];
    return key;
  }

  /// Sorts by all axes but the first: by counting if that is worthwhile.
  void sort_layer(Block* first, Block* last)
  {
    const auto count = static_cast<std::size_t>(last - first);
    if (count < 12 || *std::max_element(extent_.begin() + 1, extent_.end()) / 4 > count) {
      std::sort(first, last, [](const Block& a, const Block& b) { return rest(a) < rest(b); });
      return;
    }
    for (std::size_t axis = D; axis-- > 1;) {
      const auto at = [&](const Block& block) { return block.index[axis] - first_[axis]; };
      position_.assign(extent_[axis] + 1, 0);
      for (const Block* block = first; block != last; ++block) ++position_[at(*block) + std::size_t{1}];
      for (std::size_t k = 1; k < position_.size(); ++k) position_[k] += position_[k - 1];
      scratch_.assign(first, last);
      for (const Block& block : scratch_) first[position_[at(block)]++] = block;
    }
  }

  std::array<std::uint32_t, D> first_{};
  std::array<std::size_t, D> extent_{};
  std::vector<std::size_t> layer_;
  std::vector<Block> scratch_;
  std::vector<std::size_t> position_;
};

} // namespace corral::fast

#endif
