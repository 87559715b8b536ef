// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_ALGEBRA_MULTIVARIATE_H
#define CORRAL_SRC_ALGEBRA_MULTIVARIATE_H

#include "../polynomial/verification.h"

#include <corral/polynomial/Polynomial.h>

#include <cstddef>
#include <vector>

/// \file
/// Algebra of polynomials in several variables that is left to FLINT, and verified. Everything here throws
/// Budget_exceeded if FLINT gives up, and Wrong_answer if what it says is not true.
namespace corral::exact {

/// f and g over their greatest common divisor.
template <std::size_t D>
struct Common_factor
{
  Polynomial<Integer, D> divisor;
  Polynomial<Integer, D> f;
  Polynomial<Integer, D> g;
};

/// \pre Neither is zero.
template <std::size_t D>
[[nodiscard]] Common_factor<D> common_factor(const Polynomial<Integer, D>& f, const Polynomial<Integer, D>& g,
                                             const detail::Flint_functions& flint = {});

/// \brief The distinct irreducible factors over the rationals that are not constant.
///
/// That the product of their powers is f, up to a constant, is verified; not that they are irreducible.
/// \pre f is not zero.
template <std::size_t D>
[[nodiscard]] std::vector<Polynomial<Integer, D>> irreducible_factors(const Polynomial<Integer, D>& f,
                                                                      const detail::Flint_functions& flint = {});

/// \brief The resultant of f and g with respect to the last variable; zero if they have a common factor with it.
///
/// It is compared with the resultants of f and g at two points modulo a prime that FLINT has not used.
[[nodiscard]] Polynomial<Integer, 2> resultant(const Polynomial<Integer, 3>& f, const Polynomial<Integer, 3>& g,
                                               const detail::Flint_functions& flint = {});

} // namespace corral::exact

#endif
