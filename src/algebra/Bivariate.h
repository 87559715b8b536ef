// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_ALGEBRA_BIVARIATE_H
#define CORRAL_SRC_ALGEBRA_BIVARIATE_H

#include <corral/algebra/real_roots.h>

#include <cstddef>
#include <vector>

namespace corral::exact {

/// A polynomial in y with coefficients in Z[x], from the constant one up; the last one is not zero.
using Bivariate = std::vector<Integer_polynomial>;

/// `f` as a polynomial in the variable `main` over the ring of the other one.
[[nodiscard]] Bivariate bivariate(const Polynomial<Integer, 2>& f, std::size_t main);

/// The inverse of `bivariate`.
[[nodiscard]] Polynomial<Integer, 2> polynomial(const Bivariate& f, std::size_t main);

/// The primitive greatest common divisor of the coefficients in Z[x]. \pre f is not zero.
[[nodiscard]] Integer_polynomial content(const Bivariate& f);

[[nodiscard]] Bivariate derivative(const Bivariate& f);

/// What eliminating y from f and g leaves in Z[x].
struct Elimination
{
  Integer_polynomial resultant; ///< zero iff f and g have a common factor
  Integer_polynomial s1;        ///< s1 y + s0 is the linear subresultant; both zero if it is not known
  Integer_polynomial s0;
};

/// \brief The resultant of f and g with respect to y and their linear subresultant.
///
/// Evaluation at enough x modulo enough primes; the sizes are bounded in advance (Hadamard), nothing is left to chance.
/// The result is verified by `require_elimination`.
/// \pre Neither is zero. \throw whatever `checkpoint` throws; it is called for each point.
/// \par Reference  Collins 1971, "The calculation of multivariate polynomial resultants".
[[nodiscard]] Elimination eliminate(const Bivariate& f, const Bivariate& g, const Checkpoint& checkpoint = {});

/// \brief Compares an elimination with another one at a point modulo a prime that was not used for it.
/// \throw Wrong_answer if they differ. \pre as `eliminate`.
void require_elimination(const Elimination& elimination, const Bivariate& f, const Bivariate& g);

} // namespace corral::exact

#endif
