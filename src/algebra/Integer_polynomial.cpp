// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/algebra/Integer_polynomial.h>

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

Integer_polynomial compose_affine(const Integer_polynomial& p, const Rational& offset, const Rational& scale,
                                  const Checkpoint& checkpoint)
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
    for (std::size_t i = 0; i + 1 < result.size(); ++i) {
      if (checkpoint) checkpoint();
      for (std::size_t j = result.size() - 1; j-- > i;)
        mpz_addmul(result[j].get_mpz_t(), result[j + 1].get_mpz_t(), n.get_mpz_t());
    }
  weight = 1;
  for (std::size_t i = 0; i < result.size(); ++i, weight *= m) result[i] *= weight;
  const Integer divisor = content(result);
  for (Integer& c : result) mpz_divexact(c.get_mpz_t(), c.get_mpz_t(), divisor.get_mpz_t());
  return result;
}

} // namespace corral
