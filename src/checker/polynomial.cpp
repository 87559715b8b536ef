// SPDX-License-Identifier: LGPL-3.0-or-later
#include "polynomial.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace corral_check {
namespace {

constexpr std::uint64_t max_exponent = 1000;
constexpr double max_dense = 65536;
constexpr double term_words = 20; ///< of section 7: what a term takes beside its coefficient

void require_dense_size(const Polynomial& f, const Place& place)
{
  double size = 1;
  for (const unsigned degree : degrees(f)) size *= degree + 1;
  limit(size <= max_dense, place, "the product of (degree + 1) over the axes is above 2^16");
}

mpq_class power(const mpq_class& base, unsigned exponent)
{
  mpq_class result;
  mpz_pow_ui(result.get_num_mpz_t(), base.get_num_mpz_t(), exponent);
  mpz_pow_ui(result.get_den_mpz_t(), base.get_den_mpz_t(), exponent);
  return result;
}

unsigned read_exponent(const Value& value, const std::string& where)
{
  const std::uint64_t exponent = value.number(0, std::numeric_limits<std::int64_t>::max(), where);
  limit(exponent <= max_exponent, value.place(where), "an exponent is above 1000");
  return static_cast<unsigned>(exponent);
}

/// The exponents of a over those of b, if there is no negative one.
bool quotient(const Exponents& a, const Exponents& b, Exponents& result)
{
  for (std::size_t axis = 0; axis < max_dimension; ++axis) {
    if (a[axis] < b[axis]) return false;
    result[axis] = a[axis] - b[axis];
  }
  return true;
}

} // namespace

Polynomial read_polynomial(const Value& value, std::size_t dimension, const std::string& where)
{
  Polynomial result;
  Items terms(value, where);
  for (Value term; terms.next(term);) {
    const auto entries = term.list(static_cast<std::int64_t>(dimension) + 1, where);
    mpq_class coefficient = entries[0].exact(where);
    require(coefficient != 0, entries[0].place(where), "a coefficient is 0");
    Exponents exponents{};
    for (std::size_t axis = 0; axis < dimension; ++axis) exponents[axis] = read_exponent(entries[axis + 1], where);
    require(result.empty() || result.rbegin()->first < exponents, term.place(where),
            "the terms are not sorted by exponents");
    result.emplace_hint(result.end(), exponents, std::move(coefficient));
    limit(static_cast<double>(result.size()) <= max_dense, value.place(where), "more than 2^16 terms");
  }
  require(!result.empty(), value.place(where), "a polynomial has at least one term");
  require_dense_size(result, value.place(where));
  return result;
}

Exponents degrees(const Polynomial& f)
{
  Exponents result{};
  for (const auto& [exponents, coefficient] : f)
    for (std::size_t axis = 0; axis < max_dimension; ++axis) result[axis] = std::max(result[axis], exponents[axis]);
  return result;
}

unsigned total_degree(const Polynomial& f)
{
  unsigned result = 0;
  for (const auto& [exponents, coefficient] : f)
    result = std::max(result, std::accumulate(exponents.begin(), exponents.end(), 0U));
  return result;
}

Sum::Sum(Polynomial start, Budget& budget) : budget_(&budget), terms_(std::move(start))
{
  for (const auto& [exponents, coefficient] : terms_) held_ += length(coefficient) + term_words;
}

void Sum::add_term(const Exponents& exponents, const mpq_class& coefficient)
{
  const auto [term, is_new] = terms_.try_emplace(exponents);
  if (!is_new) held_ -= length(term->second) + term_words;
  term->second += coefficient;
  budget_->fractions(length(term->second));
  if (term->second == 0) {
    terms_.erase(term);
    return;
  }
  held_ += length(term->second) + term_words;
  Budget::require_polynomial_words(held_);
}

void Sum::add(const Polynomial& f, const mpq_class& factor, const Exponents& shift)
{
  const double factor_length = length(factor);
  for (const auto& [exponents, coefficient] : f) {
    budget_->fractions(factor_length + length(coefficient));
    Exponents sum;
    for (std::size_t axis = 0; axis < max_dimension; ++axis) sum[axis] = exponents[axis] + shift[axis];
    add_term(sum, factor * coefficient);
  }
}

