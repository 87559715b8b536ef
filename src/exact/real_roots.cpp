// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/errors.h>
#include <corral/verification/real_roots.h>

#include <algorithm>
#include <utility>

namespace corral {

namespace {

Rational power_of_two(std::size_t exponent) { return Rational(Integer(Integer(1) << exponent)); }

/// The dyadic point k / 2^depth of [0, 1], and the map to the caller's interval.
struct Unit_map
{
  Rational_interval interval;
  [[nodiscard]] Rational operator()(const Integer& k, std::size_t depth) const
  {
    Rational t(k, Integer(Integer(1) << depth));
    t.canonicalize();
    return interval.lower() + (interval.upper() - interval.lower()) * t;
  }
};

/// Divides all coefficients by the power of two that they share.
void drop_twos(std::vector<Integer>& b)
{
  mp_bitcnt_t twos = ~mp_bitcnt_t{0};
  for (const Integer& c : b)
    if (c != 0) twos = std::min(twos, mpz_scan1(c.get_mpz_t(), 0));
  if (twos == 0 || twos == ~mp_bitcnt_t{0}) return;
  for (Integer& c : b) mpz_tdiv_q_2exp(c.get_mpz_t(), c.get_mpz_t(), twos);
}

/// de Casteljau at 1/2 without fractions: b becomes the upper half, the lower half is returned.
std::vector<Integer> halve(std::vector<Integer>& b)
{
  const std::size_t n = b.size() - 1;
  std::vector<Integer> lower(n + 1);
  for (std::size_t k = 0; k <= n; ++k) {
    mpz_mul_2exp(lower[k].get_mpz_t(), b[0].get_mpz_t(), n - k);
    for (std::size_t i = 0; i + k < n; ++i) b[i] += b[i + 1];
    // now b[n-k] is final for the upper half, with weight 2^k; bring it to 2^n
    mpz_mul_2exp(b[n - k].get_mpz_t(), b[n - k].get_mpz_t(), n - k);
  }
  drop_twos(lower);
  drop_twos(b);
  return lower;
}

/// Isolation of the roots of a square-free polynomial in (0, 1).
class Isolator
{
public:
  Isolator(const Unit_map& map, const Checkpoint& checkpoint) : map_(map), checkpoint_(checkpoint) {}

  void run(std::vector<Integer> b)
  {
    if (b.front() == 0) found_.push_back(Rational_interval(map_(0, 0)));
    const bool upper_end = b.back() == 0;
    open_interval(std::move(b), 0, 0);
    if (upper_end) found_.push_back(Rational_interval(map_(1, 0)));
  }
  std::vector<Rational_interval> take() { return std::move(found_); }

private:
  void open_interval(std::vector<Integer> b, const Integer& k, std::size_t depth)
  {
    if (checkpoint_) checkpoint_();
    const std::size_t variations = sign_variations(b);
    if (variations == 0) return;
    if (variations == 1 && b.front() != 0 && b.back() != 0) {
      found_.push_back({map_(k, depth), map_(k + 1, depth)});
      return;
    }
    auto lower = halve(b);
    const Integer middle = 2 * k + 1;
    const bool root_in_the_middle = b.front() == 0;
    open_interval(std::move(lower), 2 * k, depth + 1);
    if (root_in_the_middle) found_.push_back(Rational_interval(map_(middle, depth + 1)));
    open_interval(std::move(b), middle, depth + 1);
  }

