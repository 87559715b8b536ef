// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_DECISION_COMMON_ZEROS_H
#define CORRAL_SRC_DECISION_COMMON_ZEROS_H

#include "../algebra/Bernstein_form.h"
#include "../algebra/Plane_system.h"
#include "Zero_set.h"

#include <corral/decision/Cell_decision.h>

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <utility>

namespace corral::exact {

/// \brief The common zeros of two polynomials, asked of closed boxes whether they meet them. Proof: doc/exact.md.
template <std::size_t D>
class Common_zeros
{
public:
  /// Both polynomials may be zero.
  Common_zeros(const Polynomial<Integer, D>& f, const Polynomial<Integer, D>& g, Checkpoint checkpoint,
               Witnesses witnesses);
  Common_zeros(Common_zeros&&) noexcept;
  ~Common_zeros();

  [[nodiscard]] Cell_decision<D> decide(const Rational_box<D>& box);

private:
  static constexpr std::size_t facet_dimension = D == 3 ? 2 : D; // no facets are asked in the plane

  [[nodiscard]] Cell_decision<D> decide_rest(const Rational_box<D>& box);
  [[nodiscard]] std::optional<Cell_decision<D>> decide_section(std::size_t axis, const Rational& value,
                                                               const Rational_box<D>& box);
  [[nodiscard]] Cell_decision<D> decide_inside(const Rational_box<D>& box);

  Checkpoint checkpoint_;
  Witnesses witnesses_;
  Polynomial<Integer, D> f_; ///< without the common factor
  Polynomial<Integer, D> g_;
  Polynomial<Integer, D> common_;
  std::unique_ptr<Zero_set<D>> common_zeros_; ///< of the common factor; empty if it is constant
  std::unique_ptr<Plane_system> points_;      ///< D = 2
  std::unique_ptr<Inner_pieces> pieces_;      ///< D = 3: strictly inside a box
  std::map<std::pair<std::size_t, Rational>, std::unique_ptr<Common_zeros<facet_dimension>>> sections_;
};

} // namespace corral::exact

#endif
