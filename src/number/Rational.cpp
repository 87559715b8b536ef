// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/errors.h>
#include <corral/number/Rational.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace corral {
namespace {

constexpr long greatest_decimal_exponent = 100000;
constexpr long greatest_binary_exponent = 400000;

/// The text between quotes, without what would spoil one line of an error message.
std::string quoted(std::string_view text)
{
  constexpr std::size_t longest = 60;
  std::string shown(text.substr(0, longest));
  std::replace_if(
      shown.begin(), shown.end(), [](unsigned char c) { return c < ' ' || c > '~'; }, '?');
  return '\'' + shown + (text.size() > longest ? "..." : "") + '\'';
}

bool is_digit(char c, int base)
{
  return (c >= '0' && c <= '9') || (base == 16 && ((c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F')));
}

/// value * base^exponent.
Rational scaled(const Integer& value, unsigned long base, long exponent)
{
  Integer power;
  mpz_ui_pow_ui(power.get_mpz_t(), base, static_cast<unsigned long>(std::labs(exponent)));
  if (exponent >= 0) return Rational(value * power);
  Rational result(value, power);
  result.canonicalize();
  return result;
}

/// Reads one number from left to right.
class Number_reader
{
public:
  explicit Number_reader(std::string_view text) : text_(text) {}

  Rational read()
  {
    const bool negative = accept_sign();
    const bool hexadecimal = at_ + 1 < text_.size() && text_[at_] == '0' && (text_[at_ + 1] | 0x20) == 'x';
    if (hexadecimal) at_ += 2;
    const Rational size = hexadecimal ? read_positional(16) : read_decimal_or_fraction();
    if (at_ != text_.size()) fail("the end of the number");
    return negative ? Rational(-size) : size;
  }

private:
  Rational read_decimal_or_fraction()
  {
    const std::size_t start = at_;
    const std::string numerator = digits(10);
    if (numerator.empty() || !accept('/')) {
      at_ = start;
      return read_positional(10);
    }
    const std::size_t denominator_start = at_;
    const Integer denominator = integer(digits(10), 10);
    if (denominator == 0) {
      at_ = denominator_start;
      fail("a denominator that is not zero");
    }
    Rational result(integer(numerator, 10), denominator);
    result.canonicalize();
    return result;
  }

  /// Digits with an optional point and exponent; the exponent of base 16 counts powers of two.
  Rational read_positional(int base)
  {
    std::string mantissa = digits(base);
    long shift = 0;
    if (accept('.')) {
      const std::string fraction = digits(base);
      mantissa += fraction;
      shift = -static_cast<long>(fraction.size());
    }
    const Integer value = integer(mantissa, base);
    const bool has_exponent = at_ < text_.size() && (text_[at_] | 0x20) == (base == 10 ? 'e' : 'p');
    if (base == 16) return scaled(value, 2, 4 * shift + (has_exponent ? exponent(greatest_binary_exponent) : 0));
    return scaled(value, 10, shift + (has_exponent ? exponent(greatest_decimal_exponent) : 0));
  }

  long exponent(long greatest)
  {
    ++at_; // the letter
    const std::size_t start = at_;
    const bool negative = accept_sign();
    const std::string size = digits(10);
    const std::size_t leading_zeros = std::min(size.find_first_not_of('0'), size.size());
    if (size.empty()) fail("a digit");
    const bool is_short = size.size() - leading_zeros <= 7;
    const long value = is_short ? std::strtol(size.c_str() + leading_zeros, nullptr, 10) : greatest + 1;
    if (value > greatest) {
      at_ = start;
      fail("an exponent from -" + std::to_string(greatest) + " to " + std::to_string(greatest));
    }
    return negative ? -value : value;
  }

  /// Whether there was a minus sign.
  bool accept_sign()
  {
    const bool negative = accept('-');
    if (!negative) accept('+');
    return negative;
  }

  bool accept(char c)
  {
    const bool found = at_ < text_.size() && text_[at_] == c;
    if (found) ++at_;
    return found;
  }

  std::string digits(int base)
  {
    const std::size_t start = at_;
    while (at_ < text_.size() && is_digit(text_[at_], base)) ++at_;
    return std::string(text_.substr(start, at_ - start));
  }

  Integer integer(const std::string& digits, int base)
  {
    if (digits.empty()) fail("a digit");
    return Integer(digits, base);
  }

  [[noreturn]] void fail(const std::string& expected) const
  {
    throw Parse_error(
        "number: given " + quoted(text_) + "; expected " + expected + " at column " + std::to_string(at_ + 1), at_);
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

Rational from_magnitude(unsigned long long magnitude)
{
  Rational result;
  mpz_import(result.get_num_mpz_t(), 1, 1, sizeof magnitude, 0, 0, &magnitude);
  return result;
}

} // namespace

Rational exact_value(double value)
{
  if (!std::isfinite(value))
    throw Invalid_input(std::string("rational: given ")
                        + (std::isnan(value) ? "nan"
                           : value < 0       ? "-inf"
                                             : "inf")
                        + "; expected a finite number");
  return Rational(value);
}

Rational exact_value(unsigned long long value) { return from_magnitude(value); }

Rational exact_value(long long value)
{
  if (value >= 0) return from_magnitude(static_cast<unsigned long long>(value));
  return -from_magnitude(0 - static_cast<unsigned long long>(value));
}

Rational parse_rational(std::string_view text) { return Number_reader(text).read(); }

std::string to_string(const Rational& value) { return value.get_str(); }

} // namespace corral
