// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_DECISION_ZERO_ON_SEGMENT_H
#define CORRAL_SRC_DECISION_ZERO_ON_SEGMENT_H

#include <corral/decision/Witness.h>

#include <cstddef>

namespace corral::exact {

/// \brief An exact zero of h between two points: a rational point, or a chain whose first element is h on the line
/// through them. \pre h has opposite strict signs at the two points.
template <std::size_t D>
[[nodiscard]] Witness<D> zero_on_segment(const Polynomial<Integer, D>& h, const Sign_change<D>& change);

} // namespace corral::exact

#endif
