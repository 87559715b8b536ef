// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_BOUNDERS_RANGE_BOUNDER_H
#define CORRAL_BOUNDERS_RANGE_BOUNDER_H

#include <corral/number/Interval_number.h>
#include <corral/polynomial/Box.h>
#include <corral/polynomial/Polynomial.h>

#include <concepts>
#include <cstddef>
#include <string_view>

namespace corral {

/// \brief Encloses the values of one fixed polynomial f over any box.
///
/// The compiler checks the syntax; `audit/audit_bounder.h` checks the contract:
///  - inclusion: `bound(X)` contains g(x) for every real x in X and every real polynomial g whose coefficients lie
///    in those of f, rounding included if the interval number is guaranteed;
///  - X may be flat or a point; its sides are finite;
///  - `bound` may be called from several threads at once, each under an `Arithmetic_scope` of the interval number,
///    and so must the constructor be.
///
/// Not promised: the tightest range, or bound(X) inside bound(Y) when X lies inside Y.
// clang-format off
template <class B>
concept RangeBounder =
  std::copyable<B> && IntervalNumber<typename B::Interval>
  && std::same_as<typename B::Polynomial, Polynomial<typename B::Interval, B::dimension>>
  && std::same_as<typename B::Box, Box<typename B::Interval, B::dimension>>
  && std::constructible_from<B, const typename B::Polynomial&>
  && requires(const B& b, const typename B::Box& box) {
    { b.bound(box) } -> std::same_as<typename B::Interval>;
    { B::name } -> std::convertible_to<std::string_view>;
  };
// clang-format on

/// \brief A number near the middle of `x`, as a point interval; rounding may put it outside `x`.
/// \pre `x` is finite. Every bounder that expands about a centre asks for it, so that none looks at its box itself.
template <IntervalNumber I>
[[nodiscard]] I midpoint(const I& x)
{
  CORRAL_PRECONDITION(exact_lower(x) && exact_upper(x),
                      "bounder: given a box with an infinite side; expected finite ones");
  const I half = enclose<I>(Rational(1, 2));
  return lower(I(lower(x) * half + upper(x) * half)); // halved first, so that the sum does not overflow
}

/// \brief A number r >= 0, as a point interval, such that x lies in centre + r * [-1, 1]. \pre Both are finite.
template <IntervalNumber I>
[[nodiscard]] I radius(const I& x, const I& centre)
{
  CORRAL_PRECONDITION(exact_lower(x) && exact_upper(x),
                      "bounder: given a box with an infinite side; expected finite ones");
  return upper(symmetric_hull(I(x - centre)));
}

} // namespace corral

#endif
