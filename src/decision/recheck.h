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

/// Compares what both rasters have decided. \param left  parts of the grid of which `exact` knows nothing.
template <std::size_t D>
[[nodiscard]] Disagreement<D> compare(const Cell_set<D>& claimed, const Cell_set<D>& exact,
                                      const std::vector<Cell_range<D>>& left)
{
  Disagreement<D> result;
  exact.for_each([&](const Cell<D>& cell, Verdict truth) {
    if (truth == Verdict::hit && claimed.at(cell) == Verdict::empty) result.see(cell, Verdict::empty, truth);
  });
  claimed.for_each([&](const Cell<D>& cell, Verdict said) {
    if (said != Verdict::hit || exact.at(cell) != Verdict::empty) return;
    if (std::none_of(left.begin(), left.end(), [&](const auto& range) { return range.contains(cell); }))
      result.see(cell, said, Verdict::empty);
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

/// \brief Decides every cell of the grid without floats and compares.
/// \param system  integer polynomials, none of them zero, with the zeros that were asked for.
/// \param make_decider  as for `decide_cells`; the decider uses no floats.
/// \return the number of cells decided a second time. \throw Contradiction.
template <std::size_t D, class Make_decider>
[[nodiscard]] double recheck(const Ideal_raster<D>& raster, const std::vector<Polynomial<Integer, D>>& system,
                             const Grid<D>& grid, const Ideal_raster_options& options, const Make_decider& make_decider)
{
  constexpr double most = 0x1p62; // that the callback can be told
  const double all = grid.cell_count();
  const double unit = std::max(1.0, all / most);
  bool stopped = false;
  const auto told = [&](double done) { return static_cast<std::uint64_t>(done / unit); };
  const auto walked = Exact_walk<D>(system, grid, [&](double settled) {
                        stopped = stopped || (options.progress && !options.progress(told(settled), told(all)));
                        return !stopped;
                      }).run();
  Ideal_raster_options again;
  again.threads = options.threads;
  again.patience = options.patience;
  again.progress = [&](std::uint64_t done, std::uint64_t total) {
    stopped = stopped || (options.progress && !options.progress(done, total));
    return !stopped;
  };
  const auto exact = decide_cells(walked.cells, again, make_decider);
  if (const auto found = compare(raster.cells, exact.cells, walked.left); found.cells > 0) complain(found);
  double open = static_cast<double>(exact.cells.unknown());
  for (const auto& range : walked.left) open += range.count();
  return all - open;
}

} // namespace corral::exact

#endif
