// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Projected_zeros.h"

#include "Ball.h"
#include "Extension.h"

#include "../polynomial/Flint_ring.h"
#include "../polynomial/to_exponent.h"

#include <corral/errors.h>
#include <corral/polynomial/square_free.h>

#include <algorithm>
#include <utility>

namespace corral::exact {

namespace {

/// a p + b q.
Integer_polynomial combination(const Integer_polynomial& p, const Integer& a, const Integer_polynomial& q,
                               const Integer& b)
{
  std::vector<Integer> result(std::max(p.size(), q.size()));
  for (std::size_t i = 0; i < p.size(); ++i) result[i] += a * p[i];
  for (std::size_t i = 0; i < q.size(); ++i) result[i] += b * q[i];
  return Integer_polynomial(std::move(result));
}

Extension_polynomial over_extension(const Bivariate& f, const Extension& field)
{
  Extension_polynomial result;
  for (const auto& c : f) result.push_back(field.reduce(Rational_coefficients(c.begin(), c.end())));
  trim_leading(result);
  return result;
}

/// The zeros of one pair of polynomials in one direction.
class Projection
{
public:
  using Shared_polynomial = Projected_zero::Shared_polynomial;

  Projection(const Polynomial<Integer, 2>& f, const Polynomial<Integer, 2>& g, long shear, const Checkpoint& checkpoint)
      : f_(bivariate(sheared(f, shear), 1)), g_(bivariate(sheared(g, shear), 1)), shear_(shear), checkpoint_(checkpoint)
  {}

  [[nodiscard]] bool is_proper() const
  {
    return degree(f_.back()) == 0 || degree(g_.back()) == 0
           || degree(greatest_common_divisor(f_.back(), g_.back(), checkpoint_)) == 0;
  }

  /// False if the zeros cannot be told apart in this direction.
  [[nodiscard]] bool run(const std::optional<Rational_box<2>>& box, unsigned least_multiplicity,
                         Projection_result& result)
  {
    if (f_.size() == 1 && g_.size() == 1) return degree(f_[0]) == 0 || degree(g_[0]) == 0;
    auto elimination = eliminate(f_, g_, checkpoint_);
    if (elimination.resultant.is_zero()) return false; // a common factor of degree 0 in y: lines in this direction
    s1_ = std::make_shared<const Integer_polynomial>(std::move(elimination.s1));
    s0_ = std::make_shared<const Integer_polynomial>(std::move(elimination.s0));
    const auto factors = square_free_decomposition(elimination.resultant, checkpoint_);
    for (std::size_t k = 0; k < factors.size(); ++k) {
      const auto multiplicity = static_cast<unsigned>(k + 1);
      if (degree(factors[k]) == 0) continue;
      result.factors.push_back(std::make_shared<const Integer_polynomial>(factors[k]));
      if (multiplicity < least_multiplicity) continue;
      if (!add_roots(result.factors.back(), multiplicity, box, result.zeros)) return false;
    }
    return true;
  }

private:
  [[nodiscard]] bool add_roots(const Shared_polynomial& factor, unsigned multiplicity,
                               const std::optional<Rational_box<2>>& box, std::vector<Projected_zero>& zeros)
  {
    const bool is_linear = !s1_->is_zero() && degree(greatest_common_divisor(*factor, *s1_, checkpoint_)) == 0;
    for (const auto& root : isolate_simple_roots(factor, range(*factor, box), checkpoint_)) {
      Real_root u(factor, root.interval(), multiplicity);
      u.set_checkpoint(checkpoint_);
      std::optional<Projected_zero> zero;
      if (is_linear || (!s1_->is_zero() && u.sign_of(*s1_) != 0))
        zero.emplace(std::move(u), s1_, s0_, shear_, 1U);
      else if (!multiple_zero(std::move(u), zero))
        return false;
      if (zero && (!box || zero->is_in(*box))) zeros.push_back(std::move(*zero));
    }
    return true;
  }

  [[nodiscard]] Rational_interval range(const Integer_polynomial& factor,
                                        const std::optional<Rational_box<2>>& box) const
  {
    if (box) return (*box)[0] + Rational_interval(Rational(shear_)) * (*box)[1];
    const Rational bound(root_bound(factor));
    return {-bound, bound};
  }

