// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_GEOMETRY_IN_CELL_H
#define CORRAL_SRC_GEOMETRY_IN_CELL_H

#include "Cell_form.h"

#include <corral/number/Outward_interval.h>

#include <cmath>

namespace corral::geometry {

using Interval = Outward_interval;

inline Interval interval(const Range& range) { return {range.low, range.high}; }

/// A range of the unit box in the coordinate of a cell, which runs from 0 to 1 over `side`.
inline Interval in_cell(const Range& range, const Range& side)
{
  // The length of a side is exact and no power of two, so its inverse is enclosed.
  const double length = side.high - side.low;
  const Interval inverse(std::nextafter(1 / length, 0.0), std::nextafter(1 / length, HUGE_VAL));
  return (interval(range) - Interval(side.low)) * inverse;
}

} // namespace corral::geometry

#endif
