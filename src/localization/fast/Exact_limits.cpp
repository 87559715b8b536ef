// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Exact_limits.h"

#include <cmath>
#include <limits>

namespace corral::fast {
namespace {

/// quantum 2^-bits, or 0 if that is no double.
double finer(double quantum, unsigned bits) { return bits > 4000 ? 0 : std::ldexp(quantum, -static_cast<int>(bits)); }

} // namespace

double exact_limit(double quantum, unsigned bits)
{
  constexpr double least_unit = 0x1p-1000; // no product of a multiple of it and a weight of a block is subnormal
  static_assert(std::numeric_limits<double>::digits == 53 && least_unit >= std::numeric_limits<double>::min());
  const double unit = finer(quantum, bits);
  return unit < least_unit ? 0 : std::ldexp(unit, 52);
}

void Exact_limits::reset(unsigned degree, unsigned level, unsigned leaf_level, double quantum)
{
  degree_ = degree;
  level_ = level;
  quantum_ = quantum;
  limit_.resize(level);
  for (unsigned below = 0; below < level; ++below) limit_[below] = exact_limit(quantum, degree * (level - below));
  const unsigned halvings = level - leaf_level;
  corner_ = exact_limit(quantum, degree * (halvings + corner_bits));
  probe_ = exact_limit(quantum, degree * (halvings + probe_bits));
}

double Exact_limits::quantum(unsigned level) const { return finer(quantum_, degree_ * (level_ - level)); }

} // namespace corral::fast
