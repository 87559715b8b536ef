// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/algebra/real_roots.h>
#include <corral/errors.h>

#include <algorithm>
#include <utility>

namespace corral {

namespace {

Rational power_of_two(std::size_t exponent) { return Rational(Integer(Integer(1) << exponent)); }

} // namespace

Real_root::Real_root(std::shared_ptr<const Integer_polynomial> polynomial, Rational_interval interval,
                     unsigned multiplicity)
    : polynomial_(std::move(polynomial)), interval_(std::move(interval)), multiplicity_(multiplicity)
{
  if (!polynomial_) throw Invalid_input("Real_root: given no polynomial; expected one with the root");
  CORRAL_PRECONDITION(is_square_free(*polynomial_),
                      "Real_root: given a polynomial with a multiple root; expected none");
  if (is_point()) {
    CORRAL_PRECONDITION(sign_at(lower()) == 0, "Real_root: given a point that is no root; expected one");
    return;
  }
  lower_sign_ = sign_at(lower());
  if (lower_sign_ * sign_at(upper()) >= 0)
    throw Invalid_input("Real_root: given the interval [" + to_string(lower()) + ", " + to_string(upper())
                        + "]; expected opposite signs at its ends");
}

int Real_root::sign_at(const Rational& x) const
{
  check();
  return corral::sign_at(*polynomial_, x);
}

void Real_root::narrow(Rational low, Rational high) { interval_ = Rational_interval(std::move(low), std::move(high)); }

void Real_root::refine()
{
  if (is_point()) return;
  check();
  const Rational width = upper() - lower();
  const Rational low = corral::evaluate(*polynomial_, lower());
  const Rational high = corral::evaluate(*polynomial_, upper());
  const Rational part = width / power_of_two(log_parts_);
  const Rational guess = low / (low - high) * power_of_two(log_parts_);
  Integer k;
  mpz_fdiv_q(k.get_mpz_t(), guess.get_num_mpz_t(), guess.get_den_mpz_t());
  const Rational left = lower() + part * k;
  const Rational right = left + part;
  const int left_sign = k == 0 ? lower_sign_ : sign_at(left);
  const int right_sign = right == upper() ? -lower_sign_ : sign_at(right);
  if (left_sign == 0) return narrow(left, left);
  if (right_sign == 0) return narrow(right, right);
  if (left_sign != right_sign) {
    log_parts_ = std::min(log_parts_ * 2, 1U << 12);
    return narrow(left, right);
  }
  // The secant missed. Keep the side that has the root and halve it, twice to keep the promise.
  log_parts_ = std::max(log_parts_ / 2, 2U);
  if (left_sign == lower_sign_)
    narrow(right, upper());
  else
    narrow(lower(), left);
  const Rational target = width / 4;
  while (!is_point() && upper() - lower() > target) {
    const Rational middle = (lower() + upper()) / 2;
    const int sign = sign_at(middle);
    if (sign == 0)
      narrow(middle, middle);
    else if (sign == lower_sign_)
      narrow(middle, upper());
    else
      narrow(lower(), middle);
  }
}

void Real_root::refine_to(const Rational& width)
{
  if (sgn(width) <= 0)
    throw Invalid_input("Real_root: given the width " + to_string(width) + "; expected a positive number");
  while (upper() - lower() > width) refine();
}

bool Real_root::make_rational()
{
  if (is_point()) return true;
  if (known_irrational_) return false;
  // A rational root is a multiple of 1 / leading coefficient, and a short interval holds at most one.
  const Integer& lead = polynomial_->lead();
  refine_to(Rational(1) / (2 * abs(lead)));
  if (is_point()) return true;
  const Rational scaled = lower() * lead;
  Integer k;
  for (const bool up : {false, true}) {
    if (up)
      mpz_cdiv_q(k.get_mpz_t(), scaled.get_num_mpz_t(), scaled.get_den_mpz_t());
    else
      mpz_fdiv_q(k.get_mpz_t(), scaled.get_num_mpz_t(), scaled.get_den_mpz_t());
    Rational candidate(k, lead);
    candidate.canonicalize();
    if (lower() < candidate && candidate < upper() && sign_at(candidate) == 0) {
      narrow(candidate, candidate);
      return true;
    }
  }
  known_irrational_ = true;
  return false;
}

int Real_root::sign_of(const Integer_polynomial& q)
{
  bool compared = false;
  for (int round = 0;; ++round) {
    check();
    if (is_point()) return corral::sign_at(q, lower());
    if (const int sign = strict_sign(corral::evaluate(q, interval_)); sign != 0) return sign;
    if (q.is_zero()) return 0;
    if (round >= 3 && !compared) {
      // The greatest common divisor vanishes at the root iff it changes sign over the interval.
      const auto common = greatest_common_divisor(*polynomial_, q, checkpoint_);
      if (degree(common) > 0 && corral::sign_at(common, lower()) != corral::sign_at(common, upper())) return 0;
      compared = true;
    }
    refine();
  }
}

int Real_root::compare(const Rational& x)
{
  if (is_point()) return cmp(lower(), x) < 0 ? -1 : cmp(lower(), x) > 0 ? 1 : 0;
  if (x <= lower()) return 1;
  if (x >= upper()) return -1;
  const int sign = sign_at(x);
  if (sign == 0)
    narrow(x, x);
  else if (sign == lower_sign_)
    narrow(x, upper());
  else
    narrow(lower(), x);
  return sign == 0 ? 0 : sign == lower_sign_ ? 1 : -1;
}

} // namespace corral
