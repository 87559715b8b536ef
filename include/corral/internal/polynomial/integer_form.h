// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_INTERNAL_POLYNOMIAL_INTEGER_FORM_H
#define CORRAL_INTERNAL_POLYNOMIAL_INTEGER_FORM_H

#include <corral/errors.h>
#include <corral/polynomial/Polynomial.h>

#include <cstddef>
#include <string>

/// \file
/// A rational polynomial as integers over one common denominator. Arithmetic on integers needs no
/// greatest common divisor in every operation, as arithmetic on fractions does.
namespace corral {

/// The polynomial numerator / denominator. \invariant denominator > 0.
template <std::size_t D>
struct Integer_form
{
  Polynomial<Integer, D> numerator;
  Integer denominator = 1;
};

/// \brief `f` over the least common denominator of its coefficients.
/// \throw Budget_exceeded if the integers would take more than half a gigabyte, as with very many
///        unrelated denominators.
/// \par Complexity  Two greatest common divisors a term.
template <std::size_t D>
[[nodiscard]] Integer_form<D> integer_form(const Polynomial<Rational, D>& f)
{
  Integer_form<D> result;
  constexpr std::size_t max_words = std::size_t{1} << 26;
  for (const auto& term : f.terms()) {
    if (term.coefficient.get_den() == 1) continue;
    result.denominator = lcm(result.denominator, term.coefficient.get_den());
    if (mpz_size(result.denominator.get_mpz_t()) * f.terms().size() > max_words)
      throw Budget_exceeded(
          "common denominator: it has " + std::to_string(mpz_sizeinbase(result.denominator.get_mpz_t(), 2))
          + " bits for a polynomial of " + std::to_string(f.terms().size()) + " terms; expected less");
  }
  result.numerator = transform<Integer>(f, [&](const Rational& c) {
    return c.get_den() == result.denominator ? c.get_num()
                                             : Integer(c.get_num() * Integer(result.denominator / c.get_den()));
  });
  return result;
}

/// The rational polynomial that `form` stands for, every coefficient in lowest terms.
template <std::size_t D>
[[nodiscard]] Polynomial<Rational, D> to_rational(const Integer_form<D>& form)
{
  return transform<Rational>(form.numerator, [&](const Integer& c) {
    if (form.denominator == 1) return Rational(c);
    Rational value(c, form.denominator);
    value.canonicalize();
    return value;
  });
}

/// The greatest common divisor of the coefficients; 0 for the zero polynomial.
template <std::size_t D>
[[nodiscard]] Integer content(const Polynomial<Integer, D>& f)
{
  Integer divisor = 0;
  for (const auto& term : f.terms()) {
    divisor = gcd(divisor, term.coefficient);
    if (divisor == 1) break;
  }
  return divisor;
}

/// `f` divided by its (positive) content, so that it keeps its sign everywhere.
template <std::size_t D>
[[nodiscard]] Polynomial<Integer, D> primitive_part(const Polynomial<Integer, D>& f)
{
  const Integer divisor = content(f);
  if (divisor <= 1) return f;
  return transform<Integer>(f, [&](const Integer& c) {
    Integer quotient;
    mpz_divexact(quotient.get_mpz_t(), c.get_mpz_t(), divisor.get_mpz_t());
    return quotient;
  });
}

/// \brief The primitive integer polynomial that is a positive multiple of `f`: the same zero set
/// and the same sign at every point.
template <std::size_t D>
[[nodiscard]] Polynomial<Integer, D> integer_primitive(const Polynomial<Rational, D>& f)
{
  return primitive_part(integer_form(f).numerator);
}

} // namespace corral

#endif
