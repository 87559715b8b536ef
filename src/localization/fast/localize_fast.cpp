// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/localization/localize.h>

#include "Search.h"
#include "Simplified.h"
#include "tasks.h"

#include <corral/errors.h>

#include <bit>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace corral {
namespace {

template <std::size_t D>
void refuse_zero(const Polynomial<Rational, D>& f)
{
  if (f.is_zero()) throw Invalid_input("localize: the polynomial is zero; expected one that is not");
}

/// Whether an eighth of the plotted cells is open, so it seems from some blocks: as where a power changes no sign.
template <std::size_t D>
bool is_doubtful(const std::vector<Cell_block<D>>& blocks)
{
  constexpr std::size_t most_looks = 32;
  int plotted = 0;
  int open = 0;
  for (std::size_t k = 0; k < blocks.size(); k += 1 + blocks.size() / most_looks) {
    plotted += std::popcount(blocks[k].plotted);
    if (const auto rest = blocks[k].plotted & ~blocks[k].hit; rest != 0) open += std::popcount(rest);
  }
  return 8 * open > plotted;
}

/// The raster of what was found, with the time since the start.
template <std::size_t D>
Raster<D> raster_of(fast::Found<D>&& found, const Grid<D>& grid, std::chrono::steady_clock::time_point start)
{
  for (const auto& part : found.left) found.cells.leave(fast::range_of(part));
  Work_counters counters;
  counters.bounds = found.nodes;
  counters.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return std::move(found.cells).finish(grid, true, counters);
}

template <std::size_t D>
fast::Search<D> search_for(std::span<const Polynomial<Rational, D>> system, fast::Pulse& pulse, const Run_options& run)
{
  constexpr auto no_budget = std::numeric_limits<std::uint64_t>::max();
  return {system, pulse, true, fast::thread_count(run.threads), run.cell_budget.value_or(no_budget), {}};
}

/// Searches for the zeros of a polynomial, and for those of its square-free part instead where it has repeated factors
/// and that is seen to matter.
template <std::size_t D>
fast::Found<D> search_one(const Polynomial<Rational, D>& f, const Grid<D>& grid, const Run_options& run)
{
  fast::Simplified<D> simplified(f);
  fast::Pulse pulse(run);
  auto what = search_for<D>({&simplified.polynomial(), 1}, pulse, run);
  bool has_simpler = false;
  what.is_in_vain = [&] { return has_simpler = simplified.has_simpler(); };
  auto found = fast::search_all(what, grid);
  if (!has_simpler && !pulse.is_stopped() && is_doubtful<D>(found.cells.blocks()))
    has_simpler = simplified.has_simpler();
  if (!has_simpler || (pulse.is_stopped() && !found.was_in_vain)) return found;
  auto better = fast::search_all(search_for<D>({&simplified.polynomial(), 1}, pulse, run), grid);
  better.nodes += found.nodes;
  return better;
}

template <std::size_t D>
fast::Found<D> search_several(const std::vector<Polynomial<Rational, D>>& system, const Grid<D>& grid,
                              const Run_options& run)
{
  std::vector<Polynomial<Rational, D>> simple;
  for (const auto& f : system) {
    fast::Simplified<D> simplified(f);
    (void)simplified.has_simpler();
    simple.push_back(simplified.polynomial());
  }
  fast::Pulse pulse(run);
  return fast::search_all(search_for<D>(simple, pulse, run), grid);
}

} // namespace

template <std::size_t D>
Raster<D> localize(const Polynomial<Rational, D>& f, const Grid<D>& grid, const Run_options& run)
{
  const auto start = std::chrono::steady_clock::now();
  refuse_zero(f);
  return raster_of(search_one(f, grid, run), grid, start);
}

template <std::size_t D>
Raster<D> localize(const std::vector<Polynomial<Rational, D>>& system, const Grid<D>& grid, const Run_options& run)
{
  const auto start = std::chrono::steady_clock::now();
  if (system.empty()) throw Invalid_input("localize: the system is empty; expected at least one polynomial");
  for (const auto& f : system) refuse_zero(f);
  if (system.size() == 1) return localize(system.front(), grid, run);
  return raster_of(search_several(system, grid, run), grid, start);
}

template Raster<2> localize<2>(const Polynomial<Rational, 2>&, const Grid<2>&, const Run_options&);
template Raster<3> localize<3>(const Polynomial<Rational, 3>&, const Grid<3>&, const Run_options&);
template Raster<2> localize<2>(const std::vector<Polynomial<Rational, 2>>&, const Grid<2>&, const Run_options&);
template Raster<3> localize<3>(const std::vector<Polynomial<Rational, 3>>&, const Grid<3>&, const Run_options&);

} // namespace corral
