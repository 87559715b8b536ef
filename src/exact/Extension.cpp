// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Extension.h"

#include <algorithm>
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

} // namespace

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
  // Extended Euclid on m and a, the cofactor of a alone.
  Rational_coefficients r0 = monic_;
  Rational_coefficients r1 = a;
  Rational_coefficients s0;
  Rational_coefficients s1 = {1};
  while (r1.size() > 1) {
    auto quotient = divide_rational(r0, r1);
    subtract(s0, product(quotient, s1));
    std::swap(r0, r1);
    std::swap(s0, s1);
  }
  if (r1.empty()) { // r0 is a common factor: alpha is a root of it or of its cofactor
    auto common = to_integer(r0);
    auto alpha = alpha_;
    if (alpha.sign_of(common) == 0) throw Split{std::move(common)};
    throw Split{exact_quotient(m_, common)};
  }
  for (Rational& c : s1) c /= r1.front();
  return reduce(std::move(s1));
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
