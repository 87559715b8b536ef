// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_AUDIT_STEPWISE_BOUNDER_H
#define CORRAL_AUDIT_STEPWISE_BOUNDER_H

#include "fault_harness.h"

#include <corral/polynomial/substitution.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace corral::audit {

using Point = std::array<Rational, 2>;
using Exact = Rational_interval;

inline unsigned total(const Exponents<2>& k) { return k[0] + 0U + k[1]; }
inline bool all_even(const Exponents<2>& k) { return k[0] % 2 == 0 && k[1] % 2 == 0; }

/// \brief The modified affine bound in steps: f about the centre of the box, then the range of each term by itself. A
/// fault derives from this and replaces a step. The control: nothing may be caught.
struct Sound_steps
{
  static constexpr std::string_view name = "no_fault_maa";
  static constexpr std::string_view description = "modified affine arithmetic as it is";

  static Exact_polynomial coefficients(const Exact_polynomial& f) { return f; }
  static Rational centre(const Exact& side) { return (side.lower() + side.upper()) / 2; }
  static Rational radius(const Exact& side, const Rational& centre)
  {
    return std::max(Rational(side.upper() - centre), Rational(centre - side.lower()));
  }
  static Exact_polynomial expansion(const Exact_polynomial& f, const Point& centre) { return taylor_shift(f, centre); }
  /// The range of u^k, k not zero, for u in [-1, 1]^2.
  static Exact range(const Exponents<2>& k) { return all_even(k) ? Exact(0, 1) : Exact(-1, 1); }
  static Exact result(const Exact& bound) { return bound; }
};

template <class Steps>
Exact bound_by_steps(const Exact_polynomial& f, const Point& centre, const Point& radius)
{
  Exact sum(0);
  const auto expansion = Steps::expansion(f, centre);
  for (const auto& [k, c] : expansion.terms()) {
    if (total(k) == 0) {
      sum += Exact(c);
      continue;
    }
    Rational size = c;
    for (std::size_t axis = 0; axis < 2; ++axis)
      for (unsigned e = 0; e < k[axis]; ++e) size *= radius[axis];
    sum += Steps::range(k) * Exact(size);
  }
  return Steps::result(sum);
}

template <class Steps>
class Stepwise_bounder
{
public:
  static constexpr std::string_view name = Steps::name;
  static constexpr std::string_view description = Steps::description;

  explicit Stepwise_bounder(const Exact_polynomial& f) : f_(Steps::coefficients(f)) {}

  [[nodiscard]] Exact bound(const Exact_box& box) const
  {
    Point centre;
    Point radius;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      centre[axis] = Steps::centre(box[axis]);
      radius[axis] = Steps::radius(box[axis], centre[axis]);
    }
    return bound_by_steps<Steps>(f_, centre, radius);
  }

private:
  Exact_polynomial f_;
};

} // namespace corral::audit

#endif
