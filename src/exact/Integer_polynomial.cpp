// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Flint_integer_polynomial.h"
#include "Prime_field.h"

#include <corral/verification/Integer_polynomial.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace corral {

void trim(Integer_polynomial& p)
{
  while (!p.empty() && p.back() == 0) p.pop_back();
}

Integer_polynomial integer_polynomial(const Polynomial<Rational, 1>& p)
{
  Integer denominator = 1;
  for (const auto& term : p.terms()) denominator = lcm(denominator, term.coefficient.get_den());
  Integer_polynomial result(p.is_zero() ? 0 : p.degree(0) + 1U);
  for (const auto& term : p.terms())
    result[term.exponents[0]] = term.coefficient.get_num() * (denominator / term.coefficient.get_den());
  return result;
}

int sign_at(const Integer_polynomial& p, const Rational& x)
{
  // Homogeneous Horner: sum of p_i n^i d^(N-i), whose sign is that of p(n/d).
  const Integer& n = x.get_num();
  const Integer& d = x.get_den();
  if (p.empty()) return 0;
  Integer value = p.back();
  if (d == 1) {
    for (std::size_t i = p.size() - 1; i-- > 0;) {
      value *= n;
      value += p[i];
    }
    return sgn(value);
  }
  const auto twos = mpz_scan1(d.get_mpz_t(), 0);
  const bool dyadic = mpz_sizeinbase(d.get_mpz_t(), 2) == twos + 1;
  Integer weight = 1;
  Integer summand;
  for (std::size_t i = p.size() - 1; i-- > 0;) {
    value *= n;
    if (dyadic)
      mpz_mul_2exp(summand.get_mpz_t(), p[i].get_mpz_t(), twos * (p.size() - 1 - i));
    else {
      weight *= d;
      summand = p[i] * weight;
    }
    value += summand;
  }
  return sgn(value);
}

Rational evaluate(const Integer_polynomial& p, const Rational& x)
{
  if (p.empty()) return 0;
  Integer value = p.back();
  Integer weight = 1;
  for (std::size_t i = p.size() - 1; i-- > 0;) {
    weight *= x.get_den();
    value *= x.get_num();
    mpz_addmul(value.get_mpz_t(), p[i].get_mpz_t(), weight.get_mpz_t());
  }
  Rational result(value, weight);
  result.canonicalize();
  return result;
}

namespace {

long bits(const Integer& a) { return static_cast<long>(mpz_sizeinbase(a.get_mpz_t(), 2)); }

/// Horner's rule over intervals of integers that stand for multiples of 2^-precision, rounded outward.
Rational_interval evaluate_rounded(const Integer_polynomial& p, const Rational_interval& x, mp_bitcnt_t precision)
{
  const auto down = [&](Integer& a) { mpz_fdiv_q_2exp(a.get_mpz_t(), a.get_mpz_t(), precision); };
  const auto up = [&](Integer& a) { mpz_cdiv_q_2exp(a.get_mpz_t(), a.get_mpz_t(), precision); };
  Integer x_low = x.lower().get_num() << precision;
  Integer x_high = x.upper().get_num() << precision;
  mpz_fdiv_q(x_low.get_mpz_t(), x_low.get_mpz_t(), x.lower().get_den_mpz_t());
  mpz_cdiv_q(x_high.get_mpz_t(), x_high.get_mpz_t(), x.upper().get_den_mpz_t());
  Integer low = 0;
  Integer high = 0;
  for (std::size_t i = p.size(); i-- > 0;) {
    const std::array<Integer, 4> products = {low * x_low, low * x_high, high * x_low, high * x_high};
    const auto [least, most] = std::minmax_element(products.begin(), products.end());
    low = *least;
    high = *most;
    down(low);
    up(high);
    const Integer c = p[i] << precision;
    low += c;
    high += c;
  }
  const Rational unit(1, Integer(1) << precision);
  return {low * unit, high * unit};
}

} // namespace

Rational_interval evaluate(const Integer_polynomial& p, const Rational_interval& x)
{
  if (x.lower() == x.upper()) return Rational_interval(evaluate(p, x.lower()));
  constexpr std::size_t worth_rounding = 24; // below, numbers stay short without it
  if (p.size() > worth_rounding) {
    // As fine as the interval is short, and so that errors stay small when powers of x multiply them.
    const Rational width = x.upper() - x.lower();
    const long fineness = std::max(0L, bits(width.get_den()) - bits(width.get_num()) + 1);
    const Rational farthest = std::max<Rational>(abs(x.lower()), abs(x.upper()));
    const long growth = std::max(0L, bits(farthest.get_num()) - bits(farthest.get_den()) + 1);
    return evaluate_rounded(p, x, static_cast<mp_bitcnt_t>(64 + 2 * fineness + growth * static_cast<long>(p.size())));
  }
  Rational_interval value = 0;
  for (std::size_t i = p.size(); i-- > 0;) value = value * x + Rational_interval(Rational(p[i]));
  return value;
}

