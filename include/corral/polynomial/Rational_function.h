// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_POLYNOMIAL_RATIONAL_FUNCTION_H
#define CORRAL_POLYNOMIAL_RATIONAL_FUNCTION_H

#include <corral/polynomial/Polynomial.h>

#include <cstddef>

namespace corral {

/// \brief A quotient of polynomials, as it is written: nothing is cancelled.
///
/// Where the denominator is zero the function is not defined, and so not zero: x^2/x has no zero.
template <std::size_t D>
struct Rational_function
{
  Polynomial<Rational, D> numerator;
  Polynomial<Rational, D> denominator = constant<Rational, D>(1); ///< not the zero polynomial

  /// Whether the denominator has a variable.
  [[nodiscard]] bool has_poles() const { return !denominator.is_constant(); }
};

} // namespace corral

#endif
