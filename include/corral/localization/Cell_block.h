// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_LOCALIZATION_CELL_BLOCK_H
#define CORRAL_LOCALIZATION_CELL_BLOCK_H

#include <corral/localization/Grid.h>
#include <corral/localization/Verdict.h>

#include <array>
#include <cstddef>
#include <cstdint>

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

/// The block of a cell.
template <std::size_t D>
[[nodiscard]] constexpr std::array<std::uint32_t, D> block_of(const Cell<D>& cell)
{
  std::array<std::uint32_t, D> index{};
  for (std::size_t axis = 0; axis < D; ++axis) index[axis] = cell[axis] / block_side<D>;
  return index;
}

/// The verdict of one cell of a block.
template <std::size_t D>
[[nodiscard]] constexpr Verdict verdict_of(const Cell_block<D>& block, unsigned bit)
{
  if ((block.plotted >> bit & 1) == 0) return Verdict::empty;
  return (block.hit >> bit & 1) != 0 ? Verdict::hit : Verdict::unknown;
}

} // namespace corral

#endif
