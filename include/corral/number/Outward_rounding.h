// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_NUMBER_OUTWARD_ROUNDING_H
#define CORRAL_NUMBER_OUTWARD_ROUNDING_H

#include <corral/number/Double_bracket.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>

namespace corral {

/// \brief Directed rounding of doubles without a rounding mode.
///
/// Each operation rounds to nearest, computes its own rounding error exactly (TwoSum, TwoProduct) and steps to the
/// neighbouring double where the error has the wrong sign. The result is the correctly rounded one, overflow and
/// subnormals included: what is exact stays exact. Proof: doc/number_types.md.
/// \par Reference  Dekker 1971, Knuth 1998 (TwoSum, TwoProduct); Boldo, Graillat, Muller 2017 (TwoSum and overflow).
struct Outward_rounding
{
  static constexpr std::string_view name = "double_outward";
  static constexpr bool is_guaranteed = true;

  /// The smallest double >= a + b. \pre Neither operand is -infinity, as no upper end of a `Double_interval` is.
  static double add_up(double a, double b)
  {
    const double sum = a + b;
    const double a_part = sum - b;
    const double b_part = sum - a_part;
    const double error = (a - a_part) + (b - b_part);
    return step_up_unless(error <= 0, sum);
  }
  static double add_down(double a, double b) { return -add_up(-a, -b); }

  /// The smallest double >= a * b, where 0 times infinity is 0.
  static double multiply_up(double a, double b)
  {
    const double product = a * b;
    if (std::fabs(a) < 0x1p500 && std::fabs(b) < 0x1p500 && std::fabs(product) > 0x1p-900)
      return step_up_unless(product_error(a, b, product) <= 0, product);
    return multiply_up_scaled(a, b);
  }
  static double multiply_down(double a, double b) { return -multiply_up(-a, b); }

  static double lower_of(const Double_bracket& doubles) { return doubles.below; }
  static double upper_of(const Double_bracket& doubles) { return doubles.above; }

private:
  /// \brief x, or the next double above it where `is_upper_bound` is false; infinity stays and -infinity becomes
  /// finite. \pre x is not -0 if the step is taken.
  static double step_up_unless(bool is_upper_bound, double x)
  {
    const auto bits = std::bit_cast<std::int64_t>(x);
    const std::int64_t away_or_toward_zero = (bits >> 63) | 1;
    const auto steps = static_cast<std::int64_t>(!is_upper_bound & (x < std::numeric_limits<double>::infinity()));
    return std::bit_cast<double>(bits + (away_or_toward_zero & -steps)); // no branch: its outcome is a coin toss
  }

  /// a * b - product, exactly. \pre no operation leaves the range of normal doubles.
  static double product_error(double a, double b, double product)
  {
#ifdef __FMA__ // an implementation of the same function, where the processor has one instruction for it
    return std::fma(a, b, -product);
#else
    const double a_high = upper_half(a);
    const double b_high = upper_half(b);
    const double a_low = a - a_high;
    const double b_low = b - b_high;
    return a_low * b_low - (((product - a_high * b_high) - a_low * b_high) - a_high * b_low);
#endif
  }

  /// The upper 26 bits of x (Veltkamp).
  static double upper_half(double x)
  {
    const double shifted = 0x8000001p0 * x;
    return shifted - (shifted - x);
  }

  /// `multiply_up` where an operand or the product is zero, infinite, or close to the ends of the range.
  static double multiply_up_scaled(double a, double b);
};

} // namespace corral

#endif
