// SPDX-License-Identifier: LGPL-3.0-or-later
#include "engine.h"

#include "paper_engine.h"

#include <corral/localization/localize.h>
#include <corral/number/all.h>

#include <optional>

namespace corral::program {

namespace {

template <std::size_t D>
Raster<D> fast(const std::vector<Polynomial<Rational, D>>& system, const Grid<D>& grid,
               const Localize_settings& settings)
{
  if constexpr (D == 2 || D == 3)
    return localize(system, grid, settings.run);
  else
    throw Invalid_input("engine fast: given " + detail::quantity(D, "dimension") + "; expected 2 or 3");
}

template <std::size_t D>
Raster<D> paper(const std::vector<Polynomial<Rational, D>>& system, const Grid<D>& grid, Localize_settings settings)
{
  if (settings.method.number == "counted") { // the name in the list of number types
    settings.method.number = Interval_traits<Outward_interval>::name;
    settings.count = true;
  }
  const Mpfr_precision_scope precision(settings.method.precision);
  std::optional<Raster<D>> answer;
  Number_types::visit(settings.method.number, [&](auto type) {
    using I = typename decltype(type)::type;
    if constexpr (!std::same_as<I, Counted<Outward_interval>>) answer = localize_over<I, D>(system, grid, settings);
  });
  return std::move(answer).value();
}

} // namespace

template <std::size_t D>
Raster<D> localize_by_name(const std::vector<Polynomial<Rational, D>>& system, const Grid<D>& grid,
                           const Localize_settings& settings)
{
  if (settings.engine != "fast" && settings.engine != "paper")
    throw Invalid_input("engine: given '" + settings.engine + "'; expected fast or paper");
  return settings.engine == "fast" ? fast<D>(system, grid, settings) : paper<D>(system, grid, settings);
}

#define CORRAL_INSTANTIATE(D)                                                                                          \
  template Raster<D> localize_by_name<D>(const std::vector<Polynomial<Rational, D>>&, const Grid<D>&,                  \
                                         const Localize_settings&);
CORRAL_INSTANTIATE(1)
CORRAL_INSTANTIATE(2)
CORRAL_INSTANTIATE(3)
CORRAL_INSTANTIATE(4)

} // namespace corral::program
