// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_POLYNOMIAL_SQUARE_FREE_H
#define CORRAL_POLYNOMIAL_SQUARE_FREE_H

#include <corral/internal/polynomial/Flat_terms.h>
#include <corral/polynomial/integer_form.h>

#include <cstddef>

namespace corral {
namespace detail {

/// Divides a non-zero polynomial by the greatest common divisor of its derivatives and itself.
/// The sign is kept. \throw Budget_exceeded; Wrong_answer.
[[nodiscard]] Flat_terms square_free_part(const Flat_terms& f);

/// Whether the image of f on one line along each axis, modulo a prime, has no repeated factor.
[[nodiscard]] bool is_surely_square_free(const Flat_terms& f);

} // namespace detail

/// \brief The product of the distinct irreducible factors of `f`, as a primitive integer polynomial:
/// the same real and complex zeros as `f`, each factor once.
///
/// The leading coefficient (of the last term) has the sign of that of `f`. The square-free part of
/// zero is zero, and that of another constant is 1 or -1.
///
/// \throw Budget_exceeded if the greatest common divisor does not fit in memory; Wrong_answer if FLINT errs.
/// \par Complexity  One or a few multivariate greatest common divisors (FLINT's modular methods).
/// \par Reference  f / gcd(f, f_1, ..., f_D) is square-free in characteristic zero: Geddes, Czapor,
///      Labahn, Algorithms for Computer Algebra, chapter 8.
template <std::size_t D>
[[nodiscard]] Polynomial<Integer, D> square_free_part(const Polynomial<Integer, D>& f)
{
  if (f.is_zero()) return f;
  return primitive_part(detail::from_flat_terms<D>(detail::square_free_part(detail::flat_terms(f))));
}

/// The same for rational coefficients.
template <std::size_t D>
[[nodiscard]] Polynomial<Integer, D> square_free_part(const Polynomial<Rational, D>& f)
{
  return square_free_part(integer_primitive(f));
}

/// \brief A quick test: `true` proves that `f` has no repeated factor; `false` says that it has one, or, by rare
/// chance, nothing. \pre f is not zero. \par Complexity  A product for each term and axis modulo a prime below 2^62,
/// and n^2 for degree n in one variable. \par Reference  doc/exact.md, section 8.
template <std::size_t D>
[[nodiscard]] bool is_surely_square_free(const Polynomial<Rational, D>& f)
{
  return detail::is_surely_square_free(detail::flat_terms(integer_form(f).numerator));
}

} // namespace corral

#endif
