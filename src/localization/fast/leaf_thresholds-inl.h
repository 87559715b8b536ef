// SPDX-License-Identifier: LGPL-3.0-or-later
// Included once for each instruction set, by fast_engine.cpp.
#if defined(CORRAL_SRC_FAST_LEAF_THRESHOLDS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CORRAL_SRC_FAST_LEAF_THRESHOLDS_INL_H
#undef CORRAL_SRC_FAST_LEAF_THRESHOLDS_INL_H
#else
#define CORRAL_SRC_FAST_LEAF_THRESHOLDS_INL_H
#endif

#include "Exact_limits.h"
#include "Fast_plan.h"
#include "octet-inl.h"

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace corral::fast::HWY_NAMESPACE {

inline constexpr double least_positive = std::numeric_limits<double>::denorm_min();

/// What computed values of eight leaves must reach, in absolute value, to prove something.
struct Thresholds
{
  alignas(64) double sign[batch];     ///< the sign of f at a corner
  alignas(64) double positive[batch]; ///< if all corners of a cell exceed it, f is positive on the cell
  alignas(64) double negative[batch]; ///< if all corners of a cell are below its negation, f is negative on the cell
  alignas(64) double probe[batch];    ///< like `sign`, at a point of the finer lattice in a cell
  unsigned bent;                      ///< the lanes where f may have its extremes in a cell elsewhere than at corners
};

/// Along an axis on which f is monotone the extremes lie at corners; along another, f bends away from its chord by at
/// most the second derivative times an eighth of the squared cell width.
template <std::size_t D>
Thresholds leaf_thresholds(const Plan<D>& plan, const Exact_limits& exact, std::size_t size, const double* c,
                           const Octet& norm, const Octet& remainder)
{
  const Rounding& r = plan.rounding;
  const auto term = [&](std::size_t i) HWY_ATTR { return i < size ? load(c + i * batch) : set(0); };
  const Octet rounded = (norm * set(r.evaluate) + remainder + set(r.underflow)) * set(r.step);
  const Octet sign = if_at_most(norm, set(exact.corner()), remainder * set(r.step), rounded);
  Octet convex = set(0);
  Octet concave = set(0);
  for (std::size_t axis = 0; axis < D; ++axis) {
    Octet slope = set(0);
    Octet curve = set(0);
    for (const auto& weight : plan.weights[axis]) {
      if (weight.position >= size) break;
      const Octet size_of_term = abs(term(weight.position));
      slope = slope + size_of_term * set(weight.slope);
      if (weight.position != plan.square[axis]) curve = curve + size_of_term * set(weight.curve);
    }
    const Octet linear = abs(term(plan.linear[axis]));
    const Octet second = term(plan.square[axis]) * set(2);
    const auto bend = [&](const Octet& derivative) HWY_ATTR {
      const Octet most = max((derivative + curve * set(r.sum)) * set(plan.sag[axis]), set(0));
      return if_at_most(slope * set(r.sum), linear, set(0), most);
    };
    convex = convex + bend(second);
    concave = concave + bend(set(0) - second);
  }
  // Whatever proves a cell empty must be strict, even where nothing was rounded.
  const Octet least = max(sign, set(least_positive));
  const Octet positive = if_at_most(convex, set(0), least, (least + convex) * set(r.step));
  const Octet negative = if_at_most(concave, set(0), least, (least + concave) * set(r.step));
  Thresholds result;
  store(sign, result.sign);
  store(positive, result.positive);
  store(negative, result.negative);
  store(if_at_most(norm, set(exact.probe()), sign, rounded), result.probe);
  result.bent = below(least, max(positive, negative));
  return result;
}

} // namespace corral::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
