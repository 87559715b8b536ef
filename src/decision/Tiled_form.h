// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_DECISION_TILED_FORM_H
#define CORRAL_SRC_DECISION_TILED_FORM_H

#include "../algebra/Bernstein_form.h"

#include <corral/localization/Cell_block.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace corral::exact {

/// \brief A polynomial in the coordinates of the cell that was asked for last, exactly.
///
/// The origin moves to the block of the cell along all axes, then to the cell along one axis after the other. What a
/// cell has in common with the last one is not computed again.
template <std::size_t D>
class Tiled_form
{
public:
  /// \param power  in grid coordinates.
  explicit Tiled_form(Power_form<D> power) { moved_[0] = std::move(power); }

  /// The polynomial on a cell.
  [[nodiscard]] const Power_form<D>& on_cell(const Cell<D>& cell) { return moved_to(cell, 2 * D); }

  /// The polynomial on the block of a cell, in units of cells.
  [[nodiscard]] const Power_form<D>& on_block(const Cell<D>& cell) { return moved_to(cell, D); }

private:
  const Power_form<D>& moved_to(const Cell<D>& cell, std::size_t steps)
  {
    for (std::size_t step = 0; step < steps; ++step) {
      const std::size_t axis = step % D;
      const std::uint32_t in_tile = cell[axis] % block_side<D>;
      const std::uint32_t offset = step < D ? cell[axis] - in_tile : in_tile;
      if (step < made_ && offset == offset_[step]) continue;
      offset_[step] = offset;
      moved_[step + 1] = moved_[step];
      shift(moved_[step + 1], axis, offset);
      made_ = step + 1;
    }
    return moved_[steps];
  }

  std::array<Power_form<D>, 2 * D + 1> moved_;
  std::array<std::uint32_t, 2 * D> offset_{};
  std::size_t made_ = 0; ///< steps, the first ones, that fit the cell asked for last
};

} // namespace corral::exact

#endif