  const Unit_map& map_;
  const Checkpoint& checkpoint_;
  std::vector<Rational_interval> found_;
};

} // namespace

std::size_t sign_variations(const std::vector<Integer>& values)
{
  std::size_t variations = 0;
  int last = 0;
  for (const Integer& value : values) {
    const int sign = sgn(value);
    if (sign == 0) continue;
    if (sign == -last) ++variations;
    last = sign;
  }
  return variations;
}

namespace {

/// C(n, k) b_k for the Bernstein coefficients b_k: those of (1 + x)^n p(1 / (1 + x)), from the highest down.
std::vector<Integer> weighted_bernstein_coefficients(const Integer_polynomial& p)
{
  const std::size_t n = degree(p);
  std::vector<Integer> b(p.rbegin(), p.rend());
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = n; j-- > i;) b[j] += b[j + 1];
  std::reverse(b.begin(), b.end());
  return b;
}

std::vector<Integer> without_weights(std::vector<Integer> b)
{
  const std::size_t n = b.size() - 1;
  // times k! (n-k)! makes n! b_k
  std::vector<Integer> factorial(n + 1, Integer(1));
  for (std::size_t k = 2; k <= n; ++k) factorial[k] = factorial[k - 1] * static_cast<unsigned long>(k);
  for (std::size_t k = 0; k <= n; ++k) b[k] *= factorial[k] * factorial[n - k];
  Integer divisor = 0;
  for (const Integer& c : b) divisor = gcd(divisor, c);
  if (divisor > 1)
    for (Integer& c : b) mpz_divexact(c.get_mpz_t(), c.get_mpz_t(), divisor.get_mpz_t());
  return b;
}

} // namespace

std::vector<Integer> bernstein_coefficients(const Integer_polynomial& p)
{
  return without_weights(weighted_bernstein_coefficients(p));
}

Integer root_bound(const Integer_polynomial& p)
{
  // 2 max |p_i / p_n|^(1/(n-i)), rounded up to a power of two
  const auto lead = static_cast<long>(mpz_sizeinbase(p.back().get_mpz_t(), 2));
  long exponent = 0;
  for (std::size_t i = 0; i + 1 < p.size(); ++i) {
    if (p[i] == 0) continue;
    const long bits = static_cast<long>(mpz_sizeinbase(p[i].get_mpz_t(), 2)) - lead + 1;
    const auto root = static_cast<long>(p.size() - 1 - i);
    if (bits > 0) exponent = std::max(exponent, (bits + root - 1) / root);
  }
  return Integer(1) << static_cast<mp_bitcnt_t>(exponent + 2);
}

Rational simplest_rational(const Rational_interval& interval)
{
  if (interval.lower() <= 0 && interval.upper() >= 0) return 0;
  if (interval.upper() < 0) return -simplest_rational(-interval);
  // Continued fractions: the integer parts agree until one end is passed.
  Integer whole;
  mpz_cdiv_q(whole.get_mpz_t(), interval.lower().get_num_mpz_t(), interval.lower().get_den_mpz_t());
  if (whole <= interval.upper()) return whole;
  --whole;
  const Rational rest = simplest_rational({1 / (interval.upper() - whole), 1 / (interval.lower() - whole)});
  return whole + 1 / rest;
}

Real_root::Real_root(std::shared_ptr<const Integer_polynomial> polynomial, Rational_interval interval,
                     unsigned multiplicity)
    : polynomial_(std::move(polynomial)), interval_(std::move(interval)), multiplicity_(multiplicity)
{
  if (!is_point()) lower_sign_ = sign_at(*polynomial_, lower());
}

void Real_root::narrow(Rational low, Rational high) { interval_ = Rational_interval(std::move(low), std::move(high)); }

void Real_root::refine()
{
  if (is_point()) return;
  const Rational width = upper() - lower();
  const Rational low = corral::evaluate(*polynomial_, lower());
  const Rational high = corral::evaluate(*polynomial_, upper());
  const Rational part = width / power_of_two(log_parts_);
  const Rational guess = low / (low - high) * power_of_two(log_parts_);
  Integer k;
  mpz_fdiv_q(k.get_mpz_t(), guess.get_num_mpz_t(), guess.get_den_mpz_t());
  const Rational left = lower() + part * k;
  const Rational right = left + part;
  const int left_sign = k == 0 ? lower_sign_ : sign_at(*polynomial_, left);
  const int right_sign = right == upper() ? -lower_sign_ : sign_at(*polynomial_, right);
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
    const int sign = sign_at(*polynomial_, middle);
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
  while (upper() - lower() > width) refine();
}

