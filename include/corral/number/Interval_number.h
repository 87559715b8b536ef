// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_NUMBER_INTERVAL_NUMBER_H
#define CORRAL_NUMBER_INTERVAL_NUMBER_H

#include <corral/number/Rational.h>

#include <concepts>
#include <optional>
#include <string_view>

/// \file
/// The contract that every interval number fulfils. The algorithms of Corral never round: they
/// are written once against this contract, and the number type does the rounding.
namespace corral {

/// \brief What Corral knows about the interval number `I`; specialised next to each model.
///
/// There is no primary definition, so that a forgotten include does not compile. A
/// specialisation offers
///  - `name`           : `std::string_view`, the name by which programs choose the type;
///  - `is_guaranteed`  : whether the inclusion contract below holds, rounding included;
///  - `is_exact`       : whether `enclose` and arithmetic never round;
///  - `Scope`          : a default-constructible guard. While one lives on a thread, arithmetic
///                       with `I` on this thread is valid; its constructor throws
///                       `Unsafe_environment` if it cannot be;
///  - `enclose(Rational)`        : the tightest `I` that contains the number;
///  - `hull(I, I)`               : the smallest interval that contains both;
///  - `lower(I)`, `upper(I)`     : an end point, which must be finite, as a point interval, exactly;
///  - `exact_lower(I)`, `exact_upper(I)` : an end point as `std::optional<Rational>`, empty
///                       where the interval is unbounded on that side (or not a number);
///  - `lower_sign(I)`, `upper_sign(I)`   : the sign of an end point, -1, 0 or 1. A value that is
///                       not a number has `lower_sign` -1 and `upper_sign` 1.
template <class I>
struct Interval_traits;

/// \brief A closed interval of reals with arithmetic.
///
/// The compiler checks the syntax. `verification/audit_number.h` checks the contract of
/// *inclusion*: for every operation op and all reals x in X, y in Y, `X op Y` contains x op y.
/// A type whose traits say `is_guaranteed == false` promises no inclusion, and no verdict
/// drawn from it counts as proved.
// clang-format off
template <class I>
concept IntervalNumber =
  std::copyable<I> && std::default_initializable<I> && std::convertible_to<int, I>
  && requires(I a, const I b, const Rational& q) {
    { Interval_traits<I>::name } -> std::convertible_to<std::string_view>;
    { Interval_traits<I>::is_guaranteed } -> std::convertible_to<bool>;
    { Interval_traits<I>::is_exact } -> std::convertible_to<bool>;
    typename Interval_traits<I>::Scope;
    { Interval_traits<I>::enclose(q) } -> std::same_as<I>;
    { Interval_traits<I>::hull(b, b) } -> std::same_as<I>;
    { Interval_traits<I>::lower(b) } -> std::same_as<I>;
    { Interval_traits<I>::upper(b) } -> std::same_as<I>;
    { Interval_traits<I>::exact_lower(b) } -> std::same_as<std::optional<Rational>>;
    { Interval_traits<I>::exact_upper(b) } -> std::same_as<std::optional<Rational>>;
    { Interval_traits<I>::lower_sign(b) } -> std::same_as<int>;
    { Interval_traits<I>::upper_sign(b) } -> std::same_as<int>;
    { b + b } -> std::convertible_to<I>;
    { b - b } -> std::convertible_to<I>;
    { b * b } -> std::convertible_to<I>;
    { -b } -> std::convertible_to<I>;
    { square(b) } -> std::convertible_to<I>;
    a += b;
    a -= b;
    a *= b;
  };
// clang-format on

/// Whether verdicts drawn from `I` are proofs.
template <class I>
inline constexpr bool is_guaranteed = Interval_traits<I>::is_guaranteed;

/// Whether `I` never rounds.
template <class I>
inline constexpr bool is_exact = Interval_traits<I>::is_exact;

/// The guard that must live on a thread while it computes with `I`.
template <class I>
using Arithmetic_scope = typename Interval_traits<I>::Scope;

/// The tightest `I` that contains `value`.
template <class I>
[[nodiscard]] I enclose(const Rational& value)
{
  return Interval_traits<I>::enclose(value);
}

/// The tightest `I` that contains [lower, upper]. \pre lower <= upper.
template <class I>
[[nodiscard]] I enclose(const Rational& lower, const Rational& upper)
{
  return Interval_traits<I>::hull(Interval_traits<I>::enclose(lower), Interval_traits<I>::enclose(upper));
}

/// The smallest interval that contains `a` and `b`.
template <IntervalNumber I>
[[nodiscard]] I hull(const I& a, const I& b)
{
  return Interval_traits<I>::hull(a, b);
}

/// `x * [0, 1]`, which is a comparison and not an operation of arithmetic.
template <IntervalNumber I>
[[nodiscard]] I hull_with_zero(const I& x)
{
  return Interval_traits<I>::hull(x, I(0));
}

/// `x * [-1, 1]`, which is a comparison and not an operation of arithmetic.
template <IntervalNumber I>
[[nodiscard]] I symmetric_hull(const I& x)
{
  return Interval_traits<I>::hull(x, -x);
}

/// The lower end point as a point interval.
template <IntervalNumber I>
[[nodiscard]] I lower(const I& x)
{
  return Interval_traits<I>::lower(x);
}

/// The upper end point as a point interval.
template <IntervalNumber I>
[[nodiscard]] I upper(const I& x)
{
  return Interval_traits<I>::upper(x);
}

/// The lower end point exactly, or nothing if the interval is unbounded below.
template <IntervalNumber I>
[[nodiscard]] std::optional<Rational> exact_lower(const I& x)
{
  return Interval_traits<I>::exact_lower(x);
}

/// The upper end point exactly, or nothing if the interval is unbounded above.
template <IntervalNumber I>
[[nodiscard]] std::optional<Rational> exact_upper(const I& x)
{
  return Interval_traits<I>::exact_upper(x);
}

/// 1 or -1 if every element of `x` has that sign, else 0.
template <IntervalNumber I>
[[nodiscard]] int strict_sign(const I& x)
{
  if (Interval_traits<I>::lower_sign(x) > 0) return 1;
  if (Interval_traits<I>::upper_sign(x) < 0) return -1;
  return 0;
}

/// Whether zero is an element of `x`.
template <IntervalNumber I>
[[nodiscard]] bool contains_zero(const I& x)
{
  return strict_sign(x) == 0;
}

/// Whether the number is an element of `x`.
template <IntervalNumber I>
[[nodiscard]] bool contains(const I& x, const Rational& value)
{
  const auto low = exact_lower(x);
  const auto high = exact_upper(x);
  return (!low || *low <= value) && (!high || value <= *high);
}

/// \brief `x` to the power `n`, never negative for even n.
/// \par Complexity  At most 2 log2(n) multiplications and squarings.
template <IntervalNumber I>
[[nodiscard]] I power(const I& x, unsigned n)
{
  if (n == 0) return I(1);
  if (n == 1) return x;
  const I root = power(x, n / 2);
  const I even = square(root);
  return n % 2 == 0 ? even : I(even * x);
}

} // namespace corral

#endif
