// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_POLYNOMIAL_ARITHMETIC_H
#define CORRAL_POLYNOMIAL_ARITHMETIC_H

#include <corral/errors.h>
#include <corral/internal/polynomial/integer_form.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

/// \file
/// Exact arithmetic of polynomials over a number type whose zero can be told (`Rational`, `Integer`).
namespace corral {

/// \brief What one product of polynomials may cost. A product beyond it throws `Budget_exceeded`
/// before anything is allocated.
struct Product_budget
{
  double max_terms = 1 << 22; ///< possible terms of the result
  double max_words = 1 << 23; ///< possible memory of its coefficients, in words of eight bytes
  double max_work = 1.5e9;    ///< `product_work`, about a nanosecond each
};

namespace detail {

inline double words(const Integer& c) { return static_cast<double>(mpz_size(c.get_mpz_t())); }
inline double words(const Rational& c) { return words(c.get_num()) + (c.get_den() == 1 ? 0 : words(c.get_den())); }

template <class NT, std::size_t D>
double widest_coefficient(const Polynomial<NT, D>& f)
{
  double widest = 1;
  for (const auto& term : f.terms()) widest = std::max(widest, words(term.coefficient));
  return widest;
}

/// How many monomials have every exponent at most that of f * g.
template <class NT, std::size_t D>
double monomials_of_product(const Polynomial<NT, D>& f, const Polynomial<NT, D>& g)
{
  double count = 1;
  for (std::size_t axis = 0; axis < D; ++axis) count *= f.degree(axis) + g.degree(axis) + 1;
  return count;
}

/// The product by an array with one place for each monomial up to the degrees.
template <std::size_t D>
Polynomial<Integer, D> dense_product(const Polynomial<Integer, D>& f, const Polynomial<Integer, D>& g)
{
  std::array<std::size_t, D> side;
  std::size_t places = 1;
  for (std::size_t axis = 0; axis < D; ++axis) places *= side[axis] = f.degree(axis) + g.degree(axis) + 1;
  const auto place = [&](const Exponents<D>& exponents) {
    std::size_t index = 0;
    for (std::size_t axis = 0; axis < D; ++axis) index = index * side[axis] + exponents[axis];
    return index;
  };
  std::vector<std::size_t> place_in_g;
  for (const auto& term : g.terms()) place_in_g.push_back(place(term.exponents));
  std::vector<Integer> sums(places);
  for (const auto& a : f.terms()) {
    const std::size_t shift = place(a.exponents);
    for (std::size_t i = 0; i < place_in_g.size(); ++i)
      mpz_addmul(sums[shift + place_in_g[i]].get_mpz_t(), a.coefficient.get_mpz_t(),
                 g.terms()[i].coefficient.get_mpz_t());
  }
  std::vector<typename Polynomial<Integer, D>::Term> terms;
  for (std::size_t i = 0; i < places; ++i)
    if (sums[i] != 0) {
      Exponents<D> exponents;
      std::size_t rest = i;
      for (std::size_t axis = D; axis-- > 0; rest /= side[axis])
        exponents[axis] = static_cast<std::uint16_t>(rest % side[axis]);
      terms.push_back({exponents, std::move(sums[i])});
    }
  return Polynomial<Integer, D>(Sorted_terms(), std::move(terms));
}

/// The product as the sorted list of all products of two terms.
template <std::size_t D>
Polynomial<Integer, D> sparse_product(const Polynomial<Integer, D>& f, const Polynomial<Integer, D>& g)
{
  std::vector<typename Polynomial<Integer, D>::Term> terms;
  terms.reserve(f.terms().size() * g.terms().size());
  for (const auto& a : f.terms())
    for (const auto& b : g.terms()) {
      auto exponents = a.exponents;
      for (std::size_t axis = 0; axis < D; ++axis)
        exponents[axis] = static_cast<std::uint16_t>(exponents[axis] + b.exponents[axis]);
      terms.push_back({exponents, Integer(a.coefficient * b.coefficient)});
    }
  return collect<Integer, D>(std::move(terms));
}

} // namespace detail

/// The sum. \par Complexity  one merge.
template <class NT, std::size_t D>
[[nodiscard]] Polynomial<NT, D> operator+(const Polynomial<NT, D>& f, const Polynomial<NT, D>& g)
{
  std::vector<typename Polynomial<NT, D>::Term> terms;
  terms.reserve(f.terms().size() + g.terms().size());
  auto b = g.terms().begin();
  for (const auto& a : f.terms()) {
    while (b != g.terms().end() && b->exponents < a.exponents) terms.push_back(*b++);
    if (b == g.terms().end() || b->exponents != a.exponents)
      terms.push_back(a);
    else if (NT sum = a.coefficient + (b++)->coefficient; sum != 0)
      terms.push_back({a.exponents, std::move(sum)});
  }
  terms.insert(terms.end(), b, g.terms().end());
  return Polynomial<NT, D>(Sorted_terms(), std::move(terms));
}

template <class NT, std::size_t D>
[[nodiscard]] Polynomial<NT, D> operator-(const Polynomial<NT, D>& f)
{
  return transform<NT>(f, [](const NT& c) { return NT(-c); });
}

template <class NT, std::size_t D>
[[nodiscard]] Polynomial<NT, D> operator-(const Polynomial<NT, D>& f, const Polynomial<NT, D>& g)
{
  return f + -g;
}

/// The scalar product.
template <class NT, std::size_t D>
[[nodiscard]] Polynomial<NT, D> operator*(const std::type_identity_t<NT>& factor, const Polynomial<NT, D>& f)
{
  if (factor == 0) return {};
  return transform<NT>(f, [&](const NT& c) { return NT(factor * c); });
}

template <class NT, std::size_t D>
[[nodiscard]] Polynomial<NT, D> operator*(const Polynomial<NT, D>& f, const std::type_identity_t<NT>& factor)
{
  return factor * f;
}

/// A measure of the time that `f * g` takes: products of terms, each weighed by the size of its factors.
template <class NT, std::size_t D>
[[nodiscard]] double product_work(const Polynomial<NT, D>& f, const Polynomial<NT, D>& g)
{
  const double products = static_cast<double>(f.terms().size()) * static_cast<double>(g.terms().size());
  const double a = detail::widest_coefficient(f);
  const double b = detail::widest_coefficient(g);
  return products * (8 + std::min(a * b / 2, 64 * (a + b))); // schoolbook, then fast multiplication
}

/// \brief The product of two integer polynomials.
/// \throw Budget_exceeded if it may have more terms or take more work than `budget` allows, or an
///        exponent above 65535.
/// \par Complexity  One multiplication for each pair of terms; where the terms are few among the
///      monomials up to the degrees, also a sort of these products.
template <std::size_t D>
[[nodiscard]] Polynomial<Integer, D> multiply(const Polynomial<Integer, D>& f, const Polynomial<Integer, D>& g,
                                              const Product_budget& budget = {})
{
  const double products = static_cast<double>(f.terms().size()) * static_cast<double>(g.terms().size());
  const double monomials = detail::monomials_of_product(f, g);
  const double terms = std::min(products, monomials);
  const double width = detail::widest_coefficient(f) + detail::widest_coefficient(g);
  if (terms > budget.max_terms || terms * width > budget.max_words || product_work(f, g) > budget.max_work)
    throw Budget_exceeded("product of polynomials: " + std::to_string(f.terms().size()) + " by "
                          + std::to_string(g.terms().size()) + " terms, with coefficients of up to "
                          + std::to_string(static_cast<long>(64 * width)) + " bits in the product; expected at most "
                          + std::to_string(static_cast<long>(budget.max_terms)) + " terms, "
                          + std::to_string(static_cast<long>(budget.max_words / (1 << 17))) + " MB, some seconds");
  for (std::size_t axis = 0; axis < D; ++axis)
    if (f.degree(axis) + g.degree(axis) > 0xffff)
      throw Budget_exceeded("product of polynomials: degree " + std::to_string(f.degree(axis) + g.degree(axis))
                            + " in variable " + std::to_string(axis + 1) + "; expected at most 65535");
  const bool is_dense = monomials <= budget.max_terms && monomials <= 8 * products;
  return is_dense ? detail::dense_product(f, g) : detail::sparse_product(f, g);
}

/// \brief The product of two rational polynomials, computed over common denominators.
/// \throw Budget_exceeded as for integers.
template <std::size_t D>
[[nodiscard]] Polynomial<Rational, D> multiply(const Polynomial<Rational, D>& f, const Polynomial<Rational, D>& g,
                                               const Product_budget& budget = {})
{
  const auto a = integer_form(f);
  const auto b = integer_form(g);
  return to_rational(Integer_form<D>{multiply(a.numerator, b.numerator, budget), a.denominator * b.denominator});
}

/// The product, within the default budget.
template <class NT, std::size_t D>
[[nodiscard]] Polynomial<NT, D> operator*(const Polynomial<NT, D>& f, const Polynomial<NT, D>& g)
{
  return multiply(f, g);
}

/// \brief `f` to the power `n`; the zeroth power is 1.
/// \throw Budget_exceeded if a product on the way does not fit the budget.
/// \par Complexity  At most 2 log2(n) products.
template <class NT, std::size_t D>
[[nodiscard]] Polynomial<NT, D> power(const Polynomial<NT, D>& f, unsigned n, const Product_budget& budget = {})
{
  if (n == 0) return constant<NT, D>(1);
  if (n == 1) return f;
  const auto root = power(f, n / 2, budget);
  const auto even = multiply(root, root, budget);
  return n % 2 == 0 ? even : multiply(even, f, budget);
}

} // namespace corral

#endif
