// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_NUMBER_RATIONAL_H
#define CORRAL_NUMBER_RATIONAL_H

#include <gmpxx.h>

#include <string>
#include <string_view>

namespace corral {

/// Exact integers of any size (GMP).
using Integer = mpz_class;

/// Exact rationals of any size (GMP), always in lowest terms.
using Rational = mpq_class;

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
