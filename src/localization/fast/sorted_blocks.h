// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_LOCALIZATION_FAST_SORTED_BLOCKS_H
#define CORRAL_SRC_LOCALIZATION_FAST_SORTED_BLOCKS_H

#include "Block_list.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace corral::fast {

/// Calls `function(k)` for k from 0 to `count`, in parallel if there is more than one.
template <class Function>
void for_each_share(std::size_t count, const Function& function)
{
  if (count == 1) return function(std::size_t{0});
  tbb::parallel_for(std::size_t{0}, count, function);
}

/// \brief Puts blocks of many parts into one sorted list: first into layers by axis 0, then each layer by the other
/// axes.
///
/// Both steps are cut into `shares` that are worked on in parallel.
template <std::size_t D>
class Block_sorter
{
public:
  using Block = Cell_block<D>;
  using Parts = std::vector<Block_list<D>>;

  /// \pre No two blocks have the same index. \param extent  more than any index, by axis.
  Block_sorter(Parts parts, const std::array<std::uint32_t, D>& extent, std::size_t shares)
      : parts_(std::move(parts)), extent_(extent), shares_(shares)
  {}

  /// \par Complexity  Linear in the blocks and the extents if there are many blocks, else n log n.
  [[nodiscard]] std::vector<Block> run()
  {
    std::size_t count = 0;
    for (const auto& part : parts_) count += part.size();
    sorted_.resize(count);
    if (count < 64 || extent_[0] / 4 > count) {
      auto to = sorted_.begin();
      for (const auto& part : parts_) part.visit([&](const Block& block) { *to++ = block; });
      std::sort(sorted_.begin(), sorted_.end(), by_index);
    } else {
      into_layers();
      for_each_share(shares_, [&](std::size_t share) { sort_layers(share); });
    }
    return std::move(sorted_);
  }

private:
  static bool by_index(const Block& a, const Block& b) { return a.index < b.index; }

  void into_layers()
  {
    std::vector<std::vector<std::size_t>> position(shares_, std::vector<std::size_t>(extent_[0]));
    const auto parts_of = [&](std::size_t share, const auto& visit) {
      for (std::size_t p = share; p < parts_.size(); p += shares_) parts_[p].visit(visit);
    };
    for_each_share(shares_, [&](std::size_t share) {
      parts_of(share, [&](const Block& block) { ++position[share][block.index[0]]; });
    });
    std::size_t next = 0;
    for (std::size_t layer = 0; layer < extent_[0]; ++layer) {
      layer_.push_back(next);
      for (auto& of_share : position) next += std::exchange(of_share[layer], next);
    }
    layer_.push_back(next);
    for_each_share(shares_, [&](std::size_t share) {
      parts_of(share, [&](const Block& block) { sorted_[position[share][block.index[0]]++] = block; });
    });
  }

  /// Sorts the layers that begin in one share of the list.
  void sort_layers(std::size_t share)
  {
    const auto first_layer = [&](std::size_t s) {
      return std::lower_bound(layer_.begin(), layer_.end() - 1, sorted_.size() * s / shares_);
    };
    std::vector<Block> scratch;
    std::vector<std::uint32_t> position;
    const auto last = share + 1 == shares_ ? layer_.end() - 1 : first_layer(share + 1);
    for (auto layer = first_layer(share); layer < last; ++layer)
      sort_layer(sorted_.data() + layer[0], sorted_.data() + layer[1], scratch, position);
  }

  /// Sorts by all axes but the first: by counting if that is worthwhile.
  void sort_layer(Block* first, Block* last, std::vector<Block>& scratch, std::vector<std::uint32_t>& position) const
  {
    const auto count = static_cast<std::size_t>(last - first);
    if (count < 12 || *std::max_element(extent_.begin() + 1, extent_.end()) / 4 > count) {
      std::sort(first, last, by_index);
      return;
    }
    for (std::size_t axis = D; axis-- > 1;) {
      position.assign(extent_[axis] + std::size_t{1}, 0);
      for (const Block* block = first; block != last; ++block) ++position[block->index[axis] + std::size_t{1}];
      for (std::size_t k = 1; k < position.size(); ++k) position[k] += position[k - 1];
      scratch.assign(first, last);
      for (const Block& block : scratch) first[position[block.index[axis]]++] = block;
    }
  }

  Parts parts_;
  std::array<std::uint32_t, D> extent_;
  std::size_t shares_;
  std::vector<Block> sorted_;
  std::vector<std::size_t> layer_; // where each layer begins
};

} // namespace corral::fast

#endif
