// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_CHECKER_POLYNOMIAL_H
#define CORRAL_CHECKER_POLYNOMIAL_H

#include "document.h"

#include <array>
#include <map>
#include <vector>

namespace corral_check {

constexpr std::size_t max_dimension = 6;

/// One exponent for each axis; those from the dimension on are 0.
using Exponents = std::array<unsigned, max_dimension>;

/// The coefficients other than 0, sorted by exponents.
using Polynomial = std::map<Exponents, mpq_class>;

using Point = std::vector<mpq_class>;

/// A side of a box.
struct Side
{
  mpq_class lower;
  mpq_class upper;
  [[nodiscard]] bool is_flat() const { return lower == upper; }
};
using Box = std::vector<Side>;

/// Reads a polynomial by section 1. \throw Rejected if it breaks a rule or a limit.
[[nodiscard]] Polynomial read_polynomial(const Json& value, std::size_t dimension, const std::string& where);

/// The highest exponent of each axis.
[[nodiscard]] Exponents degrees(const Polynomial& f);

/// a + factor * b
void add_multiple(Polynomial& a, const Polynomial& b, const mpq_class& factor, const Exponents& shift, Budget& budget);

[[nodiscard]] Polynomial multiply(const Polynomial& a, const Polynomial& b, Budget& budget);

/// Whether `divisor` divides `f`, by exact division. \pre divisor is not zero.
[[nodiscard]] bool divides(const Polynomial& divisor, Polynomial f, Budget& budget);

/// The remainder of f on division by `divisor`, with respect to the variable of `axis`.
/// \pre divisor is monic in that variable, of degree at least 1.
[[nodiscard]] Polynomial remainder(Polynomial f, const Polynomial& divisor, std::size_t axis, Budget& budget);

/// f with the variable of `axis` set to a value.
[[nodiscard]] Polynomial restrict_to(const Polynomial& f, std::size_t axis, const mpq_class& value, Budget& budget);

/// The value at a point.
[[nodiscard]] mpq_class evaluate(const Polynomial& f, const Point& point, Budget& budget);

} // namespace corral_check

#endif
