// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_CHECKER_POLYNOMIAL_H
#define CORRAL_CHECKER_POLYNOMIAL_H

#include "budget.h"
#include "json.h"

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
[[nodiscard]] Polynomial read_polynomial(const Value& value, std::size_t dimension, const std::string& where);

/// The highest exponent of each axis.
[[nodiscard]] Exponents degrees(const Polynomial& f);

/// The highest sum of the exponents of a term.
[[nodiscard]] unsigned total_degree(const Polynomial& f);

/// \brief A polynomial that is added up, within the limits of section 7.
class Sum
{
public:
  explicit Sum(Budget& budget) : budget_(&budget) {}
  Sum(Polynomial start, Budget& budget);

  /// Adds factor * x^shift * f.
  void add(const Polynomial& f, const mpq_class& factor, const Exponents& shift);
  /// Adds a * b.
  void add_product(const Polynomial& a, const Polynomial& b);
  /// Adds one term.
  void add_term(const Exponents& exponents, const mpq_class& coefficient);

  [[nodiscard]] const Polynomial& value() const { return terms_; }
  [[nodiscard]] Polynomial take() && { return std::move(terms_); }

private:
  Budget* budget_;
  Polynomial terms_;
  double held_ = 0; ///< words
};

struct Division
{
  Polynomial quotient;
  Polynomial remainder;
};

/// \brief Division by one polynomial in the lexicographic order. The remainder is 0 iff the divisor divides f.
/// \pre divisor is not zero.
[[nodiscard]] Division divide(const Polynomial& f, const Polynomial& divisor, Budget& budget);

/// The remainder of f on division by `divisor`, with respect to the variable of `axis`.
/// \pre divisor is monic in that variable, of degree at least 1.
[[nodiscard]] Polynomial remainder(Polynomial f, const Polynomial& divisor, std::size_t axis, Budget& budget);

/// Whether f divides g^k. \pre neither is zero.
[[nodiscard]] bool divides_power(const Polynomial& f, const Polynomial& g, std::uint64_t k, Budget& budget);

[[nodiscard]] Polynomial derivative(const Polynomial& f, std::size_t axis);

/// f with the variable of `axis` set to a value.
[[nodiscard]] Polynomial restrict_to(const Polynomial& f, std::size_t axis, const mpq_class& value, Budget& budget);

/// The value at a point.
[[nodiscard]] mpq_class evaluate(const Polynomial& f, const Point& point, Budget& budget);

/// Such as `-1 + 1/3*x*y^2`.
[[nodiscard]] std::string to_text(const Polynomial& f, const std::vector<std::string>& variables);

} // namespace corral_check

#endif