Integer_polynomial derivative(const Integer_polynomial& p)
{
  Integer_polynomial result(degree(p));
  for (std::size_t i = 1; i < p.size(); ++i) result[i - 1] = p[i] * static_cast<unsigned long>(i);
  return result;
}

Integer_polynomial multiply(const Integer_polynomial& p, const Integer_polynomial& q)
{
  if (p.empty() || q.empty()) return {};
  Integer_polynomial result(p.size() + q.size() - 1);
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < q.size(); ++j)
      mpz_addmul(result[i + j].get_mpz_t(), p[i].get_mpz_t(), q[j].get_mpz_t());
  return result;
}

namespace {

Integer content(const Integer_polynomial& p)
{
  Integer divisor = 0;
  for (const Integer& c : p) {
    divisor = gcd(divisor, c);
    if (divisor == 1) break;
  }
  return divisor;
}

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

Integer_polynomial primitive_part(Integer_polynomial p)
{
  if (p.empty()) return p;
  Integer divisor = content(p);
  if (p.back() < 0) divisor = -divisor;
  if (divisor != 1)
    for (Integer& c : p) mpz_divexact(c.get_mpz_t(), c.get_mpz_t(), divisor.get_mpz_t());
  return p;
}

Integer_polynomial exact_quotient(const Integer_polynomial& p, const Integer_polynomial& q)
{
  return quotient(p, q).value();
}

bool divides(const Integer_polynomial& q, const Integer_polynomial& p)
{
  return quotient(primitive_part(p), primitive_part(q)).has_value(); // Gauss's lemma
}

Integer_polynomial greatest_common_divisor(const Integer_polynomial& a, const Integer_polynomial& b)
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

Integer_polynomial square_free_part(const Integer_polynomial& p)
{
  const auto primitive = primitive_part(p);
  if (degree(primitive) == 0) return {1};
  return exact_quotient(primitive, greatest_common_divisor(primitive, derivative(primitive)));
}

std::vector<Integer_polynomial> square_free_decomposition(const Integer_polynomial& p)
{
  std::vector<Integer_polynomial> factors;
  const auto primitive = primitive_part(p);
  if (degree(primitive) == 0) return factors;
  const auto slope = derivative(primitive);
  const auto repeated = greatest_common_divisor(primitive, slope);
  auto rest = exact_quotient(primitive, repeated);
  auto change = exact_quotient(slope, repeated);
  while (degree(rest) > 0) {
    const auto rest_slope = derivative(rest);
    if (change.size() < rest_slope.size()) change.resize(rest_slope.size());
    for (std::size_t i = 0; i < rest_slope.size(); ++i) change[i] -= rest_slope[i];
    trim(change);
    auto factor = greatest_common_divisor(rest, change);
    rest = exact_quotient(rest, factor);
    change = change.empty() ? change : exact_quotient(change, factor);
    factors.push_back(std::move(factor));
  }
  return factors;
}

Integer_polynomial compose_affine(const Integer_polynomial& p, const Rational& offset, const Rational& scale)
{
  // d^N p((n + m x) / d) with the common denominator d, then a synthetic shift by n and a scaling by m.
  if (p.empty()) return p;
  const Integer d = lcm(offset.get_den(), scale.get_den());
  const Integer n = offset.get_num() * (d / offset.get_den());
  const Integer m = scale.get_num() * (d / scale.get_den());
  Integer_polynomial result = p;
  Integer weight = 1;
  for (std::size_t i = result.size(); i-- > 0; weight *= d) result[i] *= weight;
  if (n != 0)
    for (std::size_t i = 0; i + 1 < result.size(); ++i)
      for (std::size_t j = result.size() - 1; j-- > i;)
        mpz_addmul(result[j].get_mpz_t(), result[j + 1].get_mpz_t(), n.get_mpz_t());
  weight = 1;
  for (std::size_t i = 0; i < result.size(); ++i, weight *= m) result[i] *= weight;
  const Integer divisor = content(result);
  for (Integer& c : result) mpz_divexact(c.get_mpz_t(), c.get_mpz_t(), divisor.get_mpz_t());
  return result;
}

} // namespace corral
