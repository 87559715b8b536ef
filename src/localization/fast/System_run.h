// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_LOCALIZATION_FAST_SYSTEM_RUN_H
#define CORRAL_SRC_LOCALIZATION_FAST_SYSTEM_RUN_H

#include <corral/localization/localize_fast.h>

#include <cstddef>
#include <vector>

namespace corral::fast {

/// \brief Localises the common zeros of several polynomials on a grid, or on a part of one.
///
/// All polynomials walk down the tree together, level by level: a node that one of them drops is dropped for all, so
/// that time and memory grow with the cells plotted in the end. \param refines  as for `localize_part`.
template <std::size_t D>
[[nodiscard]] Localization<D> localize_system(const std::vector<Polynomial<Rational, D>>& system, const Grid<D>& grid,
                                              const Fast_options& options, bool refines);

extern template Localization<2> localize_system<2>(const std::vector<Polynomial<Rational, 2>>&, const Grid<2>&,
                                                   const Fast_options&, bool);
extern template Localization<3> localize_system<3>(const std::vector<Polynomial<Rational, 3>>&, const Grid<3>&,
                                                   const Fast_options&, bool);

} // namespace corral::fast

#endif
