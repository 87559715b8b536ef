// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_NUMBER_RATIONAL_H
#define CORRAL_NUMBER_RATIONAL_H

#include <corral/build_mode.h>

#include <gmpxx.h>

#include <concepts>
#include <string>
#include <string_view>
#include <type_traits>

namespace corral {

/// Exact integers of any size (GMP).
using Integer = mpz_class;

/// Exact rationals of any size (GMP), always in lowest terms.
using Rational = mpq_class;

namespace detail {

template <class T, class... Others>
concept OneOf = (std::same_as<T, Others> || ...);

__extension__ typedef __int128 Int128;
__extension__ typedef unsigned __int128 Uint128;

} // namespace detail

/// \brief The built-in numbers that every number type takes, and takes exactly: integers of up to 64 bits, `float` and
/// `double`. Truth values and characters are no numbers; `long double` and 128 bits are not portable.
template <class T>
concept MachineNumber = detail::OneOf<T, signed char, unsigned char, short, unsigned short, int, unsigned, long,
                                      unsigned long, long long, unsigned long long, float, double>;

/// The other built-in types of numbers, which no number type takes.
template <class T>
concept UnfitNumber =
    !MachineNumber<T> && (std::is_arithmetic_v<T> || detail::OneOf<T, detail::Int128, detail::Uint128>);

/// The number exactly. \throw Invalid_input if it is infinite or not a number.
[[nodiscard]] Rational exact_value(double value);
[[nodiscard]] Rational exact_value(long long value);
[[nodiscard]] Rational exact_value(unsigned long long value);
template <MachineNumber T>
[[nodiscard]] Rational exact_value(T value)
{
  if constexpr (std::is_floating_point_v<T>)
    return exact_value(static_cast<double>(value));
  else if constexpr (sizeof(T) <= sizeof(long))
    return Rational(value);
  else if constexpr (std::is_signed_v<T>)
    return exact_value(static_cast<long long>(value));
  else
    return exact_value(static_cast<unsigned long long>(value));
}

/// \brief Reads a number exactly: an integer, a decimal (`-1.5e-3`, `.5`), a fraction of integers
/// (`15/4`) or a hexadecimal float (`0x1.8p-3`), with an optional sign and nothing around it.
/// \throw Parse_error if the text is anything else, has a zero denominator, a decimal exponent beyond +-100000 or a
///        binary one beyond +-400000 (such values would fill the memory).
/// \par Complexity  Quasi-linear in the number of digits of the value.
[[nodiscard]] Rational parse_rational(std::string_view text);

/// \brief `p` or `p/q` in decimal; `parse_rational` gives the same number back.
[[nodiscard]] std::string to_string(const Rational& value);

} // namespace corral

#endif
