// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verification.h"

#include <algorithm>
#include <utility>

namespace corral::detail {

using exact::Modular_polynomial;
using exact::Prime_field;
using Element = Prime_field::Element;

namespace {

std::uint64_t prime_of(int round)
{
  constexpr int rounds_of_one = 8;
  constexpr std::uint64_t mersenne = (std::uint64_t{1} << 61) - 1;
  if (round < rounds_of_one) return mersenne;
  exact::Large_primes primes;
  for (int k = rounds_of_one; k < round; ++k) (void)primes.next();
  return primes.next();
}

Element power(const Prime_field& field, Element base, std::size_t exponent)
{
  Element result = field.one();
  for (; exponent != 0; exponent >>= 1, base = field.multiply(base, base))
    if ((exponent & 1) != 0) result = field.multiply(result, base);
  return result;
}

Modular_polynomial slope_of(const Prime_field& field, const Modular_polynomial& p)
{
  Modular_polynomial result;
  for (std::size_t k = 1; k < p.size(); ++k) result.push_back(field.multiply(field.from_residue(k), p[k]));
  while (!result.empty() && result.back() == 0) result.pop_back();
  return result;
}

/// Whether one of the rounds shows it. \param shows  of a field and a point.
template <class Shows>
bool some_round(std::size_t dimension, const Shows& shows, int rounds = Test_point::max_rounds)
{
  for (int round = 0; round < rounds; ++round) {
    Test_point source(round);
    std::vector<Element> point(dimension);
    for (Element& x : point) x = source.next();
    if (shows(source.field(), point)) return true;
  }
  return false;
}

} // namespace

void divide_exactly(Flint_polynomial& quotient, const Flint_polynomial& a, const Flint_polynomial& b,
                    const Flint_ring& ring, const Flint_functions& flint)
{
  const bool divides = flint.divides(quotient.get(), a.get(), b.get(), ring.context()) != 0;
  if (divides) {
    Flint_polynomial product(ring);
    fmpz_mpoly_mul(product.get(), quotient.get(), b.get(), ring.context());
    if (fmpz_mpoly_equal(product.get(), a.get(), ring.context()) != 0) return;
  }
  throw Wrong_answer(std::string("algebra: FLINT ") + (divides ? "gives a wrong quotient" : "finds no quotient")
                     + " of two polynomials of " + std::to_string(a.length()) + " and " + std::to_string(b.length())
                     + " terms, of which the second divides the first");
}

Test_point::Test_point(int round) : field_(prime_of(round)), state_(static_cast<std::uint64_t>(round) << 32) {}

Element Test_point::next() // SplitMix64 (Steele, Lea, Flood 2014)
{
  std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return field_.from_residue(z ^ (z >> 31));
}

std::size_t degree(const Flat_terms& f, std::size_t axis)
{
  std::size_t highest = 0;
  for (std::size_t i = axis; i < f.exponents.size(); i += f.dimension)
    highest = std::max<std::size_t>(highest, f.exponents[i]);
  return highest;
}

Modular_polynomial image_on_line(const Prime_field& field, const Flat_terms& f, std::size_t axis,
                                 const std::vector<Element>& point)
{
  Modular_polynomial result(degree(f, axis) + 1);
  for (std::size_t i = 0; i < f.coefficients.size(); ++i) {
    const auto* const exponents = &f.exponents[i * f.dimension];
    Element value = field.from(f.coefficients[i]);
    for (std::size_t k = 0; k < f.dimension; ++k)
      if (k != axis) value = field.multiply(value, power(field, point[k], exponents[k]));
    result[exponents[axis]] = field.add(result[exponents[axis]], value);
  }
  while (!result.empty() && result.back() == 0) result.pop_back();
  return result;
}

void require_coprime(const Flat_terms& f, const Flat_terms& g)
{
  for (std::size_t axis = 0; axis < f.dimension; ++axis) {
    if (degree(f, axis) == 0 || degree(g, axis) == 0) continue;
    const bool is_shown = some_round(f.dimension, [&](const Prime_field& field, const std::vector<Element>& point) {
      auto a = image_on_line(field, f, axis, point);
      auto b = image_on_line(field, g, axis, point);
      return a.size() == degree(f, axis) + 1 && !b.empty()
             && modular_gcd(field, std::move(a), std::move(b)).size() == 1;
    });
    if (!is_shown)
      throw Wrong_answer("algebra: two polynomials of " + std::to_string(f.coefficients.size()) + " and "
                         + std::to_string(g.coefficients.size())
                         + " terms, which FLINT says have no common factor, seem to have one");
  }
}

bool is_shown_square_free(const Flat_terms& f, int rounds)
{
  for (std::size_t axis = 0; axis < f.dimension; ++axis) {
    const std::size_t n = degree(f, axis);
    if (n < 2) continue;
    const auto shows = [&](const Prime_field& field, const std::vector<Element>& point) {
      auto a = image_on_line(field, f, axis, point);
      return a.size() == n + 1 && modular_gcd(field, a, slope_of(field, a)).size() == 1;
    };
    if (!some_round(f.dimension, shows, rounds)) return false;
  }
  return true;
}

void require_square_free(const Flat_terms& f)
{
  if (!is_shown_square_free(f, Test_point::max_rounds))
    throw Wrong_answer("algebra: a polynomial of " + std::to_string(f.coefficients.size())
                       + " terms, which by FLINT's answer has no repeated factor, seems to have one");
}

} // namespace corral::detail
