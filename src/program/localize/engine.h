// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_PROGRAM_LOCALIZE_ENGINE_H
#define CORRAL_SRC_PROGRAM_LOCALIZE_ENGINE_H

#include "Localize_settings.h"

#include <corral/localization/Raster.h>
#include <corral/polynomial/Polynomial.h>

#include <vector>

/// \file
/// The library behind names known only at run time. The templates for each number type are compiled in a file of their
/// own, so that no command waits for all of them.
namespace corral::program {

/// \throw Invalid_input for unknown names; what the localisation throws.
template <std::size_t D>
[[nodiscard]] Raster<D> localize_by_name(const std::vector<Polynomial<Rational, D>>& system, const Grid<D>& grid,
                                         const Localize_settings& settings);

} // namespace corral::program

#endif
