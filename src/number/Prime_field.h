// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_NUMBER_PRIME_FIELD_H
#define CORRAL_SRC_NUMBER_PRIME_FIELD_H

#include <corral/number/Rational.h>

#include <cstddef>
#include <cstdint>
#include <vector>

/// \file
/// Arithmetic modulo a prime below 2^62: images of exact computations that would swell over the integers.
namespace corral::exact {

__extension__ using Wide = unsigned __int128;

/// \brief The integers modulo an odd prime below 2^62, in Montgomery form.
class Prime_field
{
public:
  using Element = std::uint64_t;

  explicit Prime_field(std::uint64_t prime);

  [[nodiscard]] std::uint64_t prime() const { return prime_; }
  [[nodiscard]] Element zero() const { return 0; }
  [[nodiscard]] Element one() const { return one_; }

  [[nodiscard]] Element add(Element a, Element b) const
  {
    const Element sum = a + b;
    return sum >= prime_ ? sum - prime_ : sum;
  }
  [[nodiscard]] Element subtract(Element a, Element b) const { return a >= b ? a - b : a + prime_ - b; }
  [[nodiscard]] Element multiply(Element a, Element b) const { return reduce(Wide{a} * b); }
  [[nodiscard]] Element inverse(Element a) const; ///< \pre a != 0; FLINT finds it, a product verifies it

  [[nodiscard]] Element from_residue(std::uint64_t a) const { return multiply(a % prime_, square_); }
  [[nodiscard]] Element from(const Integer& a) const { return from_residue(mpz_fdiv_ui(a.get_mpz_t(), prime_)); }
  [[nodiscard]] std::uint64_t residue(Element a) const { return reduce(a); }

private:
  [[nodiscard]] std::uint64_t reduce(Wide t) const
  {
    const std::uint64_t m = static_cast<std::uint64_t>(t) * inverse_;
    const auto high = static_cast<std::uint64_t>((t + Wide{m} * prime_) >> 64);
    return high >= prime_ ? high - prime_ : high;
  }

  std::uint64_t prime_;
  std::uint64_t inverse_; ///< -1 / prime modulo 2^64
  std::uint64_t one_;     ///< 2^64 modulo the prime
  std::uint64_t square_;  ///< 2^128 modulo the prime
};

/// The primes below 2^62 in decreasing order.
class Large_primes
{
public:
  [[nodiscard]] std::uint64_t next();

private:
  std::size_t taken_ = 0;
  std::uint64_t last_ = 0;
};

/// A dense polynomial over a prime field, leading coefficient not zero.
using Modular_polynomial = std::vector<Prime_field::Element>;

[[nodiscard]] Modular_polynomial image(const Prime_field& field, const std::vector<Integer>& p);
[[nodiscard]] Modular_polynomial modular_gcd(const Prime_field& field, Modular_polynomial p, Modular_polynomial q);

/// The last two subresultants of two polynomials: the resultant and the linear one, s1 y + s0.
struct Modular_elimination
{
  Prime_field::Element resultant = 0;
  Prime_field::Element s1 = 0;
  Prime_field::Element s0 = 0;
  bool has_linear = false; ///< whether s1 and s0 are known; else the remainders skip degree 1
};

/// \brief The resultant of two polynomials that are not zero, and their linear subresultant.
/// \par Complexity  deg p * deg q multiplications.
/// \par Reference  S_j(p, q) = (-1)^((n-j)(m-j)) lc(q)^(n-l) S_j(q, r) with r = p mod q of degree l >= j.
[[nodiscard]] Modular_elimination modular_elimination(const Prime_field& field, Modular_polynomial p,
                                                      Modular_polynomial q);

/// \brief Integers known modulo a growing product of primes (Chinese remainders), read back in (-M/2, M/2).
class Chinese_remainder
{
public:
  /// Adds residues modulo one more prime. \pre as many as the first time.
  void add(std::uint64_t prime, const std::vector<std::uint64_t>& residues);
  [[nodiscard]] const Integer& modulus() const { return modulus_; }
  [[nodiscard]] std::vector<Integer> symmetric() const;
  void clear();

private:
  Integer modulus_ = 1;
  std::vector<Integer> values_;
};

} // namespace corral::exact

#endif
