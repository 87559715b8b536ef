// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_ALGEBRA_INTEGER_POLYNOMIAL_H
#define CORRAL_ALGEBRA_INTEGER_POLYNOMIAL_H

#include <corral/errors.h>
#include <corral/internal/algebra/Checkpoint.h>
#include <corral/number/Rational.h>
#include <corral/number/Rational_interval.h>
#include <corral/polynomial/Polynomial.h>

#include <cstddef>
#include <initializer_list>
#include <utility>
#include <vector>

/// \file
/// Dense polynomials in one variable over the integers, the material of root isolation.
namespace corral {

/// \brief A polynomial by its coefficients, from the constant one up; a value that does not change but as a whole.
/// \invariant The last coefficient is not zero, and the zero polynomial has none.
class Integer_polynomial
{
public:
  /// The zero polynomial.
  Integer_polynomial() = default;
  /// The polynomial with these coefficients; vanishing leading ones are dropped.
  explicit Integer_polynomial(std::vector<Integer> coefficients) : coefficients_(std::move(coefficients))
  {
    while (!coefficients_.empty() && coefficients_.back() == 0) coefficients_.pop_back();
  }
  Integer_polynomial(std::initializer_list<Integer> coefficients)
      : Integer_polynomial(std::vector<Integer>(coefficients))
  {}

  [[nodiscard]] const std::vector<Integer>& coefficients() const { return coefficients_; }
  [[nodiscard]] bool is_zero() const { return coefficients_.empty(); }
  /// How many coefficients there are: the degree + 1, or 0 for the zero polynomial.
  [[nodiscard]] std::size_t size() const { return coefficients_.size(); }
  /// The coefficient of x^i. \pre i < size().
  [[nodiscard]] const Integer& operator[](std::size_t i) const
  {
    CORRAL_PRECONDITION(i < size(), "Integer_polynomial: given an index above the degree");
    return coefficients_[i];
  }
  /// The leading coefficient. \pre The polynomial is not zero.
  [[nodiscard]] const Integer& lead() const
  {
    CORRAL_PRECONDITION(!is_zero(), "Integer_polynomial: asked for the leading coefficient of zero");
    return coefficients_.back();
  }
  [[nodiscard]] auto begin() const { return coefficients_.begin(); }
  [[nodiscard]] auto end() const { return coefficients_.end(); }

  friend bool operator==(const Integer_polynomial&, const Integer_polynomial&) = default;

private:
  std::vector<Integer> coefficients_;
};

/// The degree; 0 for constants and for the zero polynomial.
[[nodiscard]] inline std::size_t degree(const Integer_polynomial& p) { return p.is_zero() ? 0 : p.size() - 1; }

/// The dense form of `p` times the smallest positive integer that clears its denominators.
[[nodiscard]] Integer_polynomial integer_polynomial(const Polynomial<Rational, 1>& p);

/// \brief The sign of p(x). \par Complexity  one Horner step over integers for each coefficient.
[[nodiscard]] int sign_at(const Integer_polynomial& p, const Rational& x);

/// p(x) exactly.
[[nodiscard]] Rational evaluate(const Integer_polynomial& p, const Rational& x);

/// An interval that contains p(x) for every x of the argument (Horner's rule over exact intervals).
[[nodiscard]] Rational_interval evaluate(const Integer_polynomial& p, const Rational_interval& x);

[[nodiscard]] Integer_polynomial derivative(const Integer_polynomial& p);
[[nodiscard]] Integer_polynomial multiply(const Integer_polynomial& p, const Integer_polynomial& q);

/// The greatest common divisor of the coefficients; 0 for the zero polynomial.
[[nodiscard]] Integer content(const Integer_polynomial& p);

/// `p` divided by its (positive) content, so that it keeps its sign everywhere; as in several variables.
[[nodiscard]] Integer_polynomial primitive_part(const Integer_polynomial& p);

/// The primitive part of p or -p with positive leading coefficient: one for all multiples of p by numbers.
[[nodiscard]] Integer_polynomial normalized(const Integer_polynomial& p);

/// \brief p / q. \throw Invalid_input unless q divides p over the integers and is not zero.
[[nodiscard]] Integer_polynomial exact_quotient(const Integer_polynomial& p, const Integer_polynomial& q);

/// Whether q divides p over the rationals. \throw Invalid_input if q is zero.
[[nodiscard]] bool divides(const Integer_polynomial& q, const Integer_polynomial& p);

/// \brief The greatest common divisor, normalized (0 of zero and zero), by images modulo primes and a trial division
/// that proves it. \throw whatever `checkpoint` throws; it is called for each prime. \par Reference  Brown 1971; von
/// zur Gathen and Gerhard, "Modern Computer Algebra", 6.7.
[[nodiscard]] Integer_polynomial greatest_common_divisor(const Integer_polynomial& p, const Integer_polynomial& q,
                                                         const Checkpoint& checkpoint = {});

/// p without its multiplicities, normalized. \throw Invalid_input if p is zero.
[[nodiscard]] Integer_polynomial square_free_part(const Integer_polynomial& p, const Checkpoint& checkpoint = {});

/// \brief Square-free, pairwise coprime factors, normalized: p = c * product of result[k]^(k+1).
/// \throw Invalid_input if p is zero. \par Reference  Yun 1976.
[[nodiscard]] std::vector<Integer_polynomial> square_free_decomposition(const Integer_polynomial& p,
                                                                        const Checkpoint& checkpoint = {});

/// Whether p has no multiple root, real or complex.
[[nodiscard]] bool is_square_free(const Integer_polynomial& p);

/// A positive multiple of p(offset + scale * x), primitive. \throw Invalid_input unless scale > 0.
[[nodiscard]] Integer_polynomial compose_affine(const Integer_polynomial& p, const Rational& offset,
                                                const Rational& scale, const Checkpoint& checkpoint = {});

} // namespace corral

#endif
