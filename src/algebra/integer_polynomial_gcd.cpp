// SPDX-License-Identifier: LGPL-3.0-or-later
#include "../number/Prime_field.h"
#include "Flint_integer_polynomial.h"
#include "require_nonzero.h"

#include <corral/algebra/Integer_polynomial.h>
#include <corral/errors.h>
#include <corral/internal/number/Wrong_answer.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace corral {

namespace {

/// p / q if the division leaves no remainder over the integers. Long ones are left to FLINT.
/// \throw Invalid_input if q is zero.
std::optional<Integer_polynomial> quotient(const Integer_polynomial& dividend, const Integer_polynomial& q)
{
  exact::require_nonzero(q.is_zero(), "division of polynomials");
  if (dividend.size() < q.size()) return dividend.is_zero() ? std::optional(dividend) : std::nullopt;
  std::vector<Integer> result(dividend.size() - q.size() + 1);
  constexpr std::size_t worth_flint = 4096; // multiplications
  if (result.size() * q.size() > worth_flint) {
    const exact::Flint_integer_polynomial flint_dividend(dividend);
    const exact::Flint_integer_polynomial divisor(q);
    exact::Flint_integer_polynomial flint;
    if (fmpz_poly_divides(flint.get(), flint_dividend.get(), divisor.get()) == 0) return std::nullopt;
    exact::Flint_integer_polynomial product;
    fmpz_poly_mul(product.get(), flint.get(), divisor.get());
    if (fmpz_poly_equal(product.get(), flint_dividend.get()) == 0)
      throw Wrong_answer("algebra: FLINT gives a wrong quotient of polynomials of the degrees "
                         + std::to_string(dividend.size() - 1) + " and " + std::to_string(q.size() - 1));
    return flint.coefficients();
  }
  auto p = dividend.coefficients();
  for (std::size_t k = result.size(); k-- > 0;) {
    const Integer& lead = p[k + q.size() - 1];
    if (!mpz_divisible_p(lead.get_mpz_t(), q.lead().get_mpz_t())) return std::nullopt;
    mpz_divexact(result[k].get_mpz_t(), lead.get_mpz_t(), q.lead().get_mpz_t());
    if (result[k] == 0) continue;
    for (std::size_t i = 0; i < q.size(); ++i)
      mpz_submul(p[k + i].get_mpz_t(), result[k].get_mpz_t(), q[i].get_mpz_t());
  }
  for (std::size_t i = 0; i + 1 < q.size(); ++i)
    if (p[i] != 0) return std::nullopt;
  return Integer_polynomial(std::move(result));
}

Integer_polynomial difference(const Integer_polynomial& p, const Integer_polynomial& q)
{
  auto result = p.coefficients();
  if (result.size() < q.size()) result.resize(q.size());
  for (std::size_t i = 0; i < q.size(); ++i) result[i] -= q[i];
  return Integer_polynomial(std::move(result));
}

} // namespace

Integer_polynomial exact_quotient(const Integer_polynomial& p, const Integer_polynomial& q)
{
  auto result = quotient(p, q);
  if (!result) throw Invalid_input("exact_quotient: given polynomials of which one does not divide the other");
  return *std::move(result);
}

bool divides(const Integer_polynomial& q, const Integer_polynomial& p)
{
  return quotient(primitive_part(p), primitive_part(q)).has_value(); // Gauss's lemma
}

Integer_polynomial greatest_common_divisor(const Integer_polynomial& a, const Integer_polynomial& b,
                                           const Checkpoint& checkpoint)
{
  if (a.is_zero()) return normalized(b);
  if (b.is_zero()) return normalized(a);
  const auto p = normalized(a);
  const auto q = normalized(b);
  const Integer lead = gcd(p.lead(), q.lead());
  exact::Chinese_remainder remainder;
  std::size_t best = std::min(degree(p), degree(q)) + 1;
  Integer_polynomial previous;
  for (exact::Large_primes primes;;) {
    if (checkpoint) checkpoint();
    const exact::Prime_field field(primes.next());
    if (field.from(lead) == 0) continue;
    const auto common = modular_gcd(field, image(field, p.coefficients()), image(field, q.coefficients()));
    if (common.size() == 1) return {1};
    if (common.size() > best) continue; // an unlucky prime: its degree is too high
    if (common.size() < best) remainder.clear();
    best = common.size();
    std::vector<std::uint64_t> residues(common.size());
    const auto scale = field.from(lead);
    for (std::size_t i = 0; i < common.size(); ++i) residues[i] = field.residue(field.multiply(common[i], scale));
    remainder.add(field.prime(), residues);
    Integer_polynomial candidate(remainder.symmetric());
    if (candidate == previous) { // stable, so worth the division that proves it
      auto result = normalized(candidate);
      if (divides(result, p) && divides(result, q)) return result;
    }
    previous = std::move(candidate);
  }
}

Integer_polynomial square_free_part(const Integer_polynomial& p, const Checkpoint& checkpoint)
{
  exact::require_nonzero(p.is_zero(), "square_free_part");
  const auto primitive = normalized(p);
  if (degree(primitive) == 0) return {1};
  return exact_quotient(primitive, greatest_common_divisor(primitive, derivative(primitive), checkpoint));
}

bool is_square_free(const Integer_polynomial& p)
{
  return !p.is_zero() && degree(greatest_common_divisor(p, derivative(p))) == 0;
}

std::vector<Integer_polynomial> square_free_decomposition(const Integer_polynomial& p, const Checkpoint& checkpoint)
{
  exact::require_nonzero(p.is_zero(), "square_free_decomposition");
  std::vector<Integer_polynomial> factors;
  const auto primitive = normalized(p);
  if (degree(primitive) == 0) return factors;
  const auto slope = derivative(primitive);
  const auto repeated = greatest_common_divisor(primitive, slope, checkpoint);
  auto rest = exact_quotient(primitive, repeated);
  auto change = exact_quotient(slope, repeated);
  while (degree(rest) > 0) {
    change = difference(change, derivative(rest));
    auto factor = greatest_common_divisor(rest, change, checkpoint);
    rest = exact_quotient(rest, factor);
    change = exact_quotient(change, factor);
    factors.push_back(std::move(factor));
  }
  return factors;
}

} // namespace corral
