// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_EXACT_MULTIVARIATE_H
#define CORRAL_EXACT_MULTIVARIATE_H

#include <corral/polynomial/Polynomial.h>

#include <cstddef>
#include <optional>

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

/// \brief The resultant of f and g with respect to the last variable, square-free and primitive; zero if they have a
/// common factor. Nothing if FLINT gives up.
[[nodiscard]] std::optional<Polynomial<Integer, 2>> projection(const Polynomial<Integer, 3>& f,
                                                               const Polynomial<Integer, 3>& g);

} // namespace corral::exact

#endif
