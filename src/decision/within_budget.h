// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_DECISION_WITHIN_BUDGET_H
#define CORRAL_SRC_DECISION_WITHIN_BUDGET_H

#include <corral/decision/Cell_decision.h>
#include <corral/errors.h>

#include <cstddef>

namespace corral::exact {

/// What `decide()` gives, or `unknown` with the reason if that does not fit some budget: one cell that is too heavy
/// costs no other one.
template <std::size_t D, class Decide>
[[nodiscard]] Cell_decision<D> within_budget(const Decide& decide)
{
  try {
    return decide();
  } catch (const Budget_exceeded& error) {
    return {Verdict::unknown, Rung::algebra, std::monostate{}, error.what()};
  }
}

} // namespace corral::exact

#endif
