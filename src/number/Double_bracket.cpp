// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/errors.h>
#include <corral/number/Double_bracket.h>

#include <cmath>
#include <limits>
#include <string>
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

Double_bracket bracket(const Integer& mantissa, long exponent)
{
  if (sgn(mantissa) == 0) return {};
  const long length = bits(mantissa);
  const long unit = exponent + std::max(0L, length - Limits::digits);
  if (unit <= least_unit || unit >= greatest_unit) { // the ends of the range
    const bool positive = sgn(mantissa) > 0;
    if (length + exponent < least_unit)
      return positive ? Double_bracket{0, 0, Limits::denorm_min()} : Double_bracket{-Limits::denorm_min(), 0, 0};
    if (length + exponent > Limits::max_exponent) return bracket(positive ? Limits::infinity() : -Limits::infinity());
    const Rational value(mantissa);
    return bracket(exponent < 0 ? Rational(value >> static_cast<mp_bitcnt_t>(-exponent))
                                : Rational(value << static_cast<mp_bitcnt_t>(exponent)));
  }
  const auto dropped = static_cast<mp_bitcnt_t>(unit - exponent);
  Integer floor;
  mpz_fdiv_q_2exp(floor.get_mpz_t(), mantissa.get_mpz_t(), dropped);
  const double below = std::ldexp(floor.get_d(), static_cast<int>(unit));
  const mp_bitcnt_t lowest = mpz_scan1(mantissa.get_mpz_t(), 0);
  if (lowest >= dropped) return {below, below, below};
  const double above = std::ldexp(floor.get_d() + 1, static_cast<int>(unit));
  const bool is_tie = lowest + 1 == dropped;
  const bool upward =
      mpz_tstbit(mantissa.get_mpz_t(), dropped - 1) != 0 && (!is_tie || mpz_odd_p(floor.get_mpz_t()) != 0);
  return {below, upward ? above : below, above};
}

void detail::refuse_order(std::string_view who, double lower, double upper)
{
  throw Invalid_input(std::string(who) + ": given the end points " + std::to_string(lower) + " and "
                      + std::to_string(upper) + "; expected lower <= upper");
}

} // namespace corral
