// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/errors.h>
#include <corral/number/format.h>

#include <cmath>
#include <cstdlib>

namespace corral {
namespace {

long bits(const Integer& value) { return static_cast<long>(mpz_sizeinbase(value.get_mpz_t(), 2)); }

Integer power_of_ten(long exponent)
{
  Integer result;
  mpz_ui_pow_ui(result.get_mpz_t(), 10, static_cast<unsigned long>(exponent));
  return result;
}

Rational times_power_of_ten(const Rational& value, long exponent)
{
  return exponent >= 0 ? Rational(value * power_of_ten(exponent)) : Rational(value / power_of_ten(-exponent));
}

/// The e with 10^e <= value < 10^(e+1). \pre value > 0.
long decimal_exponent(const Rational& value)
{
  const auto guess = static_cast<double>(bits(value.get_num()) - bits(value.get_den())) * std::log10(2.0);
  auto exponent = static_cast<long>(std::floor(guess));
  while (times_power_of_ten(value, -exponent) >= 10) ++exponent;
  while (times_power_of_ten(value, -exponent) < 1) --exponent;
  return exponent;
}

/// `digits`, of which the first stands for 10^exponent: without an exponent where that is short.
std::string with_point(std::string digits, long exponent)
{
  const auto least = digits.find_last_not_of('0') + 1;
  const bool plain = exponent >= -5 && exponent < 21;
  if (plain && exponent < 0)
    return "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + digits.substr(0, least);
  const std::size_t whole = plain ? static_cast<std::size_t>(exponent) + 1 : 1;
  digits.resize(std::max(whole, least), '0');
  if (digits.size() > whole) digits.insert(whole, 1, '.');
  return plain ? digits : digits + 'e' + std::to_string(exponent);
}

/// \pre value > 0.
std::string decimal_of_positive(const Rational& value, int digits, bool upward)
{
  const long exponent = decimal_exponent(value);
  const Rational scaled = times_power_of_ten(value, digits - 1 - exponent);
  Integer mantissa;
  const auto divide = upward ? mpz_cdiv_q : mpz_fdiv_q;
  divide(mantissa.get_mpz_t(), scaled.get_num_mpz_t(), scaled.get_den_mpz_t());
  const std::string text = mantissa.get_str();
  return with_point(text, exponent + static_cast<long>(text.size()) - digits);
}

std::string decimal(const Rational& value, int digits, bool upward)
{
  if (digits < 1) throw Invalid_input("decimal: given " + std::to_string(digits) + " digits; expected at least 1");
  if (sgn(value) == 0) return "0";
  if (sgn(value) > 0) return decimal_of_positive(value, digits, upward);
  return std::string("-").append(decimal_of_positive(-value, digits, !upward));
}

} // namespace

std::string to_hex_float(const Rational& value)
{
  if (mpz_popcount(value.get_den_mpz_t()) != 1)
    throw Invalid_input("to_hex_float: given " + to_string(value) + "; expected a denominator that is a power of two");
  if (sgn(value) == 0) return "0x0p+0";
  Integer mantissa = abs(value.get_num());
  const long exponent = bits(mantissa) - bits(value.get_den());
  mantissa <<= static_cast<mp_bitcnt_t>((4 - (bits(mantissa) - 1) % 4) % 4); // the first digit is 1
  std::string digits = mantissa.get_str(16);
  digits.resize(digits.find_last_not_of('0') + 1);
  if (digits.size() > 1) digits.insert(1, 1, '.');
  return std::string(sgn(value) < 0 ? "-0x" : "0x").append(digits) + (exponent < 0 ? "p" : "p+")
         + std::to_string(exponent);
}

std::string decimal_below(const Rational& value, int digits) { return decimal(value, digits, false); }
std::string decimal_above(const Rational& value, int digits) { return decimal(value, digits, true); }

} // namespace corral
