// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_LOCALIZATION_FAST_RUNNER_H
#define CORRAL_SRC_LOCALIZATION_FAST_RUNNER_H

#include <corral/localization/localize_fast.h>

#include <cstddef>

namespace corral::fast {

/// \brief Localises one polynomial on a grid, or on a part of one.
/// \param refines  whether rough nodes are decided on a finer grid, too.
template <std::size_t D>
[[nodiscard]] Localization<D> localize_part(const Polynomial<Rational, D>& f, const Grid<D>& grid,
                                            const Fast_options& options, bool refines);

extern template Localization<2> localize_part<2>(const Polynomial<Rational, 2>&, const Grid<2>&, const Fast_options&,
                                                 bool);
extern template Localization<3> localize_part<3>(const Polynomial<Rational, 3>&, const Grid<3>&, const Fast_options&,
                                                 bool);

} // namespace corral::fast

#endif
