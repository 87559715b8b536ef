// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_DECISION_RECHECK_H
#define CORRAL_SRC_DECISION_RECHECK_H

#include "decide_cells.h"
#include "exact_walk.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

/// \file
/// A raster against a second one that no float has touched.
namespace corral::exact {

/// The first cell of which two rasters say opposite things, and the number of such cells.
template <std::size_t D>
struct Disagreement
{
  Cell<D> cell{};
  Verdict claimed = Verdict::unknown;
  Verdict exact = Verdict::unknown;
  std::uint64_t cells = 0;

  void see(const Cell<D>& where, Verdict said, Verdict truth)
  {
    if (cells++ == 0 || where < cell) {
      cell = where;
      claimed = said;
      exact = truth;
    }
  }
};

/// Compares what both rasters have decided.
template <std::size_t D>
[[nodiscard]] Disagreement<D> compare(const Raster<D>& claimed, const Raster<D>& exact)
{
  Disagreement<D> result;
  exact.for_each_visited([&](const Cell<D>& cell, Verdict truth) {
    if (truth == Verdict::hit && claimed.verdict(cell) == Verdict::empty) result.see(cell, Verdict::empty, truth);
  });
  claimed.for_each_visited([&](const Cell<D>& cell, Verdict said) {
    if (said == Verdict::hit && exact.verdict(cell) == Verdict::empty) result.see(cell, said, Verdict::empty);
  });
  return result;
}

template <std::size_t D>
[[noreturn]] void complain(const Disagreement<D>& found)
{
  std::string index;
  for (const auto i : found.cell) index += (index.empty() ? "" : ", ") + std::to_string(i);
  throw Contradiction("recheck: cell (" + index + ") was called " + std::string(to_string(found.claimed)) + " and is "
                          + std::string(to_string(found.exact)) + " by exact arithmetic alone; "
                          + std::to_string(found.cells) + (found.cells == 1 ? " cell contradicts" : " cells contradict")
                          + ", so that a proof is wrong and no verdict of this run can be trusted",
                      {found.cell.begin(), found.cell.end()}, found.claimed, found.exact, found.cells);
}

/// \brief Decides every cell of the grid without floats, compares and notes the number of cells decided.
/// \param system  integer polynomials, none of them zero, with the zeros that were asked for.
/// \param make_decider  as for `decide_cells`; the decider uses no floats.
/// \throw Contradiction.
template <std::size_t D, class Make_decider>
void recheck(Ideal_raster<D>& ideal, const std::vector<Polynomial<Integer, D>>& system, const Run_options& run,
             const Ideal_raster_options& options, const Make_decider& make_decider)
{
  const auto& grid = ideal.raster.grid();
  const auto walked = Exact_walk<D>(system, grid, run).run();
  const auto exact = decide_cells(walked, run, {.patience = options.patience}, make_decider).raster;
  if (const auto found = compare(ideal.raster, exact); found.cells > 0) complain(found);
  double open = static_cast<double>(exact.unknown() - exact.unvisited_cells());
  for (const auto& range : exact.unvisited()) open += range.count();
  ideal.rechecked = grid.cell_count() - open;
}

} // namespace corral::exact

#endif
