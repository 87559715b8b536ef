// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/algebra/Integer_polynomial.h>
#include <corral/errors.h>

#include <utility>
#include <vector>

namespace corral {

Integer_polynomial integer_polynomial(const Polynomial<Rational, 1>& p)
{
  Integer denominator = 1;
  for (const auto& term : p.terms()) denominator = lcm(denominator, term.coefficient.get_den());
  std::vector<Integer> result(p.is_zero() ? 0 : p.degree(0) + 1U);
  for (const auto& term : p.terms())
    result[term.exponents[0]] = term.coefficient.get_num() * (denominator / term.coefficient.get_den());
  return Integer_polynomial(std::move(result));
}

Integer_polynomial derivative(const Integer_polynomial& p)
{
  std::vector<Integer> result(degree(p));
  for (std::size_t i = 1; i < p.size(); ++i) result[i - 1] = p[i] * static_cast<unsigned long>(i);
  return Integer_polynomial(std::move(result));
}

Integer_polynomial multiply(const Integer_polynomial& p, const Integer_polynomial& q)
{
  if (p.is_zero() || q.is_zero()) return {};
  std::vector<Integer> result(p.size() + q.size() - 1);
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < q.size(); ++j)
      mpz_addmul(result[i + j].get_mpz_t(), p[i].get_mpz_t(), q[j].get_mpz_t());
  return Integer_polynomial(std::move(result));
}

Integer content(const Integer_polynomial& p)
{
  Integer divisor = 0;
  for (const Integer& c : p) {
    divisor = gcd(divisor, c);
    if (divisor == 1) break;
  }
  return divisor;
}

namespace {

Integer_polynomial divided(const Integer_polynomial& p, const Integer& divisor)
{
  if (divisor == 1) return p;
  auto result = p.coefficients();
  for (Integer& c : result) mpz_divexact(c.get_mpz_t(), c.get_mpz_t(), divisor.get_mpz_t());
  return Integer_polynomial(std::move(result));
}

} // namespace

Integer_polynomial primitive_part(const Integer_polynomial& p) { return p.is_zero() ? p : divided(p, content(p)); }

Integer_polynomial normalized(const Integer_polynomial& p)
{
  return p.is_zero() ? p : divided(p, p.lead() < 0 ? Integer(-content(p)) : content(p));
}

Integer_polynomial compose_affine(const Integer_polynomial& p, const Rational& offset, const Rational& scale,
                                  const Checkpoint& checkpoint)
{
  // d^N p((n + m x) / d) with the common denominator d, then a synthetic shift by n and a scaling by m.
  if (sgn(scale) <= 0)
    throw Invalid_input("compose_affine: given the scale " + to_string(scale) + "; expected a positive number");
  if (p.is_zero()) return p;
  const Integer d = lcm(offset.get_den(), scale.get_den());
  const Integer n = offset.get_num() * (d / offset.get_den());
  const Integer m = scale.get_num() * (d / scale.get_den());
  auto result = p.coefficients();
  Integer weight = 1;
  for (std::size_t i = result.size(); i-- > 0; weight *= d) result[i] *= weight;
  if (n != 0)
    for (std::size_t i = 0; i + 1 < result.size(); ++i) {
      if (checkpoint) checkpoint();
      for (std::size_t j = result.size() - 1; j-- > i;)
        mpz_addmul(result[j].get_mpz_t(), result[j + 1].get_mpz_t(), n.get_mpz_t());
    }
  weight = 1;
  for (std::size_t i = 0; i < result.size(); ++i, weight *= m) result[i] *= weight;
  return primitive_part(Integer_polynomial(std::move(result)));
}

} // namespace corral
