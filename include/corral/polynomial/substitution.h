// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_POLYNOMIAL_SUBSTITUTION_H
#define CORRAL_POLYNOMIAL_SUBSTITUTION_H

#include <corral/errors.h>
#include <corral/internal/polynomial/integer_form.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

/// \file
/// Exact affine changes of the variables.
namespace corral {
namespace detail {

/// The univariate substitution x = (offset_numerator + scale_numerator/scale_denominator u) / offset_denominator on
/// integer coefficients.
class Line_substitution
{
public:
  Line_substitution(const Rational& offset, const Rational& scale, unsigned degree);

  /// The result of `apply` is the substituted polynomial times this positive number.
  [[nodiscard]] Integer denominator() const;

  /// Replaces the coefficients (lowest first) of f(x) by those of
  /// `denominator() * f(offset + scale u)`. \pre There are degree + 1. \par Complexity  degree^2 / 2 products.
  void apply(std::vector<Integer>& coefficients) const;

private:
  Integer offset_; // numerator of the offset
  std::vector<Integer> offset_denominator_powers_;
  std::vector<Integer> factors_; // one for each power of u
};

/// Substitutes in the last variable and makes it the first, so that D calls come full circle.
template <std::size_t D>
void substitute_and_rotate(Integer_form<D>& f, const Rational& offset, const Rational& scale, std::size_t max_terms)
{
  using Term = typename Polynomial<Integer, D>::Term;
  const unsigned degree = f.numerator.degree(D - 1);
  const Line_substitution substitution(offset, scale, degree);
  std::vector<Term> result;
  std::vector<Integer> line(degree + 1);
  const auto& terms = f.numerator.terms();
  for (auto begin = terms.begin(); begin != terms.end();) {
    std::fill(line.begin(), line.end(), 0);
    auto end = begin;
    for (;
         end != terms.end() && std::equal(begin->exponents.begin(), begin->exponents.end() - 1, end->exponents.begin());
         ++end)
      line[end->exponents[D - 1]] = end->coefficient;
    substitution.apply(line);
    for (std::size_t k = 0; k <= degree; ++k)
      if (line[k] != 0) {
        auto exponents = begin->exponents;
        exponents[D - 1] = static_cast<std::uint16_t>(k);
        std::rotate(exponents.begin(), exponents.end() - 1, exponents.end());
        result.push_back({exponents, line[k]});
      }
    if (result.size() > max_terms)
      throw Budget_exceeded("affine substitution: more than " + std::to_string(max_terms)
                            + " terms in the result; expected fewer");
    begin = end;
  }
  std::sort(result.begin(), result.end(), [](const Term& a, const Term& b) { return a.exponents < b.exponents; });
  f.numerator = Polynomial<Integer, D>(Sorted_terms(), std::move(result));
  f.denominator *= substitution.denominator();
}

} // namespace detail

/// \brief f(offset + scale * u), variable by variable, as a polynomial in u; exact.
/// \throw Budget_exceeded beyond four million terms.
/// \par Complexity  Synthetic division on integers over a common denominator: n^2/2 products for
///      each line of degree n.
template <std::size_t D>
[[nodiscard]] Polynomial<Rational, D> affine_substitution(const Polynomial<Rational, D>& f,
                                                          const std::array<Rational, D>& offset,
                                                          const std::array<Rational, D>& scale)
{
  constexpr std::size_t max_terms = std::size_t{1} << 22;
  auto form = integer_form(f);
  for (std::size_t axis = D; axis-- > 0;) detail::substitute_and_rotate(form, offset[axis], scale[axis], max_terms);
  return to_rational(form);
}

/// \brief f(c + u) as a polynomial in u: its coefficients are the Taylor coefficients of `f` at c.
/// \throw Budget_exceeded, and complexity, as `affine_substitution`.
template <std::size_t D>
[[nodiscard]] Polynomial<Rational, D> taylor_shift(const Polynomial<Rational, D>& f, const std::array<Rational, D>& c)
{
  std::array<Rational, D> ones;
  ones.fill(1);
  return affine_substitution(f, c, ones);
}

} // namespace corral

#endif
