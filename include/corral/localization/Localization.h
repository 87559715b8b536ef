// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_LOCALIZATION_LOCALIZATION_H
#define CORRAL_LOCALIZATION_LOCALIZATION_H

#include <corral/localization/Cell_set.h>

#include <cstddef>
#include <cstdint>
#include <functional>

namespace corral {

/// What a localisation cost. Additions and multiplications are 0 where the number type does not count them.
struct Localization_counters
{
  std::uint64_t bounds = 0;       ///< boxes bounded, for one polynomial each
  std::uint64_t subdivisions = 0; ///< boxes cut, cells cut into subcells included
  std::uint64_t additions = 0;
  std::uint64_t multiplications = 0;
  double seconds = 0;
};

/// The cells that are not empty.
template <std::size_t D>
struct Localization
{
  Cell_set<D> cells;
  Localization_counters counters;
  bool is_guaranteed = false; ///< whether the verdicts, `empty` included, are proofs
};

/// How cells of grid size are treated, and when to stop.
struct Localization_options
{
  bool sample = false;       ///< look for changes of sign at the corners
  unsigned refine_depth = 0; ///< how often a cell is halved to prove it empty
  std::uint64_t cell_budget = 50'000'000;
  std::function<bool(double)> progress{}; ///< called with the share done, 0 to 1; `false` stops
};

} // namespace corral

#endif
