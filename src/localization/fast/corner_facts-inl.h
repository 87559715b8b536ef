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
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace corral::fast::HWY_NAMESPACE {

/// One word for each block of a leaf, with the bits of `Cell_block`.
template <std::size_t D>
using Leaf_words = std::array<std::uint64_t, Plan<D>::leaf_blocks>;

template <std::size_t words>
HWY_INLINE std::array<std::uint64_t, words> both(std::array<std::uint64_t, words> a,
                                                 const std::array<std::uint64_t, words>& b)
{
  for (std::size_t w = 0; w < words; ++w) a[w] &= b[w];
  return a;
}
template <std::size_t words>
HWY_INLINE std::array<std::uint64_t, words> either(std::array<std::uint64_t, words> a,
                                                   const std::array<std::uint64_t, words>& b)
{
  for (std::size_t w = 0; w < words; ++w) a[w] |= b[w];
  return a;
}

template <std::size_t words>
HWY_INLINE std::array<std::uint64_t, words> without(std::array<std::uint64_t, words> a,
                                                    const std::array<std::uint64_t, words>& b)
{
  for (std::size_t w = 0; w < words; ++w) a[w] &= ~b[w];
  return a;
}
template <std::size_t words>
HWY_INLINE std::array<std::uint64_t, words> complement(std::array<std::uint64_t, words> a)
{
  for (auto& word : a) word = ~word;
  return a;
}

/// \brief Which corners of a leaf have some property.
///
/// One byte a row, with one bit for each of the first eight corners along the last axis; the ninth are in `end`, one
/// bit a row. In space there is one word for each grid line of axis 0, with a row for each of axis 1; in the plane the
/// second word holds the ninth row.
template <std::size_t D>
struct Corner_facts
{
  static constexpr std::size_t layers = D == 2 ? 2 : block_side<D> + 1;
  std::uint64_t layer[layers] = {};
  std::uint64_t end[layers] = {};
};

/// Facts on the cells of a leaf: bytes like those of the corners, eight rows a word.
template <std::size_t D>
using Cell_facts = std::array<std::uint64_t, D - 1>;

/// Bit k goes to the highest bit of byte k.
HWY_INLINE std::uint64_t spread(std::uint64_t bits)
{
  constexpr std::uint64_t shifts = 0x810204080; // by 7, 14, 21, 28, 35: no two of the bits meet
  constexpr std::uint64_t high = 0x8080808080;
  return ((bits & 0x1f) * shifts & high) | (((bits >> 5) * shifts & high) << 40);
}

/// For each corner the fact on the next along its row.
template <std::size_t D>
HWY_INLINE Corner_facts<D> next_along_rows(const Corner_facts<D>& facts)
{
  Corner_facts<D> next;
  for (std::size_t x = 0; x < facts.layers; ++x)
    next.layer[x] = (facts.layer[x] >> 1 & 0x7f7f7f7f7f7f7f7fU) | spread(facts.end[x]);
  return next;
}

/// Combines the facts on the corners of each cell. \param next  what `next_along_rows` gives.
template <class Combine>
HWY_INLINE Cell_facts<2> combined(const Corner_facts<2>& facts, const Corner_facts<2>& next, const Combine& combine)
{
  const std::uint64_t rows = combine(facts.layer[0], next.layer[0]);
  const std::uint64_t last = combine(facts.layer[1], next.layer[1]);
  return {combine(rows, rows >> 8 | last << 56)};
}
template <class Combine>
HWY_INLINE Cell_facts<3> combined(const Corner_facts<3>& facts, const Corner_facts<3>& next, const Combine& combine)
{
  std::uint64_t rows[Corner_facts<3>::layers];
  for (std::size_t x = 0; x < facts.layers; ++x) {
    const std::uint64_t five = combine(facts.layer[x], next.layer[x]);
    rows[x] = combine(five, five >> 8);
  }
  const auto cells = [&](std::size_t x) { return combine(rows[x], rows[x + 1]) & 0xffffffffU; };
  return {cells(0) | cells(1) << 32, cells(2) | cells(3) << 32};
}

template <std::size_t D>
HWY_INLINE Cell_facts<D> with_any(const Corner_facts<D>& facts, const Corner_facts<D>& next)
{
  return combined(facts, next, [](std::uint64_t a, std::uint64_t b) { return a | b; });
}
template <std::size_t D>
HWY_INLINE Cell_facts<D> with_all(const Corner_facts<D>& facts, const Corner_facts<D>& next)
{
  return combined(facts, next, [](std::uint64_t a, std::uint64_t b) { return a & b; });
}
/// The cells with at least one corner that has the property, and those whose corners all have it.
template <std::size_t D>
HWY_INLINE Cell_facts<D> with_any(const Corner_facts<D>& facts)
{
  return with_any(facts, next_along_rows(facts));
}
template <std::size_t D>
HWY_INLINE Cell_facts<D> with_all(const Corner_facts<D>& facts)
{
  return with_all(facts, next_along_rows(facts));
}

/// The lower half of each byte, side by side.
HWY_INLINE std::uint64_t lower_halves(std::uint64_t bytes)
{
  bytes &= 0x0f0f0f0f0f0f0f0fU;
  bytes = (bytes | bytes >> 4) & 0x00ff00ff00ff00ffU;
  bytes = (bytes | bytes >> 8) & 0x0000ffff0000ffffU;
  return (bytes | bytes >> 16) & 0xffffffffU;
}

/// The same bits, ordered as in `Cell_block`.
HWY_INLINE Leaf_words<2> in_blocks(const Cell_facts<2>& cells) { return cells; }
HWY_INLINE Leaf_words<3> in_blocks(const Cell_facts<3>& cells)
{
  return {lower_halves(cells[0]) | lower_halves(cells[1]) << 32,
          lower_halves(cells[0] >> 4) | lower_halves(cells[1] >> 4) << 32};
}

} // namespace corral::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