void Sum::add_product(const Polynomial& a, const Polynomial& b)
{
  for (const auto& [exponents, coefficient] : a) add(b, coefficient, exponents);
}

Division divide(const Polynomial& f, const Polynomial& divisor, Budget& budget)
{
  const auto& [lead, lead_coefficient] = *divisor.rbegin();
  Sum rest(f, budget);
  Sum quotients(budget);
  auto end = rest.value().end(); // what is from here on stays
  while (end != rest.value().begin()) {
    const auto top = std::prev(end);
    Exponents shift;
    if (!quotient(top->first, lead, shift)) {
      end = top;
      continue;
    }
    const mpq_class factor = top->second / lead_coefficient;
    quotients.add_term(shift, factor);
    rest.add(divisor, -factor, shift); // removes the term at `top` and changes only lower ones
  }
  return {std::move(quotients).take(), std::move(rest).take()};
}

Polynomial remainder(Polynomial f, const Polynomial& divisor, std::size_t axis, Budget& budget)
{
  const unsigned degree = degrees(divisor)[axis];
  const unsigned highest = degrees(f)[axis];
  Sum rest(std::move(f), budget);
  for (unsigned current = highest; current >= degree; --current) {
    std::vector<std::pair<Exponents, mpq_class>> top;
    for (const auto& term : rest.value())
      if (term.first[axis] == current) top.push_back(term);
    for (auto& [exponents, coefficient] : top) {
      exponents[axis] -= degree;
      rest.add(divisor, -coefficient, exponents);
    }
  }
  return std::move(rest).take();
}

bool divides_power(const Polynomial& f, const Polynomial& g, std::uint64_t k, Budget& budget)
{
  const std::uint64_t steps = std::min<std::uint64_t>(k, total_degree(f)); // no factor is more multiple than that
  Polynomial rest{{Exponents{}, 1}};
  for (std::uint64_t step = 0; step < steps && !rest.empty(); ++step) {
    Sum product(budget);
    product.add_product(rest, g);
    rest = divide(product.value(), f, budget).remainder;
  }
  return rest.empty() || total_degree(f) == 0;
}

Polynomial derivative(const Polynomial& f, std::size_t axis)
{
  Polynomial result;
  for (const auto& [exponents, coefficient] : f) {
    if (exponents[axis] == 0) continue;
    Exponents lower = exponents;
    --lower[axis];
    result.emplace(lower, coefficient * exponents[axis]);
  }
  return result;
}

Polynomial restrict_to(const Polynomial& f, std::size_t axis, const mpq_class& value, Budget& budget)
{
  Sum result(budget);
  for (const auto& [exponents, coefficient] : f) {
    budget.fractions(length(coefficient) + exponents[axis] * length(value));
    Exponents rest = exponents;
    rest[axis] = 0;
    result.add_term(rest, coefficient * power(value, exponents[axis]));
  }
  return std::move(result).take();
}

mpq_class evaluate(const Polynomial& f, const Point& point, Budget& budget)
{
  mpq_class sum;
  for (const auto& [exponents, coefficient] : f) {
    double word_count = length(coefficient) + length(sum);
    for (std::size_t axis = 0; axis < point.size(); ++axis) word_count += exponents[axis] * length(point[axis]);
    budget.fractions(word_count);
    mpq_class product = coefficient;
    for (std::size_t axis = 0; axis < point.size(); ++axis)
      if (exponents[axis] != 0) product *= power(point[axis], exponents[axis]);
    sum += product;
  }
  return sum;
}

std::string to_text(const Polynomial& f, const std::vector<std::string>& variables)
{
  std::string result;
  for (const auto& [exponents, coefficient] : f) {
    std::string term = mpq_class(abs(coefficient)).get_str();
    std::string factors;
    for (std::size_t axis = 0; axis < variables.size(); ++axis) {
      if (exponents[axis] == 0) continue;
      factors += '*' + variables[axis];
      if (exponents[axis] > 1) factors += '^' + std::to_string(exponents[axis]);
    }
    if (term == "1" && !factors.empty()) {
      term.clear();
      factors.erase(0, 1);
    }
    const bool is_negative = coefficient < 0;
    result += result.empty() ? (is_negative ? "-" : "") : (is_negative ? " - " : " + ");
    result += term + factors;
  }
  return result;
}

} // namespace corral_check