bool Real_root::make_rational()
{
  if (is_point()) return true;
  if (known_irrational_) return false;
  // A rational root is a multiple of 1 / leading coefficient, and a short interval holds at most one.
  const Integer& lead = polynomial_->back();
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
    if (lower() < candidate && candidate < upper() && sign_at(*polynomial_, candidate) == 0) {
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
    if (is_point()) return sign_at(q, lower());
    if (const int sign = strict_sign(corral::evaluate(q, interval_)); sign != 0) return sign;
    if (q.empty()) return 0;
    if (round >= 3 && !compared) {
      // The greatest common divisor vanishes at the root iff it changes sign over the interval.
      const auto common = greatest_common_divisor(*polynomial_, q);
      if (degree(common) > 0 && sign_at(common, lower()) != sign_at(common, upper())) return 0;
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
  const int sign = sign_at(*polynomial_, x);
  if (sign == 0)
    narrow(x, x);
  else if (sign == lower_sign_)
    narrow(x, upper());
  else
    narrow(lower(), x);
  return sign == 0 ? 0 : sign == lower_sign_ ? 1 : -1;
}

std::vector<Real_root> isolate_simple_roots(const std::shared_ptr<const Integer_polynomial>& p,
                                            const Rational_interval& interval, const Checkpoint& checkpoint)
{
  std::vector<Real_root> roots;
  if (interval.lower() == interval.upper()) {
    if (sign_at(*p, interval.lower()) == 0) roots.emplace_back(p, interval, 1);
    return roots;
  }
  auto weighted =
      weighted_bernstein_coefficients(compose_affine(*p, interval.lower(), interval.upper() - interval.lower()));
  if (sign_variations(weighted) == 0 && weighted.front() != 0 && weighted.back() != 0) return roots;
  const Unit_map map{interval};
  Isolator isolator(map, checkpoint);
  isolator.run(without_weights(std::move(weighted)));
  for (auto& where : isolator.take()) roots.emplace_back(p, std::move(where), 1);
  return roots;
}

std::vector<Real_root> isolate_real_roots(const Integer_polynomial& p, const Rational_interval& interval,
                                          const Checkpoint& checkpoint)
{
  if (p.empty())
    throw Invalid_input("isolate_real_roots: the polynomial is zero; expected one with finitely many roots");
  std::vector<Real_root> roots;
  if (degree(p) == 0) return roots;
  const auto primitive = primitive_part(p);
  const auto repeated = greatest_common_divisor(primitive, derivative(primitive));
  const bool simple = degree(repeated) == 0;
  const auto free =
      std::make_shared<const Integer_polynomial>(simple ? primitive : exact_quotient(primitive, repeated));
  auto simple_roots = isolate_simple_roots(free, interval, checkpoint);
  if (simple) return simple_roots;
  std::vector<std::shared_ptr<const Integer_polynomial>> factors;
  for (auto& factor : square_free_decomposition(primitive))
    factors.push_back(std::make_shared<const Integer_polynomial>(std::move(factor)));
  // The one factor that vanishes inside changes sign; the others have no root there.
  for (const auto& root : simple_roots)
    for (std::size_t k = 0; k < factors.size(); ++k)
      if (sign_at(*factors[k], root.lower()) * sign_at(*factors[k], root.upper()) <= 0) {
        roots.emplace_back(factors[k], root.interval(), static_cast<unsigned>(k + 1));
        break;
      }
  return roots;
}

std::vector<Real_root> isolate_real_roots(const Integer_polynomial& p, const Checkpoint& checkpoint)
{
  if (p.empty()) return isolate_real_roots(p, Rational_interval(0), checkpoint);
  const Rational bound(root_bound(p));
  return isolate_real_roots(p, Rational_interval(-bound, bound), checkpoint);
}

std::size_t count_real_roots(const Integer_polynomial& p, const Rational_interval& interval)
{
  return isolate_real_roots(p, interval).size();
}

} // namespace corral
