// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_NUMBER_DOUBLE_BRACKET_H
#define CORRAL_NUMBER_DOUBLE_BRACKET_H

#include <corral/number/Rational.h>

#include <cmath>
#include <limits>
#include <string_view>
#include <type_traits>

namespace corral {

/// \brief The doubles around a rational number, infinities included.
///
/// `below` and `above` are the tightest: equal where the number is a double. `nearest` is one of the two, the one
/// with an even mantissa on a tie.
struct Double_bracket
{
  double below = 0;
  double nearest = 0;
  double above = 0;
};

/// \brief The doubles around `value`, found with integers only: right at subnormals and beyond the largest double, and
/// independent of the rounding mode.
/// \par Complexity  Two divisions of integers of the size of `value`.
[[nodiscard]] Double_bracket bracket(const Rational& value);

/// \brief The doubles around mantissa * 2^exponent, likewise. \par Complexity  Linear in the length of the mantissa.
[[nodiscard]] Double_bracket bracket(const Integer& mantissa, long exponent);

/// \brief The doubles around a built-in number, likewise. An infinity stands for a number beyond the largest double,
/// and what is not a number could be any.
template <MachineNumber T>
[[nodiscard]] Double_bracket bracket(T value)
{
  using Limits = std::numeric_limits<double>;
  const auto nearest = static_cast<double>(value); // exact in the cases that return it
  if constexpr (std::is_floating_point_v<T>) {
    if (std::isfinite(nearest)) return {nearest, nearest, nearest};
    if (std::isnan(nearest)) return {-Limits::infinity(), nearest, Limits::infinity()};
    return nearest > 0 ? Double_bracket{Limits::max(), nearest, nearest}
                       : Double_bracket{nearest, nearest, -Limits::max()};
  } else if constexpr (std::numeric_limits<T>::digits <= Limits::digits) {
    return {nearest, nearest, nearest};
  } else {
    constexpr T exact = T{1} << Limits::digits;
    if (value <= exact && (std::is_unsigned_v<T> || value >= T{0} - exact)) return {nearest, nearest, nearest};
    return bracket(exact_value(value));
  }
}

namespace detail {

/// \throw Invalid_input always: `who` complains of end points in the wrong order.
[[noreturn]] void refuse_order(std::string_view who, double lower, double upper);

} // namespace detail

} // namespace corral

#endif
