// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_TEST_POLYNOMIAL_RANDOM_POLYNOMIAL_H
#define CORRAL_TEST_POLYNOMIAL_RANDOM_POLYNOMIAL_H

#include <corral/polynomial/Polynomial.h>

#include <array>
#include <cstddef>
#include <random>

namespace corral::test {

using Generator = std::mt19937_64;

/// A fraction whose numerator fills 53 bits; small denominators and powers of two both occur.
inline Rational random_rational(Generator& generator)
{
  const auto numerator = static_cast<long>(generator() >> 11);
  const auto denominator =
      static_cast<long>(generator() % 3 == 0 ? 1 + generator() % 1000 : 1ULL << (generator() % 60));
  Rational value(generator() % 2 == 0 ? numerator : -numerator, denominator);
  value.canonicalize();
  return value;
}

/// Up to `terms` terms with exponents up to `degree`; sometimes zero or constant.
template <std::size_t D>
Polynomial<Rational, D> random_polynomial(Generator& generator, std::size_t terms, unsigned degree)
{
  std::vector<typename Polynomial<Rational, D>::Term> list;
  for (std::size_t n = generator() % (terms + 1); n > 0; --n) {
    Exponents<D> exponents;
    for (auto& e : exponents) e = static_cast<std::uint16_t>(generator() % (degree + 1));
    list.push_back({exponents, random_rational(generator)});
  }
  return collect<Rational, D>(std::move(list));
}

template <std::size_t D>
std::array<Rational, D> random_point(Generator& generator)
{
  std::array<Rational, D> point;
  for (auto& x : point) x = generator() % 8 == 0 ? Rational(0) : random_rational(generator);
  return point;
}

/// The sum of the terms, each multiplied out: as simple as the definition.
template <class NT, std::size_t D>
NT value_by_definition(const Polynomial<NT, D>& f, const std::array<NT, D>& point)
{
  NT sum = 0;
  for (const auto& term : f.terms()) {
    NT product = term.coefficient;
    for (std::size_t axis = 0; axis < D; ++axis)
      for (unsigned k = 0; k < term.exponents[axis]; ++k) product *= point[axis];
    sum += product;
  }
  return sum;
}

/// Whether the terms are sorted, without repetition and without zeros.
template <class NT, std::size_t D>
bool is_canonical(const Polynomial<NT, D>& f)
{
  const auto& terms = f.terms();
  for (std::size_t i = 0; i < terms.size(); ++i)
    if (terms[i].coefficient == 0 || (i > 0 && !(terms[i - 1].exponents < terms[i].exponents))) return false;
  return true;
}

} // namespace corral::test

#endif
