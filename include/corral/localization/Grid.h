// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_LOCALIZATION_GRID_H
#define CORRAL_LOCALIZATION_GRID_H

#include <corral/errors.h>
#include <corral/polynomial/Box.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

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

  /// \brief The same box, cut into `cells` along each axis: `Grid({{-2, 2}, {-1, 1}}, 64)` is a `Grid<2>`.
  /// \throw as above.
  Grid(const Rational_interval (&box)[D], std::uint32_t cells) : Grid(std::to_array(box), uniform(cells)) {}
  /// The same with a number of cells for each axis: `Grid({{-2, 2}, {-1, 1}}, {64, 32})`.
  Grid(const Rational_interval (&box)[D], const std::uint32_t (&cells)[D])
      : Grid(std::to_array(box), std::to_array(cells))
  {}

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

  /// The closed cells that contain a point, in order: one to 2^D, none if it lies outside the box.
  [[nodiscard]] std::vector<Cell<D>> cells_at(const Rational_point<D>& point) const
  {
    Cell<D> first{};
    Cell<D> last{};
    for (std::size_t axis = 0; axis < D; ++axis) {
      const Rational place = (point[axis] - box_[axis].lower()) / step_[axis];
      if (sgn(place) < 0 || place > resolution_[axis]) return {};
      const auto floor = static_cast<std::uint32_t>(Integer(place.get_num() / place.get_den()).get_ui());
      const bool is_line = place.get_num() % place.get_den() == 0;
      first[axis] = floor > 0 && is_line ? floor - 1 : floor;
      last[axis] = std::min(floor, resolution_[axis] - 1);
    }
    return cells_between(first, last);
  }

  /// The cells that share a point with this one, in order: at most 3^D - 1. \throw Invalid_input unless it is one of
  /// the grid.
  [[nodiscard]] std::vector<Cell<D>> neighbours(const Cell<D>& cell) const
  {
    require(cell, "grid");
    Cell<D> first = cell;
    Cell<D> last = cell;
    for (std::size_t axis = 0; axis < D; ++axis) {
      first[axis] -= cell[axis] > 0 ? 1 : 0;
      last[axis] += cell[axis] + 1 < resolution_[axis] ? 1 : 0;
    }
    auto cells = cells_between(first, last);
    cells.erase(std::find(cells.begin(), cells.end(), cell));
    return cells;
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
  static Resolution<D> uniform(std::uint32_t cells)
  {
    Resolution<D> resolution;
    resolution.fill(cells);
    return resolution;
  }

  /// In lexicographic order, both ends included.
  static std::vector<Cell<D>> cells_between(const Cell<D>& first, const Cell<D>& last)
  {
    std::vector<Cell<D>> cells{first};
    for (std::size_t axis = D; axis > 0;) {
      Cell<D> next = cells.back();
      for (axis = D; axis > 0 && next[axis - 1] == last[axis - 1]; --axis) next[axis - 1] = first[axis - 1];
      if (axis == 0) break;
      ++next[axis - 1];
      cells.push_back(next);
    }
    return cells;
  }

  Rational_box<D> box_;
  Resolution<D> resolution_;
  std::array<Rational, D> step_;
};

} // namespace corral

#endif
