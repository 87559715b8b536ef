// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_LOCALIZATION_FAST_ROOT_SEED_H
#define CORRAL_SRC_LOCALIZATION_FAST_ROOT_SEED_H

#include "Fast_plan.h"
#include "Pulse.h"

#include <corral/localization/Grid.h>
#include <corral/polynomial/Polynomial.h>

#include <cstddef>

namespace corral::fast {

/// \brief The root of the tree: a positive multiple of f on the padded grid, every coefficient at most 1 in absolute
/// value.
///
/// It substitutes x_i = lower_i + step_i 2^(K_i) (1 + u_i) / 2 exactly, in integers, and rounds once at the end.
/// \pre The plan has the shape of f and is one of this grid, and f is not zero.
/// \throw Cancelled.
template <std::size_t D>
[[nodiscard]] Seed<D> root_seed(const Plan<D>& plan, const Polynomial<Rational, D>& f, const Grid<D>& grid,
                                Pulse& pulse);

extern template Seed<2> root_seed<2>(const Plan<2>&, const Polynomial<Rational, 2>&, const Grid<2>&, Pulse&);
extern template Seed<3> root_seed<3>(const Plan<3>&, const Polynomial<Rational, 3>&, const Grid<3>&, Pulse&);

} // namespace corral::fast

#endif
