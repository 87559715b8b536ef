// SPDX-License-Identifier: LGPL-3.0-or-later
#include "exact_engine.h"

#include <corral/decision/ideal_system.h>
#include <corral/errors.h>

namespace corral::program {

template <std::size_t D>
Ideal_raster<D> decide_exactly(const std::vector<Polynomial<Rational, D>>& system, const Raster<D>& candidates,
                               const Run_options& run, Ideal_raster_options options)
{
  options.patience = std::chrono::milliseconds(250);
  if constexpr (D <= 3)
    if (system.size() == 1) return ideal_raster(system.front(), candidates, run, options);
  if constexpr (D == 2 || D == 3)
    if (system.size() == 2) return ideal_raster(system, candidates, run, options);
  throw Invalid_input("exact: given " + detail::quantity(system.size(), "polynomial") + " in "
                      + detail::quantity(D, "dimension")
                      + "; expected 1 in 1 to 3 dimensions, or 2 in 2 or 3 dimensions");
}

#define CORRAL_INSTANTIATE(D)                                                                                          \
  template Ideal_raster<D> decide_exactly<D>(const std::vector<Polynomial<Rational, D>>&, const Raster<D>&,            \
                                             const Run_options&, Ideal_raster_options);
CORRAL_INSTANTIATE(1)
CORRAL_INSTANTIATE(2)
CORRAL_INSTANTIATE(3)
CORRAL_INSTANTIATE(4)

} // namespace corral::program
