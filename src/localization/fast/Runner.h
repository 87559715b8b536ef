// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_LOCALIZATION_FAST_RUNNER_H
#define CORRAL_SRC_LOCALIZATION_FAST_RUNNER_H

#include "Search.h"

#include <cstddef>

namespace corral::fast {

/// `search` of one polynomial with a dense form. \pre It is alone in the system.
template <std::size_t D>
[[nodiscard]] Found<D> run_alone(const Search<D>& what, const Grid<D>& grid, double share);

extern template Found<2> run_alone<2>(const Search<2>&, const Grid<2>&, double);
extern template Found<3> run_alone<3>(const Search<3>&, const Grid<3>&, double);

} // namespace corral::fast

#endif
