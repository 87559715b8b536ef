// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/localization/localize_fast.h>

#include "Search.h"
#include "Simplified.h"
#include "tasks.h"

#include <corral/errors.h>

#include <chrono>

namespace corral {
namespace {

template <std::size_t D>
void refuse_zero(const Polynomial<Rational, D>& f)
{
  if (f.is_zero()) throw Invalid_input("localize_fast: the polynomial is zero; expected one that is not");
}

/// A power of a polynomial that is nowhere found to change its sign leaves cells open. A look costs little beside that.
template <std::size_t D>
bool is_doubtful(const Cell_set<D>& cells)
{
  const auto hit = cells.hit();
  return 8 * hit < 7 * cells.plotted();
}

template <std::size_t D, class Function>
Localization<D> timed(const Grid<D>& grid, const Function& function)
{
  const auto start = std::chrono::steady_clock::now();
  Localization<D> result = function();
  result.cells.set_grid(grid);
  result.is_guaranteed = true;
  result.counters.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

} // namespace

template <std::size_t D>
Localization<D> localize_fast(const Polynomial<Rational, D>& f, const Grid<D>& grid, const Fast_options& options)
{
  refuse_zero(f);
  return timed(grid, [&] {
    fast::Simplified<D> simplified(f);
    fast::Pulse pulse(options.progress);
    fast::Search<D> what{{&simplified.polynomial(), 1}, pulse};
    what.threads = fast::thread_count(options.threads);
    what.cell_budget = options.cell_budget;
    bool has_simpler = false;
    what.is_in_vain = [&] { return has_simpler = simplified.has_simpler(); };
    auto result = fast::search_all(what, grid);
    if (!has_simpler && is_doubtful(result.cells)) has_simpler = simplified.has_simpler();
    if (!has_simpler) return result;
    what.system = {&simplified.polynomial(), 1};
    what.is_in_vain = {};
    auto better = fast::search_all(what, grid);
    better.counters.bounds += result.counters.bounds;
    return better;
  });
}

template <std::size_t D>
Localization<D> localize_fast(const std::vector<Polynomial<Rational, D>>& system, const Grid<D>& grid,
                              const Fast_options& options)
{
  if (system.empty()) throw Invalid_input("localize_fast: the system is empty; expected at least one polynomial");
  for (const auto& f : system) refuse_zero(f);
  if (system.size() == 1) return localize_fast(system.front(), grid, options);
  return timed(grid, [&] {
    std::vector<Polynomial<Rational, D>> simple;
    for (const auto& f : system) {
      fast::Simplified<D> simplified(f);
      (void)simplified.has_simpler();
      simple.push_back(simplified.polynomial());
    }
    fast::Pulse pulse(options.progress);
    return fast::search_all<D>({simple, pulse, true, fast::thread_count(options.threads), options.cell_budget, {}},
                               grid);
  });
}

template Localization<2> localize_fast<2>(const Polynomial<Rational, 2>&, const Grid<2>&, const Fast_options&);
template Localization<3> localize_fast<3>(const Polynomial<Rational, 3>&, const Grid<3>&, const Fast_options&);
template Localization<2> localize_fast<2>(const std::vector<Polynomial<Rational, 2>>&, const Grid<2>&,
                                          const Fast_options&);
template Localization<3> localize_fast<3>(const std::vector<Polynomial<Rational, 3>>&, const Grid<3>&,
                                          const Fast_options&);

} // namespace corral
