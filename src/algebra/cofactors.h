// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_ALGEBRA_COFACTORS_H
#define CORRAL_SRC_ALGEBRA_COFACTORS_H

#include <corral/internal/algebra/Checkpoint.h>
#include <corral/number/Rational.h>
#include <corral/polynomial/Polynomial.h>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace corral::exact {

/// a f + b g = combination, where the combination lacks one variable.
template <std::size_t D>
struct Cofactors
{
  Polynomial<Integer, D> a;
  Polynomial<Integer, D> b;
  Polynomial<Integer, D> combination;
};

/// \brief Eliminates the variable of `axis` from f and g: the cofactors of their resultant, over what a, b and the
/// resultant have in common.
///
/// Evaluation at enough points modulo primes, until the identity holds over the integers, which is checked.
/// \return nothing if f and g have a common factor with that variable, or if the degrees are too high to try.
/// \pre f has a positive degree in the variable, and g is not zero. \throw whatever `checkpoint` throws.
/// \par Reference  Collins 1971; von zur Gathen and Gerhard, "Modern Computer Algebra", 6.
template <std::size_t D>
[[nodiscard]] std::optional<Cofactors<D>> cofactors(const Polynomial<Integer, D>& f, const Polynomial<Integer, D>& g,
                                                    std::size_t axis, const Checkpoint& checkpoint = {});

/// The square-free factors of f with their exponents, without constants. \throw Budget_exceeded if FLINT gives up.
template <std::size_t D>
[[nodiscard]] std::vector<std::pair<Polynomial<Integer, D>, unsigned>>
square_free_factors(const Polynomial<Integer, D>& f);

} // namespace corral::exact

#endif
