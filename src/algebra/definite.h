// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_ALGEBRA_DEFINITE_H
#define CORRAL_SRC_ALGEBRA_DEFINITE_H

#include <corral/polynomial/Polynomial.h>

#include <cstddef>

namespace corral::exact {

/// \brief Whether f times some number is s^2 + r with a polynomial s and a positive number r, so that f has no real
/// zero.
///
/// Where f is that, s divides the gradient of f and leaves r (doc/exact.md, section 1). `false` says nothing.
/// \pre f is not constant. \par Complexity  D - 1 greatest common divisors, as a rule of coprime polynomials.
template <std::size_t D>
[[nodiscard]] bool is_square_plus_constant(const Polynomial<Integer, D>& f);

} // namespace corral::exact

#endif
