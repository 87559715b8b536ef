// SPDX-License-Identifier: LGPL-3.0-or-later
// Included once for each instruction set, by fast_engine.cpp.
#if defined(CORRAL_SRC_FAST_CORNER_FACTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CORRAL_SRC_FAST_CORNER_FACTS_INL_H
#undef CORRAL_SRC_FAST_CORNER_FACTS_INL_H
#else
#define CORRAL_SRC_FAST_CORNER_FACTS_INL_H
#endif

#include "Fast_plan.h"

#include <hwy/highway.h>

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace corral::fast::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// One word for each block of a leaf, with the bits of `Cell_block`.
template <std::size_t D>
using Leaf_words = std::array<std::uint64_t, Plan<D>::leaf_blocks>;

/// The corners of the cells of a leaf, in rows along the last axis: 9 rows in the plane, 5 x 5 in space, axis 0 first.
template <std::size_t D>
struct Corner_layout
{
  static constexpr std::size_t side = block_side<D> + 1;            ///< rows along each axis
  static constexpr std::size_t layers = D == 2 ? 1 : block_side<D>; ///< of cells, along axis 0 of space
  static constexpr std::size_t layer_rows = block_side<D>;          ///< rows of cells in a layer
  static constexpr std::size_t row_points = 9;
  static constexpr std::size_t row_bytes = 16; ///< with padding
  static constexpr std::size_t layer_bytes = layer_rows * row_bytes;
  static constexpr std::size_t layer_step = side * row_bytes; ///< from a layer of corners to the next
};

/// \brief Which corners of eight leaves have some property: a byte a corner, with a bit a leaf.
template <std::size_t D>
struct Corner_facts
{
  using Layout = Corner_layout<D>;
  static constexpr std::size_t rows = D == 2 ? Layout::side : Layout::side * Layout::side;
  static constexpr std::size_t padding = 16; // what reading one corner further reads of the last row
  std::uint8_t of_corner[rows * Layout::row_bytes + padding];

  [[nodiscard]] std::uint8_t* row(std::size_t number) { return of_corner + number * Layout::row_bytes; }
};

using Bytes = hn::CappedTag<std::uint8_t, 64>;
inline constexpr std::size_t byte_lanes = hn::MaxLanes(Bytes());
using Byte_vector = hn::Vec<Bytes>;
static_assert(std::endian::native == std::endian::little);

/// Facts on the cells of eight leaves: rows like those of the corners, of which eight bytes count.
template <std::size_t D>
struct Cell_facts
{
  Cell_facts() {} // as of `Octet`
  static constexpr std::size_t layer_size = Corner_layout<D>::layer_bytes / byte_lanes;
  static constexpr std::size_t size = Corner_layout<D>::layers * layer_size;
  Byte_vector part[size];
};

struct Any
{
  HWY_INLINE Byte_vector operator()(const Byte_vector& a, const Byte_vector& b) const { return hn::Or(a, b); }
};
struct All
{
  HWY_INLINE Byte_vector operator()(const Byte_vector& a, const Byte_vector& b) const { return hn::And(a, b); }
};

/// The cells of which any corner, or all corners, have the property.
template <class Combine, std::size_t D>
HWY_INLINE Cell_facts<D> of_cells(const Corner_facts<D>& facts)
{
  using Layout = Corner_layout<D>;
  const Combine combine;
  const auto face = [&](std::size_t at) HWY_ATTR {
    const auto corner = [&](std::size_t step) HWY_ATTR { return hn::LoadU(Bytes(), facts.of_corner + at + step); };
    return combine(combine(corner(0), corner(1)), combine(corner(Layout::row_bytes), corner(Layout::row_bytes + 1)));
  };
  Cell_facts<D> cells;
  for (std::size_t p = 0; p < cells.layer_size; ++p) {
    auto last = face(p * byte_lanes);
    if constexpr (D == 2) cells.part[p] = last;
    for (std::size_t layer = 0; D == 3 && layer < Layout::layers; ++layer) {
      const auto next = face((layer + 1) * Layout::layer_step + p * byte_lanes);
      cells.part[layer * cells.layer_size + p] = combine(last, next);
      last = next;
    }
  }
  return cells;
}

template <std::size_t D>
HWY_INLINE Cell_facts<D> both(Cell_facts<D> a, const Cell_facts<D>& b)
{
  for (std::size_t p = 0; p < a.size; ++p) a.part[p] = hn::And(a.part[p], b.part[p]);
  return a;
}
template <std::size_t D>
HWY_INLINE Cell_facts<D> either(Cell_facts<D> a, const Cell_facts<D>& b)
{
  for (std::size_t p = 0; p < a.size; ++p) a.part[p] = hn::Or(a.part[p], b.part[p]);
  return a;
}

/// \brief `a` for the leaves in `chosen`, what is not in `b` for the others.
template <std::size_t D>
HWY_INLINE Cell_facts<D> chosen_or_not(unsigned chosen, Cell_facts<D> a, const Cell_facts<D>& b)
{
  const auto from_a = hn::Set(Bytes(), static_cast<std::uint8_t>(chosen));
  for (std::size_t p = 0; p < a.size; ++p)
    a.part[p] = hn::Or(hn::And(from_a, a.part[p]), hn::AndNot(hn::Or(from_a, b.part[p]), hn::Set(Bytes(), 0xff)));
  return a;
}

/// The same facts as `Leaf_words` of one leaf after the other.
template <std::size_t D>
class Facts_by_leaf
{
public:
  HWY_INLINE explicit Facts_by_leaf(const Cell_facts<D>& cells)
  {
    using Layout = Corner_layout<D>;
    alignas(64) std::uint8_t rows[Layout::layers * Layout::layer_bytes];
    for (std::size_t p = 0; p < cells.size; ++p) hn::StoreU(cells.part[p], Bytes(), rows + p * byte_lanes);
    constexpr std::size_t run = 8 / blocks; // cells of a row that are in one block
    for (std::size_t row = 0; row < 64 / run; ++row)
      for (std::size_t block = 0; block < blocks; ++block)
        std::memcpy(of_cell_ + 64 * block + run * row, rows + row * Layout::row_bytes + run * block, run);
  }

  [[nodiscard]] HWY_INLINE Leaf_words<D> operator[](std::size_t leaf) const
  {
    const auto bit = hn::Set(Bytes(), static_cast<std::uint8_t>(1U << leaf));
    Leaf_words<D> words{};
    for (std::size_t first = 0; first < 64 * blocks; first += byte_lanes) {
      std::uint64_t bits = 0;
      hn::StoreMaskBits(Bytes(), hn::TestBit(hn::LoadU(Bytes(), of_cell_ + first), bit),
                        reinterpret_cast<std::uint8_t*>(&bits));
      words[first / 64] |= bits << first % 64;
    }
    return words;
  }

private:
  static constexpr std::size_t blocks = Plan<D>::leaf_blocks;
  alignas(64) std::uint8_t of_cell_[64 * blocks];
};

} // namespace corral::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
