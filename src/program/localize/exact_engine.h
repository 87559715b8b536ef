// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_PROGRAM_LOCALIZE_EXACT_ENGINE_H
#define CORRAL_SRC_PROGRAM_LOCALIZE_EXACT_ENGINE_H

#include <corral/decision/ideal_raster.h>

#include <vector>

namespace corral::program {

/// \brief Decides the unknown cells of a guaranteed raster exactly.
/// \throw Contradiction. Invalid_input if there is no exact decision for this dimension and number of polynomials.
template <std::size_t D>
[[nodiscard]] Ideal_raster<D> decide_exactly(const std::vector<Polynomial<Rational, D>>& system,
                                             const Raster<D>& candidates, const Run_options& run = {},
                                             Ideal_raster_options options = {});

} // namespace corral::program

#endif
