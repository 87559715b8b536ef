// SPDX-License-Identifier: LGPL-3.0-or-later
#include "polynomial.h"

#include <algorithm>

namespace corral_check {
namespace {

constexpr std::uint64_t max_exponent = 1000;
constexpr double max_dense = 65536;
constexpr std::size_t max_terms = std::size_t{1} << 20;

/// A fraction costs about as much as this many operations on words.
constexpr double fraction_cost = 20;

void require_dense_size(const Polynomial& f, const std::string& where)
{
  double size = 1;
  for (const unsigned degree : degrees(f)) size *= degree + 1;
  require(size <= max_dense, where, "the product of (degree + 1) over the axes is above 2^16");
}

mpq_class power(const mpq_class& base, unsigned exponent, Budget& budget)
{
  Budget::memory(words(base) * exponent);
  budget.work(fraction_cost, words(base) * exponent);
  mpq_class result;
  mpz_pow_ui(result.get_num_mpz_t(), base.get_num_mpz_t(), exponent);
  mpz_pow_ui(result.get_den_mpz_t(), base.get_den_mpz_t(), exponent);
  return result;
}

} // namespace

Polynomial read_polynomial(const Json& value, std::size_t dimension, const std::string& where)
{
  require(!list(value, -1, where).empty(), where, "a polynomial has at least one term");
  Polynomial result;
  for (const Json& term : value) {
    list(term, static_cast<std::int64_t>(dimension) + 1, where);
    mpq_class coefficient = exact(term[0], where);
    require(coefficient != 0, where, "a coefficient is 0");
    Exponents exponents{};
    for (std::size_t axis = 0; axis < dimension; ++axis)
      exponents[axis] = static_cast<unsigned>(number(term[axis + 1], 0, max_exponent, where));
    require(result.empty() || result.rbegin()->first < exponents, where, "the terms are not sorted by exponents");
    result.emplace_hint(result.end(), exponents, std::move(coefficient));
  }
  require_dense_size(result, where);
  return result;
}

Exponents degrees(const Polynomial& f)
{
  Exponents result{};
  for (const auto& [exponents, coefficient] : f)
    for (std::size_t axis = 0; axis < max_dimension; ++axis) result[axis] = std::max(result[axis], exponents[axis]);
  return result;
}

void add_multiple(Polynomial& a, const Polynomial& b, const mpq_class& factor, const Exponents& shift, Budget& budget)
{
  for (const auto& [exponents, coefficient] : b) {
    Exponents sum;
    for (std::size_t axis = 0; axis < max_dimension; ++axis) sum[axis] = exponents[axis] + shift[axis];
    const auto term = a.try_emplace(sum).first;
    term->second += factor * coefficient;
    budget.work(fraction_cost, words(factor) + words(term->second));
    if (term->second == 0) a.erase(term);
  }
  require(a.size() <= max_terms, "budget", "a polynomial of the proofs has more than 2^20 terms");
}

Polynomial multiply(const Polynomial& a, const Polynomial& b, Budget& budget)
{
  Polynomial result;
  for (const auto& [exponents, coefficient] : a) add_multiple(result, b, coefficient, exponents, budget);
  return result;
}

bool divides(const Polynomial& divisor, Polynomial f, Budget& budget)
{
  const auto& [lead, lead_coefficient] = *divisor.rbegin();
  while (!f.empty()) {
    const auto& [exponents, coefficient] = *f.rbegin();
    Exponents shift;
    for (std::size_t axis = 0; axis < max_dimension; ++axis) {
      if (exponents[axis] < lead[axis]) return false;
      shift[axis] = exponents[axis] - lead[axis];
    }
    add_multiple(f, divisor, -coefficient / lead_coefficient, shift, budget);
  }
  return true;
}

Polynomial remainder(Polynomial f, const Polynomial& divisor, std::size_t axis, Budget& budget)
{
  const unsigned degree = degrees(divisor)[axis];
  for (unsigned current = degrees(f)[axis]; current >= degree; --current) {
    std::vector<std::pair<Exponents, mpq_class>> top;
    for (const auto& term : f)
      if (term.first[axis] == current) top.push_back(term);
    for (auto& [exponents, coefficient] : top) {
      exponents[axis] -= degree;
      add_multiple(f, divisor, -coefficient, exponents, budget);
    }
  }
  return f;
}

Polynomial restrict_to(const Polynomial& f, std::size_t axis, const mpq_class& value, Budget& budget)
{
  const unsigned degree = degrees(f)[axis];
  Budget::memory(words(value) * degree * degree / 2);
  budget.work(fraction_cost * degree, words(value) * degree);
  std::vector<mpq_class> powers{1};
  for (unsigned k = 1; k <= degree; ++k) powers.push_back(powers.back() * value);
  Polynomial result;
  for (const auto& [exponents, coefficient] : f) {
    Exponents rest = exponents;
    rest[axis] = 0;
    add_multiple(result, {{rest, coefficient}}, powers[exponents[axis]], Exponents{}, budget);
  }
  return result;
}

mpq_class evaluate(const Polynomial& f, const Point& point, Budget& budget)
{
  mpq_class sum;
  for (const auto& [exponents, coefficient] : f) {
    mpq_class product = coefficient;
    for (std::size_t axis = 0; axis < point.size(); ++axis)
      if (exponents[axis] != 0) product *= power(point[axis], exponents[axis], budget);
    sum += product;
    budget.work(fraction_cost, words(sum) + words(product));
  }
  return sum;
}

} // namespace corral_check
