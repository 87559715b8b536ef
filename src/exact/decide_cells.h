// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_EXACT_DECIDE_CELLS_H
#define CORRAL_EXACT_DECIDE_CELLS_H

#include "Bernstein_form.h"

#include <corral/errors.h>
#include <corral/polynomial/integer_form.h>
#include <corral/polynomial/substitution.h>
#include <corral/verification/ideal_raster.h>

#include <cstddef>
#include <cstdint>

namespace corral::exact {

/// f in the grid's own coordinates, where each cell is a unit cube with integer corners, times a positive number.
template <std::size_t D>
[[nodiscard]] Polynomial<Integer, D> in_grid_coordinates(const Polynomial<Integer, D>& f, const Grid<D>& grid)
{
  std::array<Rational, D> offset;
  std::array<Rational, D> scale;
  for (std::size_t axis = 0; axis < D; ++axis) {
    offset[axis] = grid.box()[axis].lower();
    scale[axis] = grid.step(axis);
  }
  return integer_primitive(
      affine_substitution(transform<Rational>(f, [](const Integer& c) { return Rational(c); }), offset, scale));
}

/// The Bernstein form on one cell. \param form  power coefficients in grid coordinates.
template <std::size_t D>
[[nodiscard]] Bernstein_form<D> on_cell(Bernstein_form<D> form, const Cell<D>& cell)
{
  for (std::size_t axis = 0; axis < D; ++axis) shift_power_form(form, axis, cell[axis]);
  to_bernstein(form);
  return form;
}

/// \brief Decides the unknown cells of `candidates` and counts who decided what.
/// \param make_decider  gives, for a checkpoint, an object with `decide(cell)`.
template <std::size_t D, class Make_decider>
[[nodiscard]] Ideal_raster<D> decide_cells(const Cell_set<D>& candidates, const Ideal_raster_options& options,
                                           const Make_decider& make_decider)
{
  constexpr std::uint64_t cells_between_reports = 64;
  Ideal_raster<D> result;
  std::uint64_t done = candidates.hit();
  const std::uint64_t total = candidates.plotted();
  const Checkpoint checkpoint = [&] {
    if (options.progress && !options.progress(done, total)) throw Cancelled("exact decision: stopped on request");
  };
  auto decider = make_decider(checkpoint);
  bool stopped = false;
  const auto decide = [&](const Cell<D>& cell, Verdict known) -> Cell_decision<D> {
    if (known == Verdict::hit) return {Verdict::hit, Rung::floats, {}, {}};
    if (!stopped) try {
        if (done % cells_between_reports == 0) checkpoint();
        return decider.decide(cell);
      } catch (const Cancelled&) {
        stopped = true;
      }
    return {Verdict::unknown, Rung::floats, {}, "stopped on request before the cell was decided"};
  };
  candidates.for_each([&](const Cell<D>& cell, Verdict known) {
    const auto decision = decide(cell, known);
    if (known != Verdict::hit) ++done;
    const auto rung = static_cast<std::size_t>(decision.rung);
    if (decision.verdict == Verdict::empty) {
      ++result.rungs.empty[rung];
      return;
    }
    if (decision.verdict == Verdict::hit)
      ++result.rungs.hit[rung];
    else
      ++result.reasons[decision.reason];
    result.cells.append(cell, decision.verdict);
  });
  result.cells.finish();
  return result;
}

} // namespace corral::exact

#endif
