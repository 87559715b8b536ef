// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_PROGRAM_LOCALIZE_EXACT_ENGINE_H
#define CORRAL_SRC_PROGRAM_LOCALIZE_EXACT_ENGINE_H

#include <corral/decision/ideal_raster.h>

#include <functional>
#include <vector>

namespace corral::program {

struct Exact_settings
{
  std::function<bool(double)> progress{}; ///< `false` stops: what is proved is kept and the other cells stay unknown
  unsigned threads = 1;
  bool keep_rungs = false;
  bool recheck = false; ///< decide every cell again without floats
};

/// \brief Decides the unknown cells of a guaranteed localisation exactly.
/// \throw Contradiction. Invalid_input if there is no exact decision for this dimension and number of polynomials.
template <std::size_t D>
[[nodiscard]] Ideal_raster<D> decide_exactly(const std::vector<Polynomial<Rational, D>>& system, const Grid<D>& grid,
                                             const Cell_set<D>& cells, const Exact_settings& settings);

} // namespace corral::program

#endif
