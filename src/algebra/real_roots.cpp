// SPDX-License-Identifier: LGPL-3.0-or-later
#include "require_nonzero.h"

#include <corral/algebra/real_roots.h>

#include <algorithm>
#include <utility>

namespace corral {

namespace {

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
std::vector<Integer> weighted_bernstein_coefficients(const Integer_polynomial& p, const Checkpoint& checkpoint = {})
{
  const std::size_t n = degree(p);
  std::vector<Integer> b(p.coefficients().rbegin(), p.coefficients().rend());
  for (std::size_t i = 0; i < n; ++i) {
    if (checkpoint) checkpoint();
    for (std::size_t j = n; j-- > i;) b[j] += b[j + 1];
  }
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
  exact::require_nonzero(p.is_zero(), "bernstein_coefficients");
  return without_weights(weighted_bernstein_coefficients(p));
}

Integer root_bound(const Integer_polynomial& p)
{
  exact::require_nonzero(p.is_zero(), "root_bound");
  // 2 max |p_i / p_n|^(1/(n-i)), rounded up to a power of two
  const auto lead = static_cast<long>(mpz_sizeinbase(p.lead().get_mpz_t(), 2));
  long exponent = 0;
  for (std::size_t i = 0; i + 1 < p.size(); ++i) {
    if (p[i] == 0) continue;
    const long bits = static_cast<long>(mpz_sizeinbase(p[i].get_mpz_t(), 2)) - lead + 1;
    const auto root = static_cast<long>(p.size() - 1 - i);
    if (bits > 0) exponent = std::max(exponent, (bits + root - 1) / root);
  }
  return Integer(1) << static_cast<mp_bitcnt_t>(exponent + 2);
}

std::vector<Real_root> isolate_simple_roots(const std::shared_ptr<const Integer_polynomial>& p,
                                            const Rational_interval& interval, const Checkpoint& checkpoint)
{
  exact::require_nonzero(p->is_zero(), "isolate_simple_roots");
  CORRAL_PRECONDITION(is_square_free(*p),
                      "isolate_simple_roots: given a polynomial with a multiple root; expected none");
  std::vector<Real_root> roots;
  if (interval.lower() == interval.upper()) {
    if (sign_at(*p, interval.lower()) == 0) roots.emplace_back(p, interval, 1);
    return roots;
  }
  auto weighted = weighted_bernstein_coefficients(
      compose_affine(*p, interval.lower(), interval.upper() - interval.lower(), checkpoint), checkpoint);
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
  exact::require_nonzero(p.is_zero(), "isolate_real_roots");
  std::vector<Real_root> roots;
  if (degree(p) == 0) return roots;
  const auto primitive = normalized(p);
  const auto repeated = greatest_common_divisor(primitive, derivative(primitive), checkpoint);
  const bool simple = degree(repeated) == 0;
  const auto free =
      std::make_shared<const Integer_polynomial>(simple ? primitive : exact_quotient(primitive, repeated));
  auto simple_roots = isolate_simple_roots(free, interval, checkpoint);
  if (simple) return simple_roots;
  std::vector<std::shared_ptr<const Integer_polynomial>> factors;
  for (auto& factor : square_free_decomposition(primitive, checkpoint))
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
  if (p.is_zero()) return isolate_real_roots(p, Rational_interval(0), checkpoint);
  const Rational bound(root_bound(p));
  return isolate_real_roots(p, Rational_interval(-bound, bound), checkpoint);
}

std::size_t count_real_roots(const Integer_polynomial& p, const Rational_interval& interval)
{
  return isolate_real_roots(p, interval).size();
}

} // namespace corral
