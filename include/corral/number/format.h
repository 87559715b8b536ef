// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_NUMBER_FORMAT_H
#define CORRAL_NUMBER_FORMAT_H

#include <corral/number/Interval_number.h>

#include <optional>
#include <string>

/// \file
/// Intervals as text: exactly, so that `parse_rational` gives the same end points back, or as decimals that enclose.
namespace corral {

/// \brief `value` as a hexadecimal float, `0x1.8p+1`, of any length.
/// \throw Invalid_input unless the denominator is a power of two.
[[nodiscard]] std::string to_hex_float(const Rational& value);

/// \brief The greatest decimal of `digits` significant digits that is not above `value`.
/// \throw Invalid_input unless digits >= 1.
[[nodiscard]] std::string decimal_below(const Rational& value, int digits);

/// \brief The least decimal of `digits` significant digits that is not below `value`.
/// \throw Invalid_input unless digits >= 1.
[[nodiscard]] std::string decimal_above(const Rational& value, int digits);

/// \brief `[lower, upper]`, exactly: fractions for an exact type, hexadecimal floats for all others, `-inf` and `inf`.
template <IntervalNumber I>
[[nodiscard]] std::string exact_text(const I& x)
{
  const auto text = [](const Rational& end) { return is_exact<I> ? to_string(end) : to_hex_float(end); };
  const auto low = exact_lower(x);
  const auto high = exact_upper(x);
  return std::string("[") + (low ? text(*low) : "-inf") + ", " + (high ? text(*high) : "inf") + "]";
}

/// `[lower, upper]` in decimals of `digits` significant digits, rounded outward.
/// \throw Invalid_input unless digits >= 1.
template <IntervalNumber I>
[[nodiscard]] std::string decimal_text(const I& x, int digits = 17)
{
  const auto low = exact_lower(x);
  const auto high = exact_upper(x);
  return std::string("[") + (low ? decimal_below(*low, digits) : "-inf") + ", "
         + (high ? decimal_above(*high, digits) : "inf") + "]";
}

} // namespace corral

#endif
