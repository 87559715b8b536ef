// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_LOCALIZATION_GRID_H
#define CORRAL_LOCALIZATION_GRID_H

#include <corral/errors.h>
#include <corral/polynomial/Box.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace corral {

/// The integer index of one cell, axis 0 (x) first.
template <std::size_t D>
using Cell = std::array<std::uint32_t, D>;

/// The number of cells along each axis.
template <std::size_t D>
using Resolution = std::array<std::uint32_t, D>;

/// \brief A box with rational corners, cut into equal closed cells.
///
/// Neighbouring cells share their common facet. Cell i of an axis spans
/// [lower + i*w, lower + (i+1)*w] with w = (upper - lower) / resolution, exactly.
template <std::size_t D>
class Grid
{
public:
  /// The largest resolution of one axis.
  static constexpr std::uint32_t max_resolution = std::uint32_t{1} << 30;

  /// \throw Invalid_input if a side of the box is empty or a point, or a resolution is 0 or above `max_resolution`.
  Grid(Rational_box<D> box, const Resolution<D>& resolution) : box_(std::move(box)), resolution_(resolution)
  {
    for (std::size_t axis = 0; axis < D; ++axis) {
      const auto& side = box_[axis];
      if (side.lower() >= side.upper())
        throw Invalid_input("grid: side " + std::to_string(axis + 1) + " of the box is [" + to_string(side.lower())
                            + ", " + to_string(side.upper()) + "]; expected lower < upper");
      if (resolution_[axis] == 0 || resolution_[axis] > max_resolution)
        throw Invalid_input("grid: the resolution along side " + std::to_string(axis + 1) + " is "
                            + std::to_string(resolution_[axis]) + "; expected 1 to " + std::to_string(max_resolution));
      step_[axis] = (side.upper() - side.lower()) / resolution_[axis];
    }
  }

  [[nodiscard]] const Rational_box<D>& box() const { return box_; }
  [[nodiscard]] const Resolution<D>& resolution() const { return resolution_; }

  /// The width of one cell along `axis`.
  [[nodiscard]] const Rational& step(std::size_t axis) const { return step_[axis]; }

  /// Whether the cell is one of the grid.
  [[nodiscard]] bool contains(const Cell<D>& cell) const
  {
    for (std::size_t axis = 0; axis < D; ++axis)
      if (cell[axis] >= resolution_[axis]) return false;
    return true;
  }

  /// \throw Invalid_input in the name of `who` unless the cell is one of the grid.
  void require(const Cell<D>& cell, const char* who) const
  {
    if (contains(cell)) return;
    std::string given;
    std::string size;
    for (std::size_t axis = 0; axis < D; ++axis) {
      given += (axis == 0 ? "" : ", ") + std::to_string(cell[axis]);
      size += (axis == 0 ? "" : " x ") + std::to_string(resolution_[axis]);
    }
    throw Invalid_input(std::string(who) + ": given the cell (" + given + "); expected one of a grid of " + size);
  }

  /// The coordinate of grid line `index` (0 to the resolution) of `axis`.
  [[nodiscard]] Rational line(std::size_t axis, std::uint32_t index) const
  {
    return box_[axis].lower() + step_[axis] * index;
  }

  /// The closed cell as a box.
  [[nodiscard]] Rational_box<D> cell_box(const Cell<D>& cell) const
  {
    Rational_box<D> result;
    for (std::size_t axis = 0; axis < D; ++axis)
      result[axis] = Rational_interval(line(axis, cell[axis]), line(axis, cell[axis] + 1));
    return result;
  }

  /// The number of cells; exact up to 2^53, then rounded.
  [[nodiscard]] double cell_count() const
  {
    double count = 1;
    for (const auto n : resolution_) count *= n;
    return count;
  }

  /// Whether both are the same box, cut alike.
  friend bool operator==(const Grid& a, const Grid& b)
  {
    for (std::size_t axis = 0; axis < D; ++axis)
      if (a.box_[axis].lower() != b.box_[axis].lower() || a.box_[axis].upper() != b.box_[axis].upper()) return false;
    return a.resolution_ == b.resolution_;
  }

private:
  Rational_box<D> box_;
  Resolution<D> resolution_;
  std::array<Rational, D> step_;
};

} // namespace corral

#endif
