// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_ALGEBRA_FIELD_POLYNOMIAL_H
#define CORRAL_SRC_ALGEBRA_FIELD_POLYNOMIAL_H

#include <cstddef>
#include <utility>
#include <vector>

/// \file
/// Polynomials in one variable over a field that knows how to compute: division and Euclid's algorithm.
///
/// A `Field` has a type `Element`, a vector that is empty iff the element is zero, and `one`, `multiply`, `subtract`
/// (in place), `times` (by a natural number) and `inverse`.
namespace corral::exact {

/// From the constant coefficient up; the leading one is not zero, and the zero polynomial is empty.
template <class Field>
using Polynomial_over = std::vector<typename Field::Element>;

/// Drops vanishing leading coefficients.
template <class Coefficients>
void trim_leading(std::vector<Coefficients>& p)
{
  while (!p.empty() && p.back().empty()) p.pop_back();
}

template <class Field>
[[nodiscard]] Polynomial_over<Field> product(const Field& field, const Polynomial_over<Field>& p,
                                             const Polynomial_over<Field>& q)
{
  if (p.empty() || q.empty()) return {};
  Polynomial_over<Field> result(p.size() + q.size() - 1);
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < q.size(); ++j) // a sum, as the difference of what is there and the negative
      field.subtract(result[i + j], field.multiply(field.negative(p[i]), q[j]));
  trim_leading(result);
  return result;
}

/// Divides p by q with remainder: p becomes the remainder, the quotient is returned. \pre q is monic.
template <class Field>
[[nodiscard]] Polynomial_over<Field> divide(const Field& field, Polynomial_over<Field>& p,
                                            const Polynomial_over<Field>& q)
{
  if (p.size() < q.size()) return {};
  Polynomial_over<Field> quotient(p.size() - q.size() + 1);
  for (std::size_t k = quotient.size(); k-- > 0;) {
    if (p.size() < k + q.size()) continue;
    const auto factor = p.back();
    quotient[k] = factor;
    for (std::size_t i = 0; i + 1 < q.size(); ++i) field.subtract(p[k + i], field.multiply(factor, q[i]));
    p.pop_back();
    trim_leading(p);
  }
  return quotient;
}

template <class Field>
[[nodiscard]] Polynomial_over<Field> scaled(const Field& field, Polynomial_over<Field> p,
                                            const typename Field::Element& factor)
{
  for (auto& c : p) c = field.multiply(c, factor);
  return p;
}

template <class Field>
void make_monic(const Field& field, Polynomial_over<Field>& p)
{
  if (p.back() == field.one()) return;
  const auto inverse = field.inverse(p.back());
  p = scaled(field, std::move(p), inverse);
}

/// The monic greatest common divisor. \pre Not both are zero.
template <class Field>
[[nodiscard]] Polynomial_over<Field> gcd_over(const Field& field, Polynomial_over<Field> p, Polynomial_over<Field> q)
{
  while (!q.empty()) {
    make_monic(field, q);
    (void)divide(field, p, q);
    std::swap(p, q);
  }
  make_monic(field, p);
  return p;
}

/// The monic square-free part. \pre p is monic.
template <class Field>
[[nodiscard]] Polynomial_over<Field> square_free_over(const Field& field, const Polynomial_over<Field>& p)
{
  Polynomial_over<Field> slope(p.size() - 1);
  for (std::size_t j = 1; j < p.size(); ++j) slope[j - 1] = field.times(p[j], static_cast<unsigned long>(j));
  if (slope.empty()) return p;
  const auto repeated = gcd_over(field, p, slope);
  auto rest = p;
  return divide(field, rest, repeated);
}

} // namespace corral::exact

#endif
