// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_TEST_CONFORMANCE_RANDOM_H
#define CORRAL_TEST_CONFORMANCE_RANDOM_H

#include <corral/number/Rational.h>
#include <corral/number/Rational_interval.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <random>

namespace corral::test {

/// `base` rounds, times the environment variable CORRAL_TEST_MULTIPLIER.
inline int rounds(int base)
{
  const char* multiplier = std::getenv("CORRAL_TEST_MULTIPLIER");
  return base * std::max(1, multiplier == nullptr ? 1 : std::atoi(multiplier));
}

/// Random exact data biased to where rounding goes wrong. The same seed gives the same data.
class Random
{
public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// Uniform in [low, high].
  long integer(long low, long high) { return std::uniform_int_distribution<long>(low, high)(engine_); }
  bool chance(int one_in) { return integer(1, one_in) == 1; }

  /// A number whose mantissa fills a double, of a magnitude around 1.
  Rational full_mantissa() { return scaled(Integer(integer(1L << 52, (1L << 53) - 1)) * sign(), integer(-56, -48)); }

  /// Zero, small integers, full mantissas, neighbours of powers of two, fractions, and both ends of the range of
  /// doubles.
  Rational trouble()
  {
    switch (integer(0, 9)) {
    case 0:
      return 0;
    case 1:
      return integer(-9, 9);
    case 2:
      return scaled(Integer(sign()), integer(-1080, 1030));
    case 3:
      return scaled(Integer((1L << 53) + integer(-2, 2)) * sign(), integer(-1130, 980));
    case 4:
      return scaled(Integer(integer(1, 1L << 53)) * sign(), -1074 - integer(0, 20)); // subnormal and below
    case 5:
      return full_mantissa() * scaled(1, integer(1000, 1040)); // up to infinity and beyond
    case 6:
      return full_mantissa() * scaled(1, integer(-560, -500)); // products are subnormal
    case 7:
      return Rational(integer(-1000000, 1000000)) / (3 * integer(1, 1000000) + 1);
    default:
      return full_mantissa();
    }
  }

  /// A point in a third of the cases; any signs.
  Rational_interval interval()
  {
    const Rational a = trouble();
    if (chance(3)) return Rational_interval(a);
    const Rational b = chance(3) ? Rational(a * (1 + scaled(integer(-4, 4), -52))) : trouble();
    return {std::min(a, b), std::max(a, b)};
  }

private:
  int sign() { return chance(2) ? -1 : 1; }
  static Rational scaled(Integer mantissa, long exponent)
  {
    Rational result(mantissa);
    const auto shift = static_cast<mp_bitcnt_t>(std::labs(exponent));
    if (exponent < 0)
      mpq_div_2exp(result.get_mpq_t(), result.get_mpq_t(), shift);
    else
      mpq_mul_2exp(result.get_mpq_t(), result.get_mpq_t(), shift);
    return result;
  }

  std::mt19937_64 engine_;
};

} // namespace corral::test

#endif
