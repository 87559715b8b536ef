// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_NUMBER_INTERVAL_NUMBER_H
#define CORRAL_NUMBER_INTERVAL_NUMBER_H

#include <corral/errors.h>
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
///  - `enclose(Integer m, long e)` : the same for m * 2^e, if that can be had faster (optional);
///  - `is_number(I)`             : whether no end point is "not a number", which is neither a number nor an infinity;
///  - `hull(I, I)`               : the smallest interval that contains both;
///  - `intersection(I, I)`       : the greatest interval in both. Without a common element, as rounding to nearest may
///                       give, the gap between them; what is not a number restricts nothing;
///  - `lower(I)`, `upper(I)`     : an end point, which must be finite, as a point interval, exactly;
///  - `exact_lower(I)`, `exact_upper(I)` : an end point as `std::optional<Rational>`, empty
///                       where the interval is unbounded on that side (or not a number);
///  - `lower_sign(I)`, `upper_sign(I)`   : the sign of an end point, -1, 0 or 1. A value that is
///                       not a number has `lower_sign` -1 and `upper_sign` 1.
///
/// `I` itself is made of every `MachineNumber`, implicitly and exactly: as the tightest interval around it. An infinity
/// stands for numbers beyond the largest double, "not a number" for any number; a type that holds neither refuses them
/// with `Invalid_input`. No constructor narrows: what is not exact is not convertible.
template <class I>
struct Interval_traits;

namespace detail {

template <class I, class... T>
concept TakesAll = (std::convertible_to<T, I> && ...);

template <class I, class... T>
concept TakesNone = (!std::constructible_from<I, T> && ...);

// clang-format off
template <class I>
concept TakesMachineNumbers =
  TakesAll<I, signed char, unsigned char, short, unsigned short, int, unsigned, long, unsigned long, long long,
           unsigned long long, float, double>
  && TakesNone<I, bool, char, wchar_t, char16_t, char32_t, long double, Int128, Uint128>;
// clang-format on

} // namespace detail

/// \brief A closed interval of reals with arithmetic.
///
/// The compiler checks the syntax. `audit/audit_number.h` checks the contract of
/// *inclusion*: for every operation op and all reals x in X, y in Y, `X op Y` contains x op y.
/// A type whose traits say `is_guaranteed == false` promises no inclusion, and no verdict
/// drawn from it counts as proved.
// clang-format off
template <class I>
concept IntervalNumber =
  std::copyable<I> && std::default_initializable<I> && detail::TakesMachineNumbers<I>
  && requires(I a, const I b, const Rational& q) {
    { Interval_traits<I>::name } -> std::convertible_to<std::string_view>;
    { Interval_traits<I>::is_guaranteed } -> std::convertible_to<bool>;
    { Interval_traits<I>::is_exact } -> std::convertible_to<bool>;
    typename Interval_traits<I>::Scope;
    { Interval_traits<I>::enclose(q) } -> std::same_as<I>;
    { Interval_traits<I>::is_number(b) } -> std::same_as<bool>;
    { Interval_traits<I>::hull(b, b) } -> std::same_as<I>;
    { Interval_traits<I>::intersection(b, b) } -> std::same_as<I>;
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

/// \brief An interval that contains mantissa * 2^exponent: the tightest.
/// \par Complexity  Linear in the mantissa for doubles; otherwise that of the rational.
template <class I>
[[nodiscard]] I enclose(const Integer& mantissa, long exponent)
{
  if constexpr (requires { Interval_traits<I>::enclose(mantissa, exponent); })
    return Interval_traits<I>::enclose(mantissa, exponent);
  else {
    const Rational value(mantissa);
    return Interval_traits<I>::enclose(exponent < 0 ? Rational(value >> static_cast<mp_bitcnt_t>(-exponent))
                                                    : Rational(value << static_cast<mp_bitcnt_t>(exponent)));
  }
}

/// The tightest `I` that contains [lower, upper]. \pre lower <= upper.
template <class I>
[[nodiscard]] I enclose(const Rational& lower, const Rational& upper)
{
  CORRAL_PRECONDITION(lower <= upper, "enclose: given end points in the wrong order; expected lower <= upper");
  return Interval_traits<I>::hull(Interval_traits<I>::enclose(lower), Interval_traits<I>::enclose(upper));
}

/// The smallest interval that contains `a` and `b`.
template <IntervalNumber I>
[[nodiscard]] I hull(const I& a, const I& b)
{
  return Interval_traits<I>::hull(a, b);
}

/// Whether no end point of `x` is "not a number".
template <IntervalNumber I>
[[nodiscard]] bool is_number(const I& x)
{
  return Interval_traits<I>::is_number(x);
}

/// The greatest interval in both; without a common element, the gap between them.
template <IntervalNumber I>
[[nodiscard]] I intersection(const I& a, const I& b)
{
  return Interval_traits<I>::intersection(a, b);
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

/// Whether zero may be an element of `x`: the interval does not exclude it.
template <IntervalNumber I>
[[nodiscard]] bool contains_zero(const I& x)
{
  return strict_sign(x) == 0;
}

/// \brief Whether the number is an element of `x`. What is not a number, or has an infinite end on the wrong side,
/// contains nothing.
template <IntervalNumber I>
[[nodiscard]] bool contains(const I& x, const Rational& value)
{
  if (!is_number(x)) return false;
  const auto low = exact_lower(x);
  const auto high = exact_upper(x);
  return (low ? *low <= value : Interval_traits<I>::lower_sign(x) < 0)
         && (high ? value <= *high : Interval_traits<I>::upper_sign(x) > 0);
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
