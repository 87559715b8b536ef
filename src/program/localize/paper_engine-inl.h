// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_PROGRAM_LOCALIZE_PAPER_ENGINE_INL_H
#define CORRAL_SRC_PROGRAM_LOCALIZE_PAPER_ENGINE_INL_H

#include "../bound/make_bounder.h"
#include "paper_engine.h"

#include <corral/localization/localize_with_bounder.h>
#include <corral/number/Counted.h>

namespace corral::program {

template <IntervalNumber I, std::size_t D>
Raster<D> localize_counted_or_not(const std::vector<Polynomial<Rational, D>>& system, const Grid<D>& grid,
                                  const Localize_settings& settings)
{
  const Cell_options options{.sample = settings.sample, .refine_depth = settings.refine ? 1U : 0U};
  return localize<I, D>(system, grid, settings.run, options,
                        [&](const Polynomial<I, D>& f) { return make_bounder<I, D>(settings.method, f); });
}

template <IntervalNumber I, std::size_t D>
Raster<D> localize_over(const std::vector<Polynomial<Rational, D>>& system, const Grid<D>& grid,
                        const Localize_settings& settings)
{
  return settings.count ? localize_counted_or_not<Counted<I>, D>(system, grid, settings)
                        : localize_counted_or_not<I, D>(system, grid, settings);
}

} // namespace corral::program

#define CORRAL_INSTANTIATE_PAPER_ENGINE(I, D)                                                                          \
  template Raster<D> localize_over<I, D>(const std::vector<Polynomial<Rational, D>>&, const Grid<D>&,                  \
                                         const Localize_settings&);

#define CORRAL_INSTANTIATE_PAPER_ENGINES(I)                                                                            \
  CORRAL_INSTANTIATE_PAPER_ENGINE(I, 1)                                                                                \
  CORRAL_INSTANTIATE_PAPER_ENGINE(I, 2)                                                                                \
  CORRAL_INSTANTIATE_PAPER_ENGINE(I, 3)                                                                                \
  CORRAL_INSTANTIATE_PAPER_ENGINE(I, 4)

#endif
