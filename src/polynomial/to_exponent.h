// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_POLYNOMIAL_TO_EXPONENT_H
#define CORRAL_SRC_POLYNOMIAL_TO_EXPONENT_H

#include <corral/errors.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

namespace corral::detail {

/// \brief A degree as the exponent of a term. \throw Budget_exceeded if it is above what a term can hold.
[[nodiscard]] inline std::uint16_t to_exponent(std::size_t degree)
{
  constexpr std::size_t most = std::numeric_limits<std::uint16_t>::max();
  if (degree > most)
    throw Budget_exceeded("algebra: a polynomial has the degree " + std::to_string(degree) + "; expected at most "
                          + std::to_string(most));
  return static_cast<std::uint16_t>(degree);
}

} // namespace corral::detail

#endif
