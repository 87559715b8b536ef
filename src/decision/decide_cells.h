// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_DECISION_DECIDE_CELLS_H
#define CORRAL_SRC_DECISION_DECIDE_CELLS_H

#include "../algebra/Bernstein_form.h"
#include "Cell_crew.h"

#include <corral/decision/Ideal_result.h>
#include <corral/errors.h>
#include <corral/internal/polynomial/integer_form.h>
#include <corral/localization/Raster_builder.h>
#include <corral/polynomial/substitution.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace corral::exact {

/// \brief f in the grid's own coordinates, where each cell is a unit cube with integer corners, times a positive
/// number. \throw Budget_exceeded if that has too many coefficients, or if they might fill half a gigabyte.
template <std::size_t D>
[[nodiscard]] Polynomial<Integer, D> in_grid_coordinates(const Polynomial<Integer, D>& f, const Grid<D>& grid)
{
  constexpr double max_bits = 0x1p32;
  const auto bits = [](const Integer& x) { return static_cast<double>(mpz_sizeinbase(x.get_mpz_t(), 2)); };
  std::array<Rational, D> offset;
  std::array<Rational, D> scale;
  double bits_of_one = 0; // coefficient, by what its powers add
  for (std::size_t axis = 0; axis < D; ++axis) {
    offset[axis] = grid.box()[axis].lower();
    scale[axis] = grid.step(axis);
    bits_of_one +=
        f.degree(axis)
        * (std::max(bits(offset[axis].get_num()), bits(scale[axis].get_num())) + bits(scale[axis].get_den()));
  }
  if (const std::size_t count = dense_size(f); static_cast<double>(count) * bits_of_one > max_bits)
    throw Budget_exceeded("exact decision: a polynomial has " + std::to_string(count)
                          + " coefficients, zeros included, of some " + std::to_string(std::lround(bits_of_one))
                          + " bits on the grid; expected less than half a gigabyte");
  return integer_primitive(
      affine_substitution(transform<Rational>(f, [](const Integer& c) { return Rational(c); }), offset, scale));
}

/// The Bernstein form on one cell. \param form  in grid coordinates.
template <std::size_t D>
[[nodiscard]] Bernstein_form<D> on_cell(Power_form<D> form, const Cell<D>& cell)
{
  for (std::size_t axis = 0; axis < D; ++axis) shift(form, axis, cell[axis]);
  return to_bernstein(std::move(form));
}

/// \brief Writes down decisions: who decided what, why not, and for each cell if that is asked for.
template <std::size_t D>
void record(Ideal_raster<D>& result, Raster_builder<D>& cells, const Cell<D>& cell, const Cell_decision<D>& decision,
            bool keep)
{
  const auto rung = static_cast<std::size_t>(decision.rung);
  if (decision.verdict == Verdict::empty) {
    ++result.rungs.empty[rung];
    return;
  }
  if (decision.verdict == Verdict::hit)
    ++result.rungs.hit[rung];
  else
    ++result.reasons[decision.reason];
  cells.append(cell, decision.verdict);
  if (keep) result.decided.push_back({cell, decision.rung, decision.reason});
}

/// \throw Invalid_input if the cells that the raster calls empty may hold zeros.
template <std::size_t D>
void require_guaranteed(const Raster<D>& candidates)
{
  if (!candidates.is_guaranteed())
    throw Invalid_input(
        "ideal raster: given a raster that is not guaranteed; expected one over a guaranteed number type");
}

/// Writes down the cells that were not visited, so that they are not decided.
template <std::size_t D>
void record_unvisited(Ideal_raster<D>& result, Raster_builder<D>& cells, const Raster<D>& candidates, bool keep)
{
  const std::string reason = "stopped on request before the cell was visited";
  for (const auto& range : candidates.unvisited()) {
    cells.leave(range);
    Cell<D> cell = range.first;
    if (keep) do
        result.decided.push_back({cell, Rung::floats, reason});
      while (range.advance(cell));
  }
  if (const auto count = candidates.unvisited_cells(); count > 0) result.reasons[reason] = count;
}

/// Decides the unknown cells of `candidates`, a batch at a time so that memory does not grow with their number.
template <std::size_t D, class Make_decider>
[[nodiscard]] Ideal_raster<D> decide_cells(const Raster<D>& candidates, const Run_options& run,
                                           const Ideal_raster_options& options, const Make_decider& make_decider)
{
  constexpr std::size_t batch_size = 1 << 14;
  Ideal_raster<D> result{candidates};
  Raster_builder<D> cells;
  Cell_crew<D, Make_decider> crew(make_decider, run, options, candidates.hit(),
                                  candidates.plotted() - candidates.unvisited_cells());
  crew.report();
  std::vector<Plotted_cell<D>> batch;
  const auto flush = [&] {
    std::vector<Cell<D>> open;
    for (const auto& [cell, known] : batch)
      if (known != Verdict::hit) open.push_back(cell);
    const auto decisions = crew.decide(open);
    auto decision = decisions.begin();
    for (const auto& [cell, known] : batch)
      record(result, cells, cell,
             known == Verdict::hit ? Cell_decision<D>{Verdict::hit, Rung::floats, {}, {}} : *decision++,
             options.keep_rungs);
    batch.clear();
  };
  const auto decide_or_wait = [&](const Cell<D>& cell, Verdict known) {
    batch.push_back({cell, known});
    if (batch.size() == batch_size) flush();
  };
  candidates.for_each_visited(decide_or_wait);
  flush();
  record_unvisited(result, cells, candidates, options.keep_rungs);
  if (crew.is_stopped()) cells.stop();
  result.raster = std::move(cells).finish(candidates.grid(), true, candidates.counters());
  std::sort(result.decided.begin(), result.decided.end(), [](const auto& a, const auto& b) { return a.cell < b.cell; });
  return result;
}

} // namespace corral::exact

#endif
