// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_EXACT_TILED_FORM_H
#define CORRAL_EXACT_TILED_FORM_H

#include "Bernstein_form.h"
#include "Interval_rung.h"

#include <corral/localization/Cell_set.h>
#include <corral/number/Mpfr_interval.h>
#include <corral/number/Outward_interval.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>

namespace corral::exact {

/// \brief A polynomial in the coordinates of the block of cells that was asked for last.
///
/// Cells are asked for block by block. Moving the origin to the block once, exactly, makes the numbers of all its cells
/// small and leaves intervals the precision that the origin of the grid would cost them.
template <std::size_t D>
class Tiled_form
{
public:
  /// \param power  power coefficients in grid coordinates.
  explicit Tiled_form(Bernstein_form<D> power) : power_(std::move(power)) {}

  /// The verdict of interval arithmetic on a cell, or nothing.
  [[nodiscard]] std::optional<Cell_decision<D>> decide_by_intervals(const Grid<D>& grid, const Cell<D>& cell)
  {
    const Cell<D> in_tile = move_to(cell);
    if (auto decision = doubles_->decide(grid, cell, in_tile, Rung::intervals)) return decision;
    return mpfr_ ? mpfr_->decide(grid, cell, in_tile, Rung::mpfr) : std::nullopt;
  }

  /// The Bernstein form on a cell.
  [[nodiscard]] Bernstein_form<D> on_cell(const Cell<D>& cell)
  {
    const Cell<D> in_tile = move_to(cell);
    Bernstein_form<D> form = moved_[D - 1];
    for (std::size_t axis = 0; axis < D; ++axis) shift_power_form(form, axis, in_tile[axis]);
    to_bernstein(form);
    return form;
  }

private:
  /// Moves the origin to the block of the cell; returns the cell from there.
  Cell<D> move_to(const Cell<D>& cell)
  {
    bool moves = !doubles_;
    Cell<D> in_tile;
    for (std::size_t axis = 0; axis < D; ++axis) {
      in_tile[axis] = cell[axis] % block_side<D>;
      const std::uint32_t origin = cell[axis] - in_tile[axis];
      if (!moves && origin == origin_[axis]) continue;
      moves = true;
      origin_[axis] = origin;
      moved_[axis] = axis == 0 ? power_ : moved_[axis - 1];
      shift_power_form(moved_[axis], axis, origin);
    }
    if (moves) {
      const auto& form = moved_[D - 1];
      doubles_.emplace(form);
      mpfr_.reset();
      if (std::any_of(form.values.begin(), form.values.end(), is_wide)) mpfr_.emplace(form);
    }
    return in_tile;
  }

  /// Whether MPFR is so much faster than the integer that trying it pays.
  static bool is_wide(const Integer& c) { return mpz_sizeinbase(c.get_mpz_t(), 2) > 1024; }

  Bernstein_form<D> power_;
  Cell<D> origin_{};
  std::array<Bernstein_form<D>, D> moved_; ///< [k]: moved along the axes 0 to k
  std::optional<Interval_rung<Outward_interval, D>> doubles_;
  std::optional<Interval_rung<Mpfr_interval, D>> mpfr_;
};

} // namespace corral::exact

#endif
