// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_DECISION_INTERVAL_RUNG_H
#define CORRAL_SRC_DECISION_INTERVAL_RUNG_H

#include "Interval_jet.h"
#include "Interval_search.h"

#include <cstddef>
#include <optional>

namespace corral::exact {

/// \brief The first steps of the exact decision over an interval number: a cell is decided if rounding, and what is
/// dropped of a high degree, leave the signs clear.
/// \tparam I  a guaranteed model of `IntervalNumber`.
template <IntervalNumber I, std::size_t D>
class Interval_rung
{
  static_assert(is_guaranteed<I>, "a verdict needs guaranteed intervals");

public:
  /// \param precision  bits that matter of the largest coefficient.
  explicit Interval_rung(long precision) : precision_(precision) {}

  /// Looks for a zero of a polynomial on [0,1]^D, given in the power basis.
  /// \param sign  its strict sign at all corners.
  /// \param limits  how far to search.
  [[nodiscard]] Finding<D> look_for_zero(const Power_form<D>& power, int sign, const Search_limits& limits = {})
  {
    const Arithmetic_scope<I> scope;
    const Jet_maker<I, D> maker(power, binomials_, precision_);
    Interval_jet<I, D> jet;
    jet.size = maker.size();
    jet.values[0] = maker.make(0);
    if (common_sign(jet.values[0]) == sign) return {Finding<D>::Kind::none, {}};
    for (std::size_t part = 1; part <= D; ++part) jet.values[part] = maker.make(part);
    return exact::look_for_zero(std::move(jet), sign, limits);
  }

private:
  long precision_;
  Reciprocal_binomials<I> binomials_;
};

} // namespace corral::exact

#endif
