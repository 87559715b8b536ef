// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_AUDIT_TROUBLE_SOURCE_H
#define CORRAL_AUDIT_TROUBLE_SOURCE_H

#include <corral/number/Rational.h>
#include <corral/number/Rational_interval.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <random>

namespace corral {

/// \brief Random exact data biased to where rounding goes wrong. The same seed gives the same data on every platform.
class Trouble_source
{
public:
  explicit Trouble_source(std::uint64_t seed) : engine_(seed) {}

  /// Every number of [low, high] about as often. \pre low <= high.
  long integer(long low, long high)
  {
    const auto count = static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low) + 1;
    const std::uint64_t drawn = engine_();
    return static_cast<long>(static_cast<std::uint64_t>(low) + (count == 0 ? drawn : drawn % count));
  }
  bool chance(int one_in) { return integer(1, one_in) == 1; }

  /// A number whose mantissa fills a double, of a magnitude around 1 and of any sign.
  Rational full_mantissa() { return signed_number(1L << 52, (1L << 53) - 1, integer(-56, -48)); }

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
      return power_of_two(integer(-1080, 1030));
    case 3:
      return signed_number((1L << 53) - 2, (1L << 53) + 2, integer(-1130, 980));
    case 4: // subnormal and below
      return signed_number(1, 1L << 53, -1074 - integer(0, 20));
    case 5: // up to infinity and beyond
      return full_mantissa(integer(1000, 1040));
    case 6: // products are subnormal
      return full_mantissa(integer(-560, -500));
    case 7:
      return fraction();
    default:
      return full_mantissa();
    }
  }

  /// A fraction of a magnitude up to 10^5 that no binary number equals, as a rule.
  Rational fraction()
  {
    const long denominator = 3 * integer(1, 1000000) + 1;
    Rational result(integer(-1000000, 1000000), denominator);
    result.canonicalize();
    return result;
  }

  /// A point in a third of the cases; any signs.
  Rational_interval interval()
  {
    const Rational a = trouble();
    if (chance(3)) return Rational_interval(a);
    const Rational b = chance(3) ? Rational(a * (1 + scaled(integer(-4, 4), -52))) : trouble();
    return {std::min(a, b), std::max(a, b)};
  }

  /// mantissa * 2^exponent.
  [[nodiscard]] static Rational scaled(const Integer& mantissa, long exponent)
  {
    Rational result(mantissa);
    const auto shift = static_cast<mp_bitcnt_t>(std::labs(exponent));
    if (exponent < 0)
      mpq_div_2exp(result.get_mpq_t(), result.get_mpq_t(), shift);
    else
      mpq_mul_2exp(result.get_mpq_t(), result.get_mpq_t(), shift);
    return result;
  }

private:
  // At most one argument of a call draws: compilers differ in which they compute first.

  int sign() { return chance(2) ? -1 : 1; }
  Rational power_of_two(long exponent) { return scaled(Integer(sign()), exponent); }
  Rational full_mantissa(long exponent) { return full_mantissa() * scaled(1, exponent); }
  Rational signed_number(long least_mantissa, long greatest_mantissa, long exponent)
  {
    const int sign_drawn = sign();
    return scaled(Integer(integer(least_mantissa, greatest_mantissa)) * sign_drawn, exponent);
  }

  std::mt19937_64 engine_;
};

} // namespace corral

#endif
