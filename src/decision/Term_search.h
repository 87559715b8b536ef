// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_DECISION_TERM_SEARCH_H
#define CORRAL_SRC_DECISION_TERM_SEARCH_H

#include <corral/bounders/Natural_bounder.h>
#include <corral/decision/Cell_decision.h>
#include <corral/number/Rational_interval.h>

#include <array>
#include <cstddef>
#include <optional>

namespace corral::exact {

/// \brief Decides boxes by exact bounds of the terms alone, for a polynomial with few terms for its degree: what that
/// degree would cost is never spent. Proof: doc/exact.md, section 1.
template <std::size_t D>
class Term_search
{
public:
  explicit Term_search(const Polynomial<Integer, D>& f);

  /// \brief The verdict on a closed box, if the terms show it.
  /// \param sign  the strict sign of the polynomial at every corner.
  /// \par Complexity  D + 1 bounds of the terms for each of at most `most_boxes()` boxes.
  [[nodiscard]] std::optional<Cell_decision<D>> decide(const Rational_box<D>& box, int sign) const;

  /// How many boxes are looked at: about as many as moving all coefficients of a dense form would pay for.
  [[nodiscard]] std::size_t most_boxes() const { return most_boxes_; }

private:
  using Bounder = Natural_bounder<Rational_interval, D>;

  [[nodiscard]] Rational_box<D> lowest_part(Rational_box<D> box, int sign) const;

  Bounder value_;
  std::array<Bounder, D> slopes_; ///< the partial derivatives
  std::size_t most_boxes_;
};

} // namespace corral::exact

#endif
