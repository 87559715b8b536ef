// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_PROGRAM_BOUND_BOUND_OVER_H
#define CORRAL_SRC_PROGRAM_BOUND_BOUND_OVER_H

#include "../arguments.h"
#include "../localize/engine.h"

#include <corral/number/Counted.h>
#include <corral/number/Interval_number.h>

#include <optional>
#include <string>
#include <vector>

namespace corral::program {

/// A polynomial to bound over a box, which may be flat or a point.
struct Bound_problem
{
  Space space;
  Formula polynomial;
  Method method;
  std::vector<Rational> point{}; ///< of the box, one coordinate for each axis, whose value is looked for; else empty
};

/// The exact value at a point, and whether the bound contains it.
struct Value_answer
{
  Rational value;
  bool is_contained = false;
};

/// The interval as text, and what to say of it.
struct Bound_answer
{
  std::string polynomial; ///< as read
  std::string exact;      ///< hexadecimal floats or fractions
  std::string decimal;    ///< rounded outward
  bool is_guaranteed = false;
  Operation_counts counts; ///< of the one bound, where the number type counts
  std::optional<Value_answer> at_point;
};

/// \brief Bounds over one number type. Each type is compiled in a source of its own, which the build makes.
/// \throw Invalid_input for an unknown bounder; what the parser and the bounder throw.
template <IntervalNumber I>
[[nodiscard]] Bound_answer bound_over(const Bound_problem& problem);

} // namespace corral::program

#endif
