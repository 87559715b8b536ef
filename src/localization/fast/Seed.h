// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_LOCALIZATION_FAST_SEED_H
#define CORRAL_SRC_LOCALIZATION_FAST_SEED_H

#include <corral/localization/Grid.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace corral::fast {

/// \brief A node on its way from one worker to another: a form in the coordinates of the node, and what is known of it.
template <std::size_t D>
struct Seed
{
  std::size_t cut = 0;              ///< which class of the shape
  double quantum = 0;               ///< a power of two of which all coefficients are multiples; 0 if none is known
  double remainder = 0;             ///< at least 0
  double norm = 0;                  ///< at least the sum of absolute coefficients
  Cell<D> corner{};                 ///< the first cell of the node
  std::vector<double> coefficients; ///< by position in the class
};

/// A quantum of all coefficients of all seeds; 0 if none is known.
template <std::size_t D>
[[nodiscard]] double common_quantum(std::span<const Seed<D>> seeds)
{
  double least = std::numeric_limits<double>::infinity();
  for (const auto& seed : seeds) least = std::min(least, seed.quantum);
  return seeds.empty() ? 0 : least;
}

} // namespace corral::fast

#endif
