// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_PROGRAM_LOCALIZE_PAPER_ENGINE_H
#define CORRAL_SRC_PROGRAM_LOCALIZE_PAPER_ENGINE_H

#include "Localize_settings.h"

#include <corral/localization/Raster.h>
#include <corral/number/Interval_number.h>
#include <corral/polynomial/Polynomial.h>

#include <vector>

namespace corral::program {

/// \brief The subdivision loop of the paper over the interval number I, with the bounder that `settings` names.
///
/// Defined for the types of `Number_types` but `counted`, which is what `settings.count` is for.
template <IntervalNumber I, std::size_t D>
[[nodiscard]] Raster<D> localize_over(const std::vector<Polynomial<Rational, D>>& system, const Grid<D>& grid,
                                      const Localize_settings& settings);

} // namespace corral::program

#endif
