// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_LOCALIZATION_FAST_BLOCK_LIST_H
#define CORRAL_SRC_LOCALIZATION_FAST_BLOCK_LIST_H

#include <corral/localization/Cell_block.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <vector>

namespace corral::fast {

/// \brief Blocks of cells in the order in which they were found, in chunks that never move.
template <std::size_t D>
class Block_list
{
public:
  using Block = Cell_block<D>;

  /// Room for up to `count` blocks behind the last; `keep` takes some of them in.
  [[nodiscard]] Block* room(std::size_t count)
  {
    if (chunks_.empty() || chunks_.back().capacity - chunks_.back().count < count) {
      const std::size_t capacity = std::max(std::clamp(size_, least_chunk, largest_chunk), count);
      chunks_.push_back({std::make_unique<Block[]>(capacity), 0, capacity});
    }
    return chunks_.back().blocks.get() + chunks_.back().count;
  }

  /// Takes in the first `count` blocks of the room, with `plotted` cells in all.
  void keep(std::size_t count, std::uint64_t plotted)
  {
    chunks_.back().count += count;
    size_ += count;
    plotted_ += plotted;
  }

  void add(const Block& block)
  {
    *room(1) = block;
    keep(1, static_cast<unsigned>(std::popcount(block.plotted)));
  }

  /// Takes in all blocks of another list.
  void append(Block_list&& other)
  {
    std::move(other.chunks_.begin(), other.chunks_.end(), std::back_inserter(chunks_));
    size_ += other.size_;
    plotted_ += other.plotted_;
    other = {};
  }

  template <class Visit>
  void visit(const Visit& visit) const
  {
    for (const Chunk& chunk : chunks_) std::for_each_n(chunk.blocks.get(), chunk.count, visit);
  }

  /// All blocks, sorted by index.
  [[nodiscard]] std::vector<Block> sorted() const
  {
    std::vector<Block> result;
    result.reserve(size_);
    visit([&](const Block& block) { result.push_back(block); });
    std::ranges::sort(result, {}, &Block::index);
    return result;
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::uint64_t plotted() const { return plotted_; } ///< cells

private:
  static constexpr std::size_t least_chunk = 64;
  static constexpr std::size_t largest_chunk = 1024;
  struct Chunk
  {
    std::unique_ptr<Block[]> blocks;
    std::size_t count;
    std::size_t capacity;
  };

  std::vector<Chunk> chunks_;
  std::size_t size_ = 0;
  std::uint64_t plotted_ = 0;
};

} // namespace corral::fast

#endif