  /// The zero over u by the greatest common divisor over Q(u); false if there are several, complex ones included.
  [[nodiscard]] bool multiple_zero(Real_root u, std::optional<Projected_zero>& zero) const
  {
    (void)u.make_rational();
    auto m = u.is_point() ? Integer_polynomial{-u.lower().get_num(), u.lower().get_den()} : irreducible_factor(u);
    for (;;) {
      try {
        const Extension field(m, u);
        const auto h = gcd_over(field, over_extension(f_, field), over_extension(g_, field));
        const auto line = square_free_over(field, h);
        if (line.size() != 2) return false;
        Integer denominator = 1;
        for (const Rational& c : line[0]) denominator = lcm(denominator, c.get_den());
        std::vector<Integer> s0;
        for (const Rational& c : line[0]) s0.push_back(c.get_num() * (denominator / c.get_den()));
        zero.emplace(std::move(u), std::make_shared<const Integer_polynomial>(Integer_polynomial{denominator}),
                     std::make_shared<const Integer_polynomial>(std::move(s0)), shear_,
                     static_cast<unsigned>(h.size() - 1));
        return true;
      } catch (Extension::Split& split) {
        m = std::move(split.factor);
      }
    }
  }

  Bivariate f_;
  Bivariate g_;
  long shear_;
  const Checkpoint& checkpoint_;
  Shared_polynomial s1_;
  Shared_polynomial s0_;
};

} // namespace

bool same(Real_root a, Real_root b)
{
  for (;;) {
    if (a.upper() < b.lower() || b.upper() < a.lower()) return false;
    if (a.is_point()) return b.compare(a.lower()) == 0;
    if (b.is_point()) return a.compare(b.lower()) == 0;
    if (b.lower() <= a.lower() && a.upper() <= b.upper())
      return &a.polynomial() == &b.polynomial() || a.sign_of(b.polynomial()) == 0;
    a.refine();
  }
}

Projected_zero::Projected_zero(Real_root u, Shared_polynomial s1, Shared_polynomial s0, long shear,
                               unsigned fibre_degree)
    : u_(std::move(u)), s1_(std::move(s1)), s0_(std::move(s0)), shear_(shear), fibre_degree_(fibre_degree)
{}

/// y over the interval of u; nothing if that is too wide to tell.
std::optional<Rational_interval> Projected_zero::y() const
{
  if (u_.is_point()) {
    Rational value = -corral::evaluate(*s0_, u_.lower()) / corral::evaluate(*s1_, u_.lower());
    return Rational_interval(std::move(value));
  }
  const Rational width = u_.upper() - u_.lower();
  const auto inverse_bits = static_cast<long>(mpz_sizeinbase(width.get_den_mpz_t(), 2))
                            - static_cast<long>(mpz_sizeinbase(width.get_num_mpz_t(), 2));
  const auto bits = static_cast<mp_bitcnt_t>(std::max(inverse_bits, 0L) + 16);
  const Rational scale(Integer(Integer(1) << bits));
  const Rational low = u_.lower() * scale;
  const Rational high = u_.upper() * scale;
  Ball x;
  mpz_fdiv_q(x.m.get_mpz_t(), low.get_num_mpz_t(), low.get_den_mpz_t());
  mpz_cdiv_q(x.r.get_mpz_t(), high.get_num_mpz_t(), high.get_den_mpz_t());
  x.r -= x.m; // the middle is the lower end: one-sided, but simple
  const Ball denominator = evaluate(*s1_, x, bits);
  const Ball numerator = evaluate(*s0_, x, bits);
  if (abs(denominator.m) <= denominator.r) return std::nullopt;
  const auto quotient = [](const Integer& a, const Integer& b) {
    Rational result(a, b);
    result.canonicalize();
    return result;
  };
  Rational least;
  Rational greatest;
  bool first = true;
  for (const Integer& n : {Integer(numerator.m - numerator.r), Integer(numerator.m + numerator.r)})
    for (const Integer& d : {Integer(denominator.m - denominator.r), Integer(denominator.m + denominator.r)}) {
      const Rational value = -quotient(n, d);
      if (first || value < least) least = value;
      if (first || value > greatest) greatest = value;
      first = false;
    }
  return Rational_interval(std::move(least), std::move(greatest));
}

Rational_box<2> Projected_zero::box(const Rational& width)
{
  if (!u_.is_point()) u_.refine_to(width / 2);
  for (;;) {
    if (const auto second = y()) {
      const auto first = u_.interval() - Rational_interval(Rational(shear_)) * *second;
      if (first.upper() - first.lower() <= width && second->upper() - second->lower() <= width) return {first, *second};
    }
    u_.refine();
  }
}

std::optional<Rational_point<2>> Projected_zero::rational()
{
  if (!u_.make_rational()) return std::nullopt;
  const Rational second = y()->lower();
  return Rational_point<2>{u_.lower() - shear_ * second, second};
}

int Projected_zero::sign_of_linear(const Rational& a, const Rational& b, const Rational& c)
{
  // a (u - shear y) + b y + c, times s1
  const Rational slope = b - a * shear_;
  const Integer common = lcm(lcm(a.get_den(), c.get_den()), slope.get_den());
  const auto integer = [&](const Rational& q) { return Integer(q.get_num() * (common / q.get_den())); };
  const auto numerator =
      combination(multiply(*s1_, Integer_polynomial{integer(c), integer(a)}), 1, *s0_, Integer(-integer(slope)));
  return numerator.is_zero() ? 0 : u_.sign_of(numerator) * u_.sign_of(*s1_);
}

int Projected_zero::sign_of(const Polynomial<Integer, 2>& q)
{
  if (q.is_zero()) return 0;
  const auto by_y = bivariate(sheared(q, shear_), 1);
  // sum q_j(u) (-s0)^j s1^(n-j), by Horner's rule; s1^n is left over
  Integer_polynomial value = by_y.back();
  Integer_polynomial power{1};
  for (std::size_t j = by_y.size() - 1; j-- > 0;) {
    power = multiply(power, *s1_);
    value = combination(multiply(value, *s0_), -1, multiply(by_y[j], power), 1);
  }
  if (value.is_zero()) return 0;
  const int sign = u_.sign_of(value);
  return by_y.size() % 2 == 0 ? sign * u_.sign_of(*s1_) : sign; // an odd power of s1
}

bool Projected_zero::equals(const Rational_point<2>& point) { return rational() == point; }

bool Projected_zero::equals(Projected_zero& other)
{
  if (!same(u_, other.u_)) return false;
  const auto difference = combination(multiply(*s0_, *other.s1_), 1, multiply(*other.s0_, *s1_), -1);
  return difference.is_zero() || u_.sign_of(difference) == 0;
}

bool Projected_zero::is_in(const Rational_box<2>& box)
{
  const Rational shortest = std::min<Rational>(box[0].upper() - box[0].lower(), box[1].upper() - box[1].lower()) / 1024;
  const auto near = this->box(shortest > 0 ? shortest : Rational(1, 1024));
  for (std::size_t k = 0; k < 2; ++k) {
    if (near[k].upper() < box[k].lower() || box[k].upper() < near[k].lower()) return false;
    const auto is_beyond = [&](const Rational& side, int outside) {
      return contains(near[k], side) && sign_of_linear(k == 0 ? 1 : 0, k == 0 ? 0 : 1, -side) == outside;
    };
    if (is_beyond(box[k].lower(), -1) || is_beyond(box[k].upper(), 1)) return false;
  }
  return true;
}

Polynomial<Integer, 2> sheared(const Polynomial<Integer, 2>& f, long shear)
{
  if (shear == 0) return f;
  std::vector<Polynomial<Integer, 2>::Term> terms;
  for (const auto& term : f.terms()) {
    const unsigned n = term.exponents[0];
    Integer coefficient = term.coefficient; // times C(n, k) (-shear)^k
    for (unsigned k = 0; k <= n; ++k) {
      terms.push_back(
          {{static_cast<std::uint16_t>(n - k), detail::to_exponent(std::size_t{term.exponents[1]} + k)}, coefficient});
      coefficient *= -shear;
      coefficient *= static_cast<unsigned long>(n - k);
      mpz_divexact_ui(coefficient.get_mpz_t(), coefficient.get_mpz_t(), k + 1);
    }
  }
  return collect<Integer, 2>(std::move(terms));
}

std::optional<Projection_result> projected_zeros(const Polynomial<Integer, 2>& f, const Polynomial<Integer, 2>& g,
                                                 long shear, const std::optional<Rational_box<2>>& box,
                                                 unsigned least_multiplicity, const Checkpoint& checkpoint)
{
  Projection_result result;
  if (f.is_constant() || g.is_constant()) return result;
  Projection projection(f, g, shear, checkpoint);
  if (!projection.is_proper() || !projection.run(box, least_multiplicity, result)) return std::nullopt;
  return result;
}

} // namespace corral::exact
