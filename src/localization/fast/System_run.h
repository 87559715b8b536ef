// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_LOCALIZATION_FAST_SYSTEM_RUN_H
#define CORRAL_SRC_LOCALIZATION_FAST_SYSTEM_RUN_H

#include "Search.h"

#include <cstddef>

namespace corral::fast {

/// \brief `search` of any number of polynomials, each with a dense form or by its terms.
///
/// All polynomials walk down the tree together, level by level: a node that one of them drops is dropped for all, so
/// that time and memory grow with the cells plotted in the end.
template <std::size_t D>
[[nodiscard]] Found<D> run_system(const Search<D>& what, const Grid<D>& grid, double share);

extern template Found<2> run_system<2>(const Search<2>&, const Grid<2>&, double);
extern template Found<3> run_system<3>(const Search<3>&, const Grid<3>&, double);

} // namespace corral::fast

#endif
