// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_NUMBER_NEAREST_INTERVAL_H
#define CORRAL_NUMBER_NEAREST_INTERVAL_H

#include <corral/number/Double_interval.h>

namespace corral {

/// No outward rounding at all: every operation rounds to nearest.
struct Nearest_rounding
{
  static constexpr std::string_view name = "double_nearest";
  static constexpr bool is_guaranteed = false;

  static double add_down(double a, double b) { return a + b; }
  static double add_up(double a, double b) { return a + b; }
  static double multiply_down(double a, double b) { return a * b; }
  static double multiply_up(double a, double b) { return a * b; }
  static double lower_of(const Double_bracket& doubles) { return doubles.nearest; }
  static double upper_of(const Double_bracket& doubles) { return doubles.nearest; }
};

/// \brief Model of `IntervalNumber` that guarantees nothing: plain doubles, as in the paper. For comparison only.
using Nearest_interval = Double_interval<Nearest_rounding>;

} // namespace corral

#endif
