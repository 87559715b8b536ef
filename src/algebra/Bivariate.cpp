// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Bivariate.h"

#include "../number/Prime_field.h"
#include "../polynomial/to_exponent.h"
#include "../polynomial/verification.h"
#include "Interpolation.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

namespace corral::exact {

using Element = Prime_field::Element;

Bivariate bivariate(const Polynomial<Integer, 2>& f, std::size_t main)
{
  std::vector<std::vector<Integer>> coefficients(f.is_zero() ? 0 : f.degree(main) + 1U);
  for (const auto& term : f.terms()) {
    auto& coefficient = coefficients[term.exponents[main]];
    const std::size_t exponent = term.exponents[1 - main];
    if (coefficient.size() <= exponent) coefficient.resize(exponent + 1);
    coefficient[exponent] = term.coefficient;
  }
  Bivariate result;
  for (auto& c : coefficients) result.emplace_back(std::move(c));
  return result;
}

Polynomial<Integer, 2> polynomial(const Bivariate& f, std::size_t main)
{
  std::vector<Polynomial<Integer, 2>::Term> terms;
  for (std::size_t j = 0; j < f.size(); ++j)
    for (std::size_t i = 0; i < f[j].size(); ++i)
      if (f[j][i] != 0) {
        Exponents<2> exponents{};
        exponents[main] = detail::to_exponent(j);
        exponents[1 - main] = detail::to_exponent(i);
        terms.push_back({exponents, f[j][i]});
      }
  return collect<Integer, 2>(std::move(terms));
}

Integer_polynomial content(const Bivariate& f)
{
  Integer_polynomial result;
  for (const auto& c : f) {
    if (c.is_zero()) continue;
    result = greatest_common_divisor(result, c);
    if (degree(result) == 0) return {1};
  }
  return result;
}

Bivariate derivative(const Bivariate& f)
{
  Bivariate result(f.empty() ? 0 : f.size() - 1);
  for (std::size_t j = 1; j < f.size(); ++j) {
    auto coefficients = f[j].coefficients();
    for (Integer& c : coefficients) c *= static_cast<unsigned long>(j);
    result[j - 1] = Integer_polynomial(std::move(coefficients));
  }
  return result;
}

namespace {

std::size_t inner_degree(const Bivariate& f)
{
  std::size_t highest = 0;
  for (const auto& c : f) highest = std::max(highest, degree(c));
  return highest;
}

std::size_t total_degree(const Bivariate& f)
{
  std::size_t highest = 0;
  for (std::size_t j = 0; j < f.size(); ++j)
    if (!f[j].is_zero()) highest = std::max(highest, j + degree(f[j]));
  return highest;
}

/// The bits of the Euclidean norm of the coefficients' 1-norms, rounded up.
std::size_t norm_bits(const Bivariate& f)
{
  Integer squares = 0;
  for (const auto& c : f) {
    Integer sum = 0;
    for (const Integer& value : c) sum += abs(value);
    squares += sum * sum;
  }
  return mpz_sizeinbase(squares.get_mpz_t(), 2) / 2 + 1;
}

/// The images of one pair of polynomials modulo one prime, evaluated at many points.
class Modular_pair
{
public:
  Modular_pair(const Prime_field& field, const Bivariate& f, const Bivariate& g)
      : field_(field), f_(images(f)), g_(images(g))
  {}

  /// Whether the degrees in y survive modulo the prime.
  [[nodiscard]] bool is_lucky() const { return !f_.back().empty() && !g_.back().empty(); }

  /// The elimination at `x`, if the degrees in y survive there.
  [[nodiscard]] std::optional<Modular_elimination> evaluate(Element x) const
  {
    const auto a = at(f_, x);
    const auto b = at(g_, x);
    if (a.back() == 0 || b.back() == 0) return std::nullopt;
    return modular_elimination(field_, a, b);
  }

private:
  [[nodiscard]] std::vector<Modular_polynomial> images(const Bivariate& f) const
  {
    std::vector<Modular_polynomial> result;
    for (const auto& c : f) result.push_back(image(field_, c.coefficients()));
    return result;
  }
  [[nodiscard]] Modular_polynomial at(const std::vector<Modular_polynomial>& f, Element x) const
  {
    Modular_polynomial result(f.size());
    for (std::size_t j = 0; j < f.size(); ++j) {
      Element value = 0;
      for (std::size_t i = f[j].size(); i-- > 0;) value = field_.add(field_.multiply(value, x), f[j][i]);
      result[j] = value;
    }
    return result;
  }

