// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_POLYNOMIAL_BOX_H
#define CORRAL_POLYNOMIAL_BOX_H

#include <corral/number/Interval_number.h>
#include <corral/number/Rational_interval.h>

#include <array>
#include <cstddef>

namespace corral {

/// A product of D closed intervals over the interval number `I`, axis 0 (x) first. A side may be a point.
template <class I, std::size_t D>
using Box = std::array<I, D>;

/// A box with rational corners.
template <std::size_t D>
using Rational_box = Box<Rational_interval, D>;

/// The smallest box over `I` that contains the given one.
template <IntervalNumber I, std::size_t D>
[[nodiscard]] Box<I, D> enclose(const Rational_box<D>& box)
{
  Box<I, D> result;
  for (std::size_t axis = 0; axis < D; ++axis) result[axis] = enclose<I>(box[axis].lower(), box[axis].upper());
  return result;
}

/// A point with rational coordinates.
template <std::size_t D>
using Rational_point = std::array<Rational, D>;

} // namespace corral

#endif
