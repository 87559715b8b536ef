// SPDX-License-Identifier: LGPL-3.0-or-later
#include "../number/Prime_field.h"
#include "Flint_integer_polynomial.h"

#include <corral/algebra/Integer_polynomial.h>

#include <corral/polynomial/Wrong_answer.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace corral {

namespace {

/// p / q if the division leaves no remainder over the integers. Long ones are left to FLINT.
std::optional<Integer_polynomial> quotient(Integer_polynomial p, const Integer_polynomial& q)
{
  if (p.size() < q.size()) return p.empty() ? std::optional(p) : std::nullopt;
  Integer_polynomial result(p.size() - q.size() + 1);
  constexpr std::size_t worth_flint = 4096; // multiplications
  if (result.size() * q.size() > worth_flint) {
    const exact::Flint_integer_polynomial dividend(p);
    const exact::Flint_integer_polynomial divisor(q);
    exact::Flint_integer_polynomial flint;
    if (fmpz_poly_divides(flint.get(), dividend.get(), divisor.get()) == 0) return std::nullopt;
    exact::Flint_integer_polynomial product;
    fmpz_poly_mul(product.get(), flint.get(), divisor.get());
    if (fmpz_poly_equal(product.get(), dividend.get()) == 0)
      throw Wrong_answer("algebra: FLINT gives a wrong quotient of polynomials of the degrees "
                         + std::to_string(p.size() - 1) + " and " + std::to_string(q.size() - 1));
    return flint.coefficients();
  }
  for (std::size_t k = result.size(); k-- > 0;) {
    const Integer& lead = p[k + q.size() - 1];
    if (!mpz_divisible_p(lead.get_mpz_t(), q.back().get_mpz_t())) return std::nullopt;
    mpz_divexact(result[k].get_mpz_t(), lead.get_mpz_t(), q.back().get_mpz_t());
    if (result[k] == 0) continue;
    for (std::size_t i = 0; i < q.size(); ++i)
      mpz_submul(p[k + i].get_mpz_t(), result[k].get_mpz_t(), q[i].get_mpz_t());
  }
  for (std::size_t i = 0; i + 1 < q.size(); ++i)
    if (p[i] != 0) return std::nullopt;
  return result;
}

} // namespace

Integer_polynomial exact_quotient(const Integer_polynomial& p, const Integer_polynomial& q)
{
  return quotient(p, q).value();
}

bool divides(const Integer_polynomial& q, const Integer_polynomial& p)
{
  return quotient(primitive_part(p), primitive_part(q)).has_value(); // Gauss's lemma
}

Integer_polynomial greatest_common_divisor(const Integer_polynomial& a, const Integer_polynomial& b,
                                           const Checkpoint& checkpoint)
{
  if (a.empty()) return primitive_part(b);
  if (b.empty()) return primitive_part(a);
  const auto p = primitive_part(a);
  const auto q = primitive_part(b);
  const Integer lead = gcd(p.back(), q.back());
  exact::Chinese_remainder remainder;
  std::size_t best = std::min(degree(p), degree(q)) + 1;
  Integer_polynomial previous;
  for (exact::Large_primes primes;;) {
    if (checkpoint) checkpoint();
    const exact::Prime_field field(primes.next());
    if (field.from(lead) == 0) continue;
    const auto common = modular_gcd(field, image(field, p), image(field, q));
    if (common.size() == 1) return {1};
    if (common.size() > best) continue; // an unlucky prime: its degree is too high
    if (common.size() < best) remainder.clear();
    best = common.size();
    std::vector<std::uint64_t> residues(common.size());
    const auto scale = field.from(lead);
    for (std::size_t i = 0; i < common.size(); ++i) residues[i] = field.residue(field.multiply(common[i], scale));
    remainder.add(field.prime(), residues);
    auto candidate = remainder.symmetric();
    if (candidate == previous) { // stable, so worth the division that proves it
      const auto result = primitive_part(candidate);
      if (divides(result, p) && divides(result, q)) return result;
    }
    previous = std::move(candidate);
  }
}

Integer_polynomial square_free_part(const Integer_polynomial& p, const Checkpoint& checkpoint)
{
  const auto primitive = primitive_part(p);
  if (degree(primitive) == 0) return {1};
  return exact_quotient(primitive, greatest_common_divisor(primitive, derivative(primitive), checkpoint));
}

std::vector<Integer_polynomial> square_free_decomposition(const Integer_polynomial& p, const Checkpoint& checkpoint)
{
  std::vector<Integer_polynomial> factors;
  const auto primitive = primitive_part(p);
  if (degree(primitive) == 0) return factors;
  const auto slope = derivative(primitive);
  const auto repeated = greatest_common_divisor(primitive, slope, checkpoint);
  auto rest = exact_quotient(primitive, repeated);
  auto change = exact_quotient(slope, repeated);
  while (degree(rest) > 0) {
    const auto rest_slope = derivative(rest);
    if (change.size() < rest_slope.size()) change.resize(rest_slope.size());
    for (std::size_t i = 0; i < rest_slope.size(); ++i) change[i] -= rest_slope[i];
    trim(change);
    auto factor = greatest_common_divisor(rest, change, checkpoint);
    rest = exact_quotient(rest, factor);
    change = change.empty() ? change : exact_quotient(change, factor);
    factors.push_back(std::move(factor));
  }
  return factors;
}

} // namespace corral
