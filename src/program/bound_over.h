// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_PROGRAM_BOUND_OVER_H
#define CORRAL_PROGRAM_BOUND_OVER_H

#include "arguments.h"
#include "engine.h"

#include <corral/number/Counted.h>
#include <corral/number/Interval_number.h>

#include <string>

namespace corral::program {

/// A polynomial to bound over a box, which may be flat or a point.
struct Bound_problem
{
  Space space;
  std::string polynomial;
  Method method;
};

/// The interval as text, and what to say of it.
struct Bound_answer
{
  std::string exact;   ///< hexadecimal floats or fractions
  std::string decimal; ///< rounded outward
  bool is_guaranteed = false;
  Operation_counts counts; ///< of the one bound, where the number type counts
};

/// \brief Bounds over one number type. Each type is compiled in a file of its own, `bound_<type>.cpp`.
/// \throw Invalid_input for an unknown bounder; what the parser and the bounder throw.
template <IntervalNumber I>
[[nodiscard]] Bound_answer bound_over(const Bound_problem& problem);

} // namespace corral::program

#endif
