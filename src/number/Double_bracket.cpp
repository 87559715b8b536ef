// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/number/Double_bracket.h>

#include <cmath>
#include <limits>
#include <utility>

namespace corral {
namespace {

using Limits = std::numeric_limits<double>;
constexpr long least_unit = Limits::min_exponent - Limits::digits;    // exponent of the smallest subnormal
constexpr long greatest_unit = Limits::max_exponent - Limits::digits; // exponent of the last bit of the largest double

long bits(const Integer& value) { return static_cast<long>(mpz_sizeinbase(value.get_mpz_t(), 2)); }

/// value / 2^unit = quotient + rest / divisor.
struct Scaled_quotient
{
  Integer quotient;
  Integer rest;
  Integer divisor;
};

Scaled_quotient divide(const Rational& value, long unit)
{
  Integer dividend = value.get_num();
  Scaled_quotient result{{}, {}, value.get_den()};
  if (unit > 0)
    result.divisor <<= static_cast<mp_bitcnt_t>(unit);
  else
    dividend <<= static_cast<mp_bitcnt_t>(-unit);
  mpz_fdiv_qr(result.quotient.get_mpz_t(), result.rest.get_mpz_t(), dividend.get_mpz_t(), result.divisor.get_mpz_t());
  return result;
}

/// \pre 0 <= mantissa <= 2^53. The rounding mode plays no part: what is not exact is infinite.
double scaled(const Integer& mantissa, long unit)
{
  if (unit == greatest_unit && bits(mantissa) > Limits::digits) return Limits::infinity();
  return std::ldexp(mantissa.get_d(), static_cast<int>(unit));
}

Double_bracket bracket_of_positive(const Rational& value)
{
  const long exponent = bits(value.get_num()) - bits(value.get_den()); // 2^(exponent-1) < value < 2^(exponent+1)
  if (exponent > Limits::max_exponent) return {Limits::max(), Limits::infinity(), Limits::infinity()};
  if (exponent < least_unit - 1) return {0, 0, Limits::denorm_min()};
  long unit = std::max(exponent + 1 - Limits::digits, least_unit);
  auto scale = divide(value, unit);
  if (bits(scale.quotient) < Limits::digits && unit > least_unit) scale = divide(value, --unit);
  if (unit > greatest_unit) return {Limits::max(), Limits::infinity(), Limits::infinity()};
  const double below = scaled(scale.quotient, unit);
  if (sgn(scale.rest) == 0) return {below, below, below};
  const double above = scaled(scale.quotient + 1, unit);
  const int half = cmp(2 * scale.rest, scale.divisor);
  const bool upward = half > 0 || (half == 0 && mpz_odd_p(scale.quotient.get_mpz_t()) != 0);
  return {below, upward ? above : below, above};
}

} // namespace

Double_bracket bracket(const Rational& value)
{
  if (sgn(value) == 0) return {};
  if (sgn(value) > 0) return bracket_of_positive(value);
  const auto mirrored = bracket_of_positive(-value);
  return {-mirrored.above, -mirrored.nearest, -mirrored.below};
}

} // namespace corral
