// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_LOCALIZATION_FAST_ROUNDS_NOTHING_H
#define CORRAL_SRC_LOCALIZATION_FAST_ROUNDS_NOTHING_H

#include <cmath>

namespace corral::fast {

/// Whether `sum` is a + b exactly, by Knuth's error of a sum. \pre It is the sum rounded to nearest, and finite.
[[nodiscard]] inline bool is_exact_sum(double a, double b, double sum)
{
  const double of_b = sum - a;
  return (a - (sum - of_b)) + (b - of_b) == 0;
}

/// Whether `product` is a * b exactly. \pre It is finite, and |b| < 2^100.
[[nodiscard]] inline bool is_exact_product(double a, double b, double product)
{
  constexpr double up = 0x1p+900; // since the error itself may be smaller than all subnormals
  return std::abs(product) < 0x1p+100 ? std::fma(a, b * up, -(product * up)) == 0 : std::fma(a, b, -product) == 0;
}

} // namespace corral::fast

#endif
