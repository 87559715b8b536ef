// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_CERTIFICATE_CHECKING_COST_H
#define CORRAL_SRC_CERTIFICATE_CHECKING_COST_H

#include <corral/number/Rational.h>
#include <corral/polynomial/Polynomial.h>

#include <cmath>
#include <cstddef>

/// \file
/// What a checker will count, by doc/certificate.md, section 7: seen from the side that writes, which keeps to half.
namespace corral::certificate {

inline double bits(const Integer& value) { return static_cast<double>(mpz_sizeinbase(value.get_mpz_t(), 2)); }
inline double words(double bit_count) { return 1 + std::floor(bit_count / 64); }
inline double length(const Rational& value) { return words(bits(value.get_num())) + words(bits(value.get_den())); }

/// One operation on fractions of so many words in all.
inline double fraction_cost(double word_count) { return 20 * word_count * (1 + std::floor(word_count / 256)); }

/// The words of the longest coefficient.
template <class NT, std::size_t D>
double longest(const Polynomial<NT, D>& f)
{
  double result = 2;
  for (const auto& term : f.terms()) result = std::max(result, length(Rational(term.coefficient)));
  return result;
}

inline constexpr double max_work = 5e10;
inline constexpr double max_branch_words = 33554432; ///< 2^25

} // namespace corral::certificate

#endif
