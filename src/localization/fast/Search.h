// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_LOCALIZATION_FAST_SEARCH_H
#define CORRAL_SRC_LOCALIZATION_FAST_SEARCH_H

#include "Block_list.h"
#include "Pulse.h"
#include "grid_part.h"

#include <corral/localization/Grid.h>
#include <corral/localization/Raster_builder.h>
#include <corral/polynomial/Polynomial.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

namespace corral::fast {

/// \brief The common zeros of some polynomials are searched for: what, and how. What it refers to outlives it.
template <std::size_t D>
struct Search
{
  std::span<const Polynomial<Rational, D>> system;
  Pulse& pulse;
  bool refines = true; ///< whether rough nodes are decided on a finer grid, too
  unsigned threads = 1;
  std::uint64_t cell_budget = std::numeric_limits<std::uint64_t>::max(); ///< most plotted cells
  /// Asked before work is spent on nodes in which a polynomial is strangely small; `true` ends the search. May be
  /// empty.
  std::function<bool()> is_in_vain{};
};

/// What one root for each polynomial shows of a grid.
template <std::size_t D>
struct Found
{
  Raster_builder<D> cells;
  std::vector<Grid_part<D>> hidden; ///< where rounding at the root hides a polynomial: not in `cells`
  std::vector<Grid_part<D>> left;   ///< what was not decided when the run was stopped: not in `cells`
  std::uint64_t nodes = 0;          ///< bounded
  bool was_in_vain = false;         ///< then all else is void
};

/// \brief Searches a grid with one root. \param share  the part of the whole work that it is taken for.
template <std::size_t D>
[[nodiscard]] Found<D> search(const Search<D>& what, const Grid<D>& grid, double share);

/// \brief Searches parts of a grid with roots of their own, then what is hidden in these, until nothing is; adds what
/// it finds to the blocks, and returns the number of nodes bounded.
///
/// It ends: a hidden node has fewer levels than the part that it is found in, so that there are no more rounds than
/// levels. \param left  takes in what is not decided when the run is stopped.
/// \throw Budget_exceeded if there are more plotted cells in the blocks than the budget.
template <std::size_t D>
std::uint64_t search_parts(const Search<D>& what, const Grid<D>& grid, std::vector<Grid_part<D>> parts, double share,
                           Block_list<D>& blocks, std::vector<Grid_part<D>>& left);

/// \brief Searches a grid, and what is hidden there, so that nothing is hidden still. If it was in vain there is
/// nothing but the number of nodes.
template <std::size_t D>
[[nodiscard]] Found<D> search_all(const Search<D>& what, const Grid<D>& grid);

extern template Found<2> search<2>(const Search<2>&, const Grid<2>&, double);
extern template Found<3> search<3>(const Search<3>&, const Grid<3>&, double);
extern template std::uint64_t search_parts<2>(const Search<2>&, const Grid<2>&, std::vector<Grid_part<2>>, double,
                                              Block_list<2>&, std::vector<Grid_part<2>>&);
extern template std::uint64_t search_parts<3>(const Search<3>&, const Grid<3>&, std::vector<Grid_part<3>>, double,
                                              Block_list<3>&, std::vector<Grid_part<3>>&);
extern template Found<2> search_all<2>(const Search<2>&, const Grid<2>&);
extern template Found<3> search_all<3>(const Search<3>&, const Grid<3>&);

} // namespace corral::fast

#endif
