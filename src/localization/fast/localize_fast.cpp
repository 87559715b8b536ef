// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/localization/localize_fast.h>

#include "Runner.h"
#include "System_run.h"

#include <corral/errors.h>

#include <chrono>

namespace corral {
namespace {

template <std::size_t D>
void refuse_zero(const Polynomial<Rational, D>& f)
{
  if (f.is_zero()) throw Invalid_input("localize_fast: the polynomial is zero; expected one that is not");
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
  return timed(grid, [&] { return fast::localize_part(f, grid, options, true); });
}

template <std::size_t D>
Localization<D> localize_fast(const std::vector<Polynomial<Rational, D>>& system, const Grid<D>& grid,
                              const Fast_options& options)
{
  if (system.empty()) throw Invalid_input("localize_fast: the system is empty; expected at least one polynomial");
  for (const auto& f : system) refuse_zero(f);
  if (system.size() == 1) return localize_fast(system.front(), grid, options);
  return timed(grid, [&] { return fast::localize_system(system, grid, options, true); });
}

template Localization<2> localize_fast<2>(const Polynomial<Rational, 2>&, const Grid<2>&, const Fast_options&);
template Localization<3> localize_fast<3>(const Polynomial<Rational, 3>&, const Grid<3>&, const Fast_options&);
template Localization<2> localize_fast<2>(const std::vector<Polynomial<Rational, 2>>&, const Grid<2>&,
                                          const Fast_options&);
template Localization<3> localize_fast<3>(const std::vector<Polynomial<Rational, 3>>&, const Grid<3>&,
                                          const Fast_options&);

} // namespace corral