  const Prime_field& field_;
  std::vector<Modular_polynomial> f_;
  std::vector<Modular_polynomial> g_;
};

/// The residues of field elements.
std::vector<std::uint64_t> residues(const Prime_field& field, const std::vector<Element>& values)
{
  std::vector<std::uint64_t> result;
  result.reserve(values.size());
  for (const Element value : values) result.push_back(field.residue(value));
  return result;
}

/// The values of an elimination at many points modulo one prime.
struct Samples
{
  std::vector<std::uint64_t> points;
  std::vector<Element> resultant;
  std::vector<Element> s1;
  std::vector<Element> s0;
};

/// Samples at `count` points; empty if too few points are found where the linear subresultant is known.
Samples sample(const Prime_field& field, const Modular_pair& pair, std::size_t count, bool with_linear,
               const Checkpoint& checkpoint)
{
  Samples samples;
  const std::uint64_t patience = 3 * count + 100;
  for (std::uint64_t t = 0; samples.points.size() < count; ++t) {
    if (checkpoint) checkpoint();
    if (with_linear && t > patience) return {};
    const auto value = pair.evaluate(field.from_residue(t));
    if (!value || (with_linear && !value->has_linear)) continue;
    samples.points.push_back(t);
    samples.resultant.push_back(value->resultant);
    samples.s1.push_back(value->s1);
    samples.s0.push_back(value->s0);
  }
  return samples;
}

} // namespace

Elimination eliminate(const Bivariate& f, const Bivariate& g, const Checkpoint& checkpoint)
{
  const std::size_t n = f.size() - 1;
  const std::size_t m = g.size() - 1;
  // Bounds for the Sylvester determinant; those of the linear subresultant, its minors, are smaller.
  const std::size_t degree_bound =
      std::min(m * inner_degree(f) + n * inner_degree(g), total_degree(f) * total_degree(g));
  const std::size_t bits = m * norm_bits(f) + n * norm_bits(g) + 2;
  std::array<Chinese_remainder, 3> remainders;
  bool with_linear = n > 0 && m > 0;
  for (Large_primes primes; mpz_sizeinbase(remainders[0].modulus().get_mpz_t(), 2) <= bits + 1;) {
    const Prime_field field(primes.next());
    const Modular_pair pair(field, f, g);
    if (!pair.is_lucky()) continue;
    auto samples = sample(field, pair, degree_bound + 1, with_linear, checkpoint);
    if (samples.points.empty()) {
      with_linear = false;
      samples = sample(field, pair, degree_bound + 1, false, checkpoint);
    }
    const Interpolation interpolation(field.prime(), samples.points);
    remainders[0].add(field.prime(), interpolation(residues(field, samples.resultant)));
    if (!with_linear) continue;
    remainders[1].add(field.prime(), interpolation(residues(field, samples.s1)));
    remainders[2].add(field.prime(), interpolation(residues(field, samples.s0)));
  }
  Elimination result{Integer_polynomial(remainders[0].symmetric()), {}, {}};
  if (with_linear) {
    result.s1 = Integer_polynomial(remainders[1].symmetric());
    result.s0 = Integer_polynomial(remainders[2].symmetric());
  }
  require_elimination(result, f, g);
  return result;
}

void require_elimination(const Elimination& elimination, const Bivariate& f, const Bivariate& g)
{
  const auto value = [](const Prime_field& field, const Integer_polynomial& p, Element x) {
    Element sum = 0;
    for (std::size_t i = p.size(); i-- > 0;) sum = field.add(field.multiply(sum, x), field.from(p[i]));
    return sum;
  };
  for (int round = 0; round < detail::Test_point::max_rounds; ++round) {
    detail::Test_point source(round);
    const auto& field = source.field();
    const Modular_pair pair(field, f, g);
    if (!pair.is_lucky()) continue;
    const auto x = source.next();
    const auto expected = pair.evaluate(x);
    const bool has_linear = !elimination.s1.is_zero() || !elimination.s0.is_zero();
    if (!expected || (has_linear && !expected->has_linear)) continue;
    if (value(field, elimination.resultant, x) == expected->resultant
        && (!has_linear
            || (value(field, elimination.s1, x) == expected->s1 && value(field, elimination.s0, x) == expected->s0)))
      return;
    break;
  }
  throw Wrong_answer("algebra: the resultant of two polynomials of the degrees " + std::to_string(f.size() - 1)
                     + " and " + std::to_string(g.size() - 1) + " is not what it is modulo another prime");
}

} // namespace corral::exact
