// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Prime_field.h"

#include <corral/internal/number/Wrong_answer.h>

#include <flint/ulong_extras.h>

#include <array>

namespace corral::exact {

using Element = Prime_field::Element;

Prime_field::Prime_field(std::uint64_t prime) : prime_(prime)
{
  std::uint64_t inverse = prime; // right modulo 8; each step doubles the number of right bits
  for (int i = 0; i < 5; ++i) inverse *= 2 - prime * inverse;
  inverse_ = ~inverse + 1;
  one_ = static_cast<std::uint64_t>((Wide{1} << 64) % prime);
  square_ = static_cast<std::uint64_t>(Wide{one_} * one_ % prime);
}

Element Prime_field::inverse(Element a) const
{
  const Element result = from_residue(n_invmod(residue(a), prime_));
  if (multiply(a, result) != one_) throw Wrong_answer("number: the inverse modulo a prime is none");
  return result;
}

std::uint64_t Large_primes::next()
{
  // 2^62 minus these: most computations need no more, and the search takes longer than they do.
  static constexpr std::array<std::uint16_t, 96> distances = {
      57,   87,   117,  143,  153,  167,  171,  195,  203,  273,  287,  317,  443,  483,  495,  575,
      581,  603,  633,  663,  765,  773,  777,  791,  813,  831,  923,  981,  993,  1001, 1007, 1017,
      1197, 1241, 1293, 1353, 1433, 1515, 1553, 1575, 1581, 1595, 1617, 1673, 1697, 1701, 1703, 1823,
      1881, 1911, 1923, 2043, 2073, 2103, 2141, 2187, 2217, 2247, 2285, 2351, 2367, 2375, 2397, 2421,
      2511, 2541, 2583, 2661, 2675, 2753, 2777, 2793, 2861, 2891, 2927, 3023, 3041, 3221, 3251, 3255,
      3257, 3263, 3317, 3377, 3521, 3537, 3545, 3551, 3563, 3671, 3705, 3767, 3797, 3803, 3873, 3933};
  if (taken_ < distances.size()) return last_ = (std::uint64_t{1} << 62) - distances[taken_++];
  Integer candidate = last_;
  do candidate -= 2;
  while (mpz_probab_prime_p(candidate.get_mpz_t(), 30) == 0); // no composite of this size passes (Baillie-PSW)
  return last_ = candidate.get_ui();
}

namespace {

void trim(Modular_polynomial& p)
{
  while (!p.empty() && p.back() == 0) p.pop_back();
}

/// Replaces p by its remainder modulo q.
void reduce(const Prime_field& field, Modular_polynomial& p, const Modular_polynomial& q)
{
  const Element inverse = field.inverse(q.back());
  while (p.size() >= q.size()) {
    const Element factor = field.multiply(p.back(), inverse);
    const std::size_t shift = p.size() - q.size();
    for (std::size_t i = 0; i + 1 < q.size(); ++i)
      p[shift + i] = field.subtract(p[shift + i], field.multiply(factor, q[i]));
    p.pop_back();
    trim(p);
  }
}

Element power(const Prime_field& field, Element base, std::size_t exponent)
{
  Element result = field.one();
  for (; exponent != 0; exponent >>= 1, base = field.multiply(base, base))
    if ((exponent & 1) != 0) result = field.multiply(result, base);
  return result;
}

} // namespace

Modular_polynomial image(const Prime_field& field, const std::vector<Integer>& p)
{
  Modular_polynomial result(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) result[i] = field.from(p[i]);
  trim(result);
  return result;
}

Modular_polynomial modular_gcd(const Prime_field& field, Modular_polynomial p, Modular_polynomial q)
{
  while (!q.empty()) {
    reduce(field, p, q);
    std::swap(p, q);
  }
  if (p.empty()) return p;
  const Element inverse = field.inverse(p.back());
  for (Element& c : p) c = field.multiply(c, inverse);
  return p;
}

Modular_elimination modular_elimination(const Prime_field& field, Modular_polynomial p, Modular_polynomial q)
{
  Modular_elimination result;
  Element resultant = field.one(); // factor of the resultant found so far
  Element linear = field.one();    // and of the linear subresultant
  const auto odd_steps = [&](std::size_t n, std::size_t m) {
    if (n % 2 == 1 && m % 2 == 1) resultant = field.subtract(0, resultant);
    if (n % 2 == 0 && m % 2 == 0) linear = field.subtract(0, linear);
  };
  if (p.size() < q.size()) {
    odd_steps(p.size() - 1, q.size() - 1);
    std::swap(p, q);
  }
  while (q.size() > 1) {
    const std::size_t n = p.size() - 1;
    const std::size_t m = q.size() - 1;
    if (m == 1) {
      linear = field.multiply(linear, power(field, q.back(), n < 2 ? 0 : n - 2));
      result.s1 = field.multiply(linear, q[1]);
      result.s0 = field.multiply(linear, q[0]);
      result.has_linear = true;
    }
    reduce(field, p, q);
    if (p.empty()) { // a common factor of degree m: the subresultants below it vanish
      result.has_linear = true;
      return result;
    }
    const Element factor = power(field, q.back(), n - (p.size() - 1));
    resultant = field.multiply(resultant, factor);
    linear = field.multiply(linear, factor);
    odd_steps(n, m);
    std::swap(p, q);
  }
  result.resultant = field.multiply(resultant, power(field, q.front(), p.size() - 1));
  return result;
}

void Chinese_remainder::add(std::uint64_t prime, const std::vector<std::uint64_t>& residues)
{
  if (values_.empty()) {
    values_.resize(residues.size());
    modulus_ = 1;
  }
  const Prime_field field(prime);
  const Element inverse = field.inverse(field.from(modulus_));
  for (std::size_t i = 0; i < residues.size(); ++i) {
    const Element known = field.from(values_[i]);
    const Element step = field.multiply(field.subtract(field.from_residue(residues[i]), known), inverse);
    mpz_addmul_ui(values_[i].get_mpz_t(), modulus_.get_mpz_t(), field.residue(step));
  }
  modulus_ *= prime;
}

std::vector<Integer> Chinese_remainder::symmetric() const
{
  std::vector<Integer> result = values_;
  const Integer half = modulus_ / 2;
  for (Integer& value : result)
    if (value > half) value -= modulus_;
  return result;
}

void Chinese_remainder::clear()
{
  modulus_ = 1;
  values_.clear();
}

} // namespace corral::exact
