// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Extension.h"

#include "Flint_integer_polynomial.h"

#include <corral/internal/number/Wrong_answer.h>

#include <algorithm>
#include <flint/fmpq_poly.h>
#include <flint/fmpz_poly_factor.h>
#include <string>
#include <utility>

namespace corral::exact {

namespace {

void trim(Rational_coefficients& a)
{
  while (!a.empty() && a.back() == 0) a.pop_back();
}

/// Integers over one denominator, a from the constant coefficient up.
struct Over_denominator
{
  explicit Over_denominator(const Rational_coefficients& a)
  {
    for (const Rational& c : a) denominator = lcm(denominator, c.get_den());
    std::vector<Integer> numerators;
    for (const Rational& c : a) numerators.push_back(c.get_num() * (denominator / c.get_den()));
    numerator = Integer_polynomial(std::move(numerators));
  }
  Integer_polynomial numerator;
  Integer denominator = 1;
};

/// Owner of a FLINT polynomial over the rationals.
class Flint_polynomial
{
public:
  Flint_polynomial() { fmpq_poly_init(value_); }
  explicit Flint_polynomial(const Rational_coefficients& a) : Flint_polynomial()
  {
    const Over_denominator whole(a); // one for all: coefficient by coefficient, FLINT would reduce the whole each time
    fmpq_poly_set_fmpz_poly(value_, Flint_integer_polynomial(whole.numerator).get());
    fmpq_poly_scalar_div_mpz(value_, value_, whole.denominator.get_mpz_t());
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
  const Flint_integer_polynomial p(alpha.polynomial());
  fmpz_poly_factor_t factors;
  fmpz_poly_factor_init(factors);
  fmpz_poly_factor(factors, p.get());
  Integer_polynomial result = alpha.polynomial();
  for (slong k = 0; k < factors->num; ++k) {
    auto factor = Flint_integer_polynomial::coefficients(factors->p + k);
    if (sign_at(factor, alpha.lower()) != sign_at(factor, alpha.upper())) result = std::move(factor);
  }
  fmpz_poly_factor_clear(factors);
  if (!divides(result, alpha.polynomial()))
    throw Wrong_answer("algebra: FLINT gives a factor of a polynomial of the degree "
                       + std::to_string(degree(alpha.polynomial())) + " that does not divide it");
  return result;
}

Extension::Extension(Integer_polynomial m, Real_root alpha) : m_(std::move(m)), alpha_(std::move(alpha))
{
  for (const Integer& c : m_) {
    monic_.emplace_back(c, m_.lead());
    monic_.back().canonicalize();
  }
}

Rational_coefficients Extension::reduce(Rational_coefficients a) const
{
  alpha_.check();
  trim(a);
  if (a.size() < monic_.size()) return a;
  Flint_polynomial value(a);
  fmpq_poly_rem(value.get(), value.get(), Flint_polynomial(monic_).get());
  return value.coefficients();
}

Rational_coefficients Extension::negative(Rational_coefficients a)
{
  for (Rational& c : a) c = -c;
  return a;
}

Rational_coefficients Extension::times(Rational_coefficients a, unsigned long factor)
{
  for (Rational& c : a) c *= factor;
  return a;
}

void Extension::subtract(Rational_coefficients& a, const Rational_coefficients& b)
{
  if (a.size() < b.size()) a.resize(b.size());
  for (std::size_t i = 0; i < b.size(); ++i) a[i] -= b[i];
  trim(a);
}

Rational_coefficients Extension::multiply(const Rational_coefficients& a, const Rational_coefficients& b) const
{
  alpha_.check();
  if (a.empty() || b.empty()) return {};
  Flint_polynomial value(a);
  fmpq_poly_mul(value.get(), value.get(), Flint_polynomial(b).get());
  fmpq_poly_rem(value.get(), value.get(), Flint_polynomial(monic_).get());
  return value.coefficients();
}

Rational_coefficients Extension::inverse(const Rational_coefficients& a) const
{
  alpha_.check();
  const Flint_polynomial element(a);
  const Flint_polynomial modulus(monic_);
  Flint_polynomial common;
  Flint_polynomial cofactor;
  Flint_polynomial other;
  fmpq_poly_xgcd(common.get(), cofactor.get(), other.get(), element.get(), modulus.get()); // common is monic
  if (fmpq_poly_degree(common.get()) == 0) {
    auto result = cofactor.coefficients();
    if (multiply(a, result) != one()) throw Wrong_answer("algebra: FLINT gives a wrong inverse in an extension");
    return result;
  }
  // alpha is a root of the common factor or of its cofactor
  auto factor = normalized(Over_denominator(common.coefficients()).numerator);
  auto alpha = alpha_;
  if (alpha.sign_of(factor) == 0) throw Split{std::move(factor)};
  throw Split{exact_quotient(normalized(m_), factor)};
}

Tower::Tower(Extension base, Extension_polynomial h, Rational_interval beta)
    : base_(std::move(base)), h_(std::move(h)), beta_(std::move(beta))
{}

Extension_polynomial Tower::reduce(Extension_polynomial a) const
{
  for (auto& c : a) c = base_.reduce(std::move(c));
  trim_leading(a);
  (void)divide(base_, a, h_);
  return a;
}

Extension_polynomial Tower::negative(Extension_polynomial a)
{
  for (auto& c : a) c = Extension::negative(std::move(c));
  return a;
}

Extension_polynomial Tower::times(Extension_polynomial a, unsigned long factor)
{
  for (auto& c : a) c = Extension::times(std::move(c), factor);
  return a;
}

void Tower::subtract(Extension_polynomial& a, const Extension_polynomial& b)
{
  if (a.size() < b.size()) a.resize(b.size());
  for (std::size_t j = 0; j < b.size(); ++j) Extension::subtract(a[j], b[j]);
  trim_leading(a);
}

Extension_polynomial Tower::multiply(const Extension_polynomial& a, const Extension_polynomial& b) const
{
  auto result = product(base_, a, b);
  (void)divide(base_, result, h_);
  return result;
}

/// Euclid's algorithm on h and a with the cofactor of a.
Extension_polynomial Tower::inverse(const Extension_polynomial& a) const
{
  Extension_polynomial p = h_;
  Extension_polynomial q = a;
  Extension_polynomial p_cofactor;
  Extension_polynomial q_cofactor = one();
  while (true) {
    const auto factor = base_.inverse(q.back());
    q = scaled(base_, std::move(q), factor);
    q_cofactor = scaled(base_, std::move(q_cofactor), factor);
    if (q.size() == 1) return reduce(q_cofactor);
    const auto quotient = divide(base_, p, q);
    if (p.empty()) break;
    subtract(p_cofactor, product(base_, quotient, q_cofactor));
    std::swap(p, q);
    std::swap(p_cofactor, q_cofactor);
  }
  // beta is a root of the common factor q or of the rest of h
  auto alpha = base_.alpha();
  const int below = alpha.sign_of(value_at(q, beta_.lower()));
  const int above = alpha.sign_of(value_at(q, beta_.upper()));
  if (below != above) throw Split{std::move(q)};
  auto rest = h_;
  throw Split{divide(base_, rest, q)};
}

Integer_polynomial value_at(const Extension_polynomial& h, const Rational& y)
{
  Rational_coefficients value;
  for (std::size_t j = h.size(); j-- > 0;) {
    for (Rational& c : value) c *= y;
    if (value.size() < h[j].size()) value.resize(h[j].size());
    for (std::size_t i = 0; i < h[j].size(); ++i) value[i] += h[j][i];
  }
  return Over_denominator(value).numerator;
}

} // namespace corral::exact
