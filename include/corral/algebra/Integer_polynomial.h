// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_ALGEBRA_INTEGER_POLYNOMIAL_H
#define CORRAL_ALGEBRA_INTEGER_POLYNOMIAL_H

#include <corral/algebra/Checkpoint.h>
#include <corral/number/Rational.h>
#include <corral/number/Rational_interval.h>
#include <corral/polynomial/Polynomial.h>

#include <cstddef>
#include <vector>

/// \file
/// Dense polynomials in one variable over the integers, the material of root isolation.
namespace corral {

/// \brief The coefficients from the constant one up. The last one is not zero; the zero polynomial is empty.
using Integer_polynomial = std::vector<Integer>;

/// Drops vanishing leading coefficients.
void trim(Integer_polynomial& p);

/// The degree; 0 for constants and for the zero polynomial.
[[nodiscard]] inline std::size_t degree(const Integer_polynomial& p) { return p.empty() ? 0 : p.size() - 1; }

/// The dense form of `p` times the smallest positive integer that clears its denominators.
[[nodiscard]] Integer_polynomial integer_polynomial(const Polynomial<Rational, 1>& p);

/// \brief The sign of p(x). \par Complexity  one Horner step over integers for each coefficient.
[[nodiscard]] int sign_at(const Integer_polynomial& p, const Rational& x);

/// p(x) exactly.
[[nodiscard]] Rational evaluate(const Integer_polynomial& p, const Rational& x);

/// An interval that contains p(x) for every x of the argument (Horner's rule over exact intervals).
[[nodiscard]] Rational_interval evaluate(const Integer_polynomial& p, const Rational_interval& x);

[[nodiscard]] Integer_polynomial derivative(const Integer_polynomial& p);
[[nodiscard]] Integer_polynomial multiply(const Integer_polynomial& p, const Integer_polynomial& q);

/// p divided by the greatest common divisor of its coefficients, with positive leading coefficient.
[[nodiscard]] Integer_polynomial primitive_part(Integer_polynomial p);

/// \brief p / q. \pre q divides p over the integers and is not zero.
[[nodiscard]] Integer_polynomial exact_quotient(const Integer_polynomial& p, const Integer_polynomial& q);

/// Whether q divides p over the rationals. \pre q is not zero.
[[nodiscard]] bool divides(const Integer_polynomial& q, const Integer_polynomial& p);

/// \brief The primitive greatest common divisor, by images modulo primes and a trial division that proves it.
/// \pre not both are zero. \throw whatever `checkpoint` throws; it is called for each prime.
/// \par Reference  Brown 1971; von zur Gathen and Gerhard, "Modern Computer Algebra", 6.7.
[[nodiscard]] Integer_polynomial greatest_common_divisor(const Integer_polynomial& p, const Integer_polynomial& q,
                                                         const Checkpoint& checkpoint = {});

/// p without its multiplicities, primitive. \pre p is not zero.
[[nodiscard]] Integer_polynomial square_free_part(const Integer_polynomial& p, const Checkpoint& checkpoint = {});

/// \brief Square-free, pairwise coprime factors: p = c * product of result[k]^(k+1).
/// \pre p is not zero. \par Reference  Yun 1976.
[[nodiscard]] std::vector<Integer_polynomial> square_free_decomposition(const Integer_polynomial& p,
                                                                        const Checkpoint& checkpoint = {});

/// A positive multiple of p(offset + scale * x), primitive. \pre scale > 0.
[[nodiscard]] Integer_polynomial compose_affine(const Integer_polynomial& p, const Rational& offset,
                                                const Rational& scale, const Checkpoint& checkpoint = {});

} // namespace corral

#endif
