// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_NUMBER_DOUBLE_BRACKET_H
#define CORRAL_NUMBER_DOUBLE_BRACKET_H

#include <corral/number/Rational.h>

namespace corral {

/// \brief The doubles around a rational number, infinities included.
///
/// `below` and `above` are the tightest: equal where the number is a double. `nearest` is one of the two, the one
/// with an even mantissa on a tie.
struct Double_bracket
{
  double below = 0;
  double nearest = 0;
  double above = 0;
};

/// \brief The doubles around `value`, found with integers only: right at subnormals and beyond the largest double, and
/// independent of the rounding mode.
/// \par Complexity  Two divisions of integers of the size of `value`.
[[nodiscard]] Double_bracket bracket(const Rational& value);

} // namespace corral

#endif
