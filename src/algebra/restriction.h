// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_ALGEBRA_RESTRICTION_H
#define CORRAL_SRC_ALGEBRA_RESTRICTION_H

#include <corral/polynomial/Box.h>
#include <corral/polynomial/Polynomial.h>

#include <cstddef>
#include <vector>

namespace corral::exact {

/// numerator^e denominator^(degree - e) for e = 0, ..., degree: the powers of the value, times one positive number.
[[nodiscard]] std::vector<Integer> homogeneous_powers(const Rational& value, std::size_t degree);

/// g with one variable set to a rational value, times a positive integer, as a polynomial in the others.
template <std::size_t D>
[[nodiscard]] Polynomial<Integer, D - 1> restriction(const Polynomial<Integer, D>& g, std::size_t axis,
                                                     const Rational& value);

/// Whether g is zero at the point.
template <std::size_t D>
[[nodiscard]] bool vanishes_at(const Polynomial<Integer, D>& g, const Rational_point<D>& point);

} // namespace corral::exact

#endif
