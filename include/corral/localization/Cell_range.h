// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_LOCALIZATION_CELL_RANGE_H
#define CORRAL_LOCALIZATION_CELL_RANGE_H

#include <corral/localization/Grid.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace corral {

/// The cells [first, end) of each axis.
template <std::size_t D>
struct Cell_range
{
  Cell<D> first{};
  Cell<D> end{};

  [[nodiscard]] bool contains(const Cell<D>& cell) const
  {
    for (std::size_t k = 0; k < D; ++k)
      if (cell[k] < first[k] || cell[k] >= end[k]) return false;
    return true;
  }
  [[nodiscard]] bool is_empty() const
  {
    for (std::size_t k = 0; k < D; ++k)
      if (first[k] >= end[k]) return true;
    return false;
  }
  /// The number of cells; exact up to 2^53, then rounded.
  [[nodiscard]] double count() const
  {
    double product = 1;
    for (std::size_t k = 0; k < D; ++k) product *= end[k] - first[k];
    return product;
  }
  /// The same; 2^64 - 1 if there are more.
  [[nodiscard]] std::uint64_t size() const
  {
    constexpr auto most = std::numeric_limits<std::uint64_t>::max();
    std::uint64_t product = 1;
    for (std::size_t k = 0; k < D; ++k) {
      const std::uint64_t width = end[k] - first[k];
      if (width != 0 && product > most / width) return most;
      product *= width;
    }
    return product;
  }
  /// Whether some cell lies in both.
  [[nodiscard]] bool meets(const Cell_range& other) const
  {
    for (std::size_t k = 0; k < D; ++k)
      if (first[k] >= other.end[k] || other.first[k] >= end[k]) return false;
    return true;
  }
  /// The part whose index along axis 0 lies in [from, to).
  [[nodiscard]] Cell_range between(std::uint32_t from, std::uint32_t to) const
  {
    Cell_range part = *this;
    part.first[0] = std::max(first[0], from);
    part.end[0] = std::min(end[0], to);
    return part;
  }
  /// Makes the cell the next one in lexicographic order, or the first one and returns false if it is the last.
  [[nodiscard]] bool advance(Cell<D>& cell) const
  {
    for (std::size_t k = D; k-- > 0;) {
      if (++cell[k] < end[k]) return true;
      cell[k] = first[k];
    }
    return false;
  }
  friend bool operator==(const Cell_range&, const Cell_range&) = default;
};

} // namespace corral

#endif
