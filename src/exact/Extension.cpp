// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Extension.h"

#include <algorithm>
#include <flint/fmpq_poly.h>
#include <flint/fmpz_poly_factor.h>
#include <utility>

namespace corral::exact {

namespace {

void trim(Rational_coefficients& a)
{
  while (!a.empty() && a.back() == 0) a.pop_back();
}

void trim(Extension_polynomial& p)
{
  while (!p.empty() && p.back().empty()) p.pop_back();
}

Rational_coefficients product(const Rational_coefficients& a, const Rational_coefficients& b)
{
  if (a.empty() || b.empty()) return {};
  Rational_coefficients result(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) result[i + j] += a[i] * b[j];
  return result;
}

void subtract(Rational_coefficients& a, const Rational_coefficients& b)
{
  if (a.size() < b.size()) a.resize(b.size());
  for (std::size_t i = 0; i < b.size(); ++i) a[i] -= b[i];
  trim(a);
}

/// Divides a by b over Q: a becomes the remainder, the quotient is returned.
Rational_coefficients divide_rational(Rational_coefficients& a, const Rational_coefficients& b)
{
  if (a.size() < b.size()) return {};
  Rational_coefficients result(a.size() - b.size() + 1);
  for (std::size_t k = result.size(); k-- > 0;) {
    if (a.size() < k + b.size()) continue;
    const Rational factor = a.back() / b.back();
    result[k] = factor;
    for (std::size_t i = 0; i + 1 < b.size(); ++i) a[k + i] -= factor * b[i];
    a.pop_back();
    trim(a);
  }
  return result;
}

Integer_polynomial to_integer(const Rational_coefficients& a)
{
  Integer denominator = 1;
  for (const Rational& c : a) denominator = lcm(denominator, c.get_den());
  Integer_polynomial result;
  for (const Rational& c : a) result.push_back(c.get_num() * (denominator / c.get_den()));
  return primitive_part(std::move(result));
}

/// Owner of a FLINT polynomial over the rationals.
class Flint_polynomial
{
public:
  Flint_polynomial() { fmpq_poly_init(value_); }
  explicit Flint_polynomial(const Rational_coefficients& a)
  {
    fmpq_poly_init(value_);
    for (std::size_t i = 0; i < a.size(); ++i) fmpq_poly_set_coeff_mpq(value_, static_cast<slong>(i), a[i].get_mpq_t());
  }
  Flint_polynomial(const Flint_polynomial&) = delete;
  Flint_polynomial& operator=(const Flint_polynomial&) = delete;
  ~Flint_polynomial() { fmpq_poly_clear(value_); }

  [[nodiscard]] fmpq_poly_struct* get() { return value_; }
  [[nodiscard]] const fmpq_poly_struct* get() const { return value_; }
  [[nodiscard]] Rational_coefficients coefficients() const
  {
    Rational_coefficients result(static_cast<std::size_t>(fmpq_poly_length(value_)));
    for (std::size_t i = 0; i < result.size(); ++i)
      fmpq_poly_get_coeff_mpq(result[i].get_mpq_t(), value_, static_cast<slong>(i));
    return result;
  }

private:
  fmpq_poly_t value_;
};

} // namespace

Integer_polynomial irreducible_factor(const Real_root& alpha)
{
  const auto& p = alpha.polynomial();
  fmpz_poly_t flint;
  fmpz_poly_init(flint);
  for (std::size_t i = 0; i < p.size(); ++i) fmpz_poly_set_coeff_mpz(flint, static_cast<slong>(i), p[i].get_mpz_t());
  fmpz_poly_factor_t factors;
  fmpz_poly_factor_init(factors);
  fmpz_poly_factor(factors, flint);
  Integer_polynomial result = p;
  for (slong k = 0; k < factors->num; ++k) {
    Integer_polynomial factor(static_cast<std::size_t>(fmpz_poly_length(factors->p + k)));
    for (std::size_t i = 0; i < factor.size(); ++i)
      fmpz_poly_get_coeff_mpz(factor[i].get_mpz_t(), factors->p + k, static_cast<slong>(i));
    if (sign_at(factor, alpha.lower()) != sign_at(factor, alpha.upper())) result = std::move(factor);
  }
  fmpz_poly_factor_clear(factors);
  fmpz_poly_clear(flint);
  return result;
}

Extension::Extension(Integer_polynomial m, Real_root alpha) : m_(std::move(m)), alpha_(std::move(alpha))
{
  for (const Integer& c : m_) {
    monic_.emplace_back(c, m_.back());
    monic_.back().canonicalize();
  }
}

Rational_coefficients Extension::reduce(Rational_coefficients a) const
{
  trim(a);
  (void)divide_rational(a, monic_);
  return a;
}

Rational_coefficients Extension::multiply(const Rational_coefficients& a, const Rational_coefficients& b) const
{
  return reduce(product(a, b));
}

Rational_coefficients Extension::inverse(const Rational_coefficients& a) const
{
  const Flint_polynomial element(a);
  const Flint_polynomial modulus(monic_);
  Flint_polynomial common;
  Flint_polynomial cofactor;
  Flint_polynomial other;
  fmpq_poly_xgcd(common.get(), cofactor.get(), other.get(), element.get(), modulus.get()); // common is monic
  if (fmpq_poly_degree(common.get()) == 0) return cofactor.coefficients();
  // alpha is a root of the common factor or of its cofactor
  auto factor = to_integer(common.coefficients());
  auto alpha = alpha_;
  if (alpha.sign_of(factor) == 0) throw Split{std::move(factor)};
  throw Split{exact_quotient(primitive_part(m_), factor)};
}

void Extension::make_monic(Extension_polynomial& p) const
{
  if (p.back() == Rational_coefficients{1}) return;
  const auto factor = inverse(p.back());
  for (auto& c : p) c = multiply(c, factor);
}

Extension_polynomial Extension::divide(Extension_polynomial& p, const Extension_polynomial& q) const
{
  if (p.size() < q.size()) return {};
  Extension_polynomial result(p.size() - q.size() + 1);
  for (std::size_t k = result.size(); k-- > 0;) {
    if (p.size() < k + q.size()) continue;
    const auto factor = p.back(); // q is monic
    result[k] = factor;
    for (std::size_t i = 0; i + 1 < q.size(); ++i) subtract(p[k + i], multiply(factor, q[i]));
    p.pop_back();
    trim(p);
  }
  return result;
}

Extension_polynomial Extension::gcd(Extension_polynomial p, Extension_polynomial q) const
{
  trim(p);
  trim(q);
  while (!q.empty()) {
    make_monic(q);
    (void)divide(p, q);
    std::swap(p, q);
  }
  make_monic(p);
  return p;
}

Extension_polynomial Extension::square_free_part(const Extension_polynomial& p) const
{
  Extension_polynomial slope(p.size() - 1);
  for (std::size_t j = 1; j < p.size(); ++j) {
    slope[j - 1] = p[j];
    for (Rational& c : slope[j - 1]) c *= static_cast<unsigned long>(j);
  }
  if (slope.empty()) return p;
  const auto repeated = gcd(p, slope);
  auto rest = p;
  return divide(rest, repeated);
}

} // namespace corral::exact
