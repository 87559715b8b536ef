// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_ALGEBRA_FIELD_POLYNOMIAL_H
#define CORRAL_SRC_ALGEBRA_FIELD_POLYNOMIAL_H

#include <concepts>
#include <cstddef>
#include <utility>
#include <vector>

/// \file
/// Polynomials in one variable over a field that knows how to compute: division and Euclid's algorithm.
namespace corral::exact {

/// \brief Computes with elements of one field. A default element is zero, and `empty` tells whether one is.
///
/// `subtract(a, b)` makes a the difference; `times(a, n)` is the sum of n copies of a; `inverse` takes no zero.
// clang-format off
template <class F>
concept Field =
  std::regular<typename F::Element>
  && requires(const F& field, typename F::Element a, const typename F::Element& b, unsigned long n) {
    { b.empty() } -> std::same_as<bool>;
    { field.one() } -> std::same_as<typename F::Element>;
    { field.negative(b) } -> std::same_as<typename F::Element>;
    { field.times(b, n) } -> std::same_as<typename F::Element>;
    { field.multiply(b, b) } -> std::same_as<typename F::Element>;
    { field.inverse(b) } -> std::same_as<typename F::Element>;
    field.subtract(a, b);
  };
// clang-format on

/// From the constant coefficient up; the leading one is not zero, and the zero polynomial is empty.
template <class F>
using Polynomial_over = std::vector<typename F::Element>;

/// Drops vanishing leading coefficients.
template <class Coefficients>
void trim_leading(std::vector<Coefficients>& p)
{
  while (!p.empty() && p.back().empty()) p.pop_back();
}

template <Field F>
[[nodiscard]] Polynomial_over<F> product(const F& field, const Polynomial_over<F>& p, const Polynomial_over<F>& q)
{
  if (p.empty() || q.empty()) return {};
  Polynomial_over<F> result(p.size() + q.size() - 1);
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < q.size(); ++j) // a sum, as the difference of what is there and the negative
      field.subtract(result[i + j], field.multiply(field.negative(p[i]), q[j]));
  trim_leading(result);
  return result;
}

/// Divides p by q with remainder: p becomes the remainder, the quotient is returned. \pre q is monic.
template <Field F>
[[nodiscard]] Polynomial_over<F> divide(const F& field, Polynomial_over<F>& p, const Polynomial_over<F>& q)
{
  if (p.size() < q.size()) return {};
  Polynomial_over<F> quotient(p.size() - q.size() + 1);
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

template <Field F>
[[nodiscard]] Polynomial_over<F> scaled(const F& field, Polynomial_over<F> p, const typename F::Element& factor)
{
  for (auto& c : p) c = field.multiply(c, factor);
  return p;
}

template <Field F>
void make_monic(const F& field, Polynomial_over<F>& p)
{
  if (p.back() == field.one()) return;
  const auto inverse = field.inverse(p.back());
  p = scaled(field, std::move(p), inverse);
}

/// The monic greatest common divisor. \pre Not both are zero.
template <Field F>
[[nodiscard]] Polynomial_over<F> gcd_over(const F& field, Polynomial_over<F> p, Polynomial_over<F> q)
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
template <Field F>
[[nodiscard]] Polynomial_over<F> square_free_over(const F& field, const Polynomial_over<F>& p)
{
  Polynomial_over<F> slope(p.size() - 1);
  for (std::size_t j = 1; j < p.size(); ++j) slope[j - 1] = field.times(p[j], static_cast<unsigned long>(j));
  if (slope.empty()) return p;
  const auto repeated = gcd_over(field, p, slope);
  auto rest = p;
  return divide(field, rest, repeated);
}

} // namespace corral::exact

#endif
