// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/algebra/Integer_polynomial.h>

#include <algorithm>
#include <array>

namespace corral {

int sign_at(const Integer_polynomial& p, const Rational& x)
{
  // Homogeneous Horner: sum of p_i n^i d^(N-i), whose sign is that of p(n/d).
  const Integer& n = x.get_num();
  const Integer& d = x.get_den();
  if (p.is_zero()) return 0;
  Integer value = p.lead();
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
  if (p.is_zero()) return 0;
  Integer value = p.lead();
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

} // namespace corral
