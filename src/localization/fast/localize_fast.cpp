// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/localization/localize_fast.h>

#include "Search.h"
#include "Simplified.h"
#include "tasks.h"

#include <corral/errors.h>

#include <bit>
#include <chrono>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace corral {
namespace {

template <std::size_t D>
void refuse_zero(const Polynomial<Rational, D>& f)
{
  if (f.is_zero()) throw Invalid_input("localize_fast: the polynomial is zero; expected one that is not");
}

/// Whether an eighth of the plotted cells is open, so it seems from some blocks: as where a power changes no sign.
template <std::size_t D>
bool is_doubtful(const Cell_set<D>& cells)
{
  constexpr std::size_t most_looks = 32;
  int plotted = 0;
  int open = 0;
  const auto& blocks = cells.blocks();
  for (std::size_t k = 0; k < blocks.size(); k += 1 + blocks.size() / most_looks) {
    plotted += std::popcount(blocks[k].plotted);
    if (const auto rest = blocks[k].plotted & ~blocks[k].hit; rest != 0) open += std::popcount(rest);
  }
  return 8 * open > plotted;
}

/// The result, with its grid and the time since the start.
template <std::size_t D>
Localization<D> timed(Localization<D>&& result, const Grid<D>& grid, std::chrono::steady_clock::time_point start)
{
  result.cells.set_grid(grid);
  result.is_guaranteed = true;
  result.counters.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return std::move(result);
}

template <std::size_t D>
fast::Search<D> search_for(std::span<const Polynomial<Rational, D>> system, fast::Pulse& pulse,
                           const Fast_options& options)
{
  return {system, pulse, true, fast::thread_count(options.threads), options.cell_budget, {}};
}

/// Searches for the zeros of a polynomial, and for those of its square-free part instead where it has repeated factors
/// and that is seen to matter.
template <std::size_t D>
Localization<D> search_one(const Polynomial<Rational, D>& f, const Grid<D>& grid, const Fast_options& options)
{
  fast::Simplified<D> simplified(f);
  fast::Pulse pulse(options.progress);
  auto what = search_for<D>({&simplified.polynomial(), 1}, pulse, options);
  bool has_simpler = false;
  what.is_in_vain = [&] { return has_simpler = simplified.has_simpler(); };
  auto result = fast::search_all(what, grid);
  if (!has_simpler && is_doubtful(result.cells)) has_simpler = simplified.has_simpler();
  if (!has_simpler) return result;
  auto better = fast::search_all(search_for<D>({&simplified.polynomial(), 1}, pulse, options), grid);
  better.counters.bounds += result.counters.bounds;
  return better;
}

template <std::size_t D>
Localization<D> search_several(const std::vector<Polynomial<Rational, D>>& system, const Grid<D>& grid,
                               const Fast_options& options)
{
  std::vector<Polynomial<Rational, D>> simple;
  for (const auto& f : system) {
    fast::Simplified<D> simplified(f);
    (void)simplified.has_simpler();
    simple.push_back(simplified.polynomial());
  }
  fast::Pulse pulse(options.progress);
  return fast::search_all(search_for<D>(simple, pulse, options), grid);
}

} // namespace

template <std::size_t D>
Localization<D> localize_fast(const Polynomial<Rational, D>& f, const Grid<D>& grid, const Fast_options& options)
{
  const auto start = std::chrono::steady_clock::now();
  refuse_zero(f);
  return timed(search_one(f, grid, options), grid, start);
}

template <std::size_t D>
Localization<D> localize_fast(const std::vector<Polynomial<Rational, D>>& system, const Grid<D>& grid,
                              const Fast_options& options)
{
  const auto start = std::chrono::steady_clock::now();
  if (system.empty()) throw Invalid_input("localize_fast: the system is empty; expected at least one polynomial");
  for (const auto& f : system) refuse_zero(f);
  if (system.size() == 1) return localize_fast(system.front(), grid, options);
  return timed(search_several(system, grid, options), grid, start);
}

template Localization<2> localize_fast<2>(const Polynomial<Rational, 2>&, const Grid<2>&, const Fast_options&);
template Localization<3> localize_fast<3>(const Polynomial<Rational, 3>&, const Grid<3>&, const Fast_options&);
template Localization<2> localize_fast<2>(const std::vector<Polynomial<Rational, 2>>&, const Grid<2>&,
                                          const Fast_options&);
template Localization<3> localize_fast<3>(const std::vector<Polynomial<Rational, 3>>&, const Grid<3>&,
                                          const Fast_options&);

} // namespace corral
