// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_ALGEBRA_MULTIVARIATE_H
#define CORRAL_SRC_ALGEBRA_MULTIVARIATE_H

#include <corral/polynomial/Polynomial.h>

#include <cstddef>
#include <vector>

/// \file
/// Algebra of polynomials in several variables that is left to FLINT.
namespace corral::exact {

/// f and g over their greatest common divisor.
template <std::size_t D>
struct Common_factor
{
  Polynomial<Integer, D> divisor;
  Polynomial<Integer, D> f;
  Polynomial<Integer, D> g;
};

/// \throw Budget_exceeded if FLINT gives up. \pre Neither is zero.
template <std::size_t D>
[[nodiscard]] Common_factor<D> common_factor(const Polynomial<Integer, D>& f, const Polynomial<Integer, D>& g);

/// The distinct irreducible factors over the rationals that are not constant. \throw Budget_exceeded if FLINT gives up.
[[nodiscard]] std::vector<Polynomial<Integer, 3>> irreducible_factors(const Polynomial<Integer, 3>& f);

/// \brief The resultant of f and g with respect to the last variable; zero if they have a common factor with it.
/// \throw Budget_exceeded if FLINT gives up.
[[nodiscard]] Polynomial<Integer, 2> resultant(const Polynomial<Integer, 3>& f, const Polynomial<Integer, 3>& g);

} // namespace corral::exact

#endif
