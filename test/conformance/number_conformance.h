// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_TEST_CONFORMANCE_NUMBER_CONFORMANCE_H
#define CORRAL_TEST_CONFORMANCE_NUMBER_CONFORMANCE_H

#include "conformance/Random.h"

#include <corral/number/Interval_number.h>
#include <corral/number/Rational_interval.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace corral::test {

/// \brief The contract of `IntervalNumber`, checked with exact rationals: there is no tolerance, a miss is a bug.
///
/// The operands of every operation are the intervals that `enclose` gave, and the arguments tried are their own exact
/// end points, zero, and numbers between, so that one missing rounding in one operation shows.
template <IntervalNumber I>
class Number_conformance
{
public:
  explicit Number_conformance(std::uint64_t seed) : random_(seed) {}

  /// The first counterexample with all its inputs, or "" if none was found.
  std::string find_fault(int rounds)
  {
    const Arithmetic_scope<I> scope;
    for (int round = 0; round < rounds && fault_.empty(); ++round) {
      const Operand x = operand();
      const Operand y = chance_of_dependence() ? x : operand();
      check_enclosure(x);
      check_end_points(x);
      check_hull(x, y);
      check_unary(x);
      check_binary(x, y);
    }
    return fault_;
  }

  /// How many exact values were looked for in a result so far.
  [[nodiscard]] std::uint64_t checks() const { return checks_; }

private:
  struct Operand
  {
    Rational_interval given;
    I interval;
    std::vector<Rational> values;
  };

  bool chance_of_dependence() { return random_.chance(20); }

  Operand operand()
  {
    Operand result{random_.interval(), {}, {}};
    result.interval = enclose<I>(result.given.lower(), result.given.upper());
    const Rational beyond = Rational(Integer(1) << 1100);
    const Rational low = exact_lower(result.interval).value_or(Rational(result.given.lower() - beyond));
    const Rational high = exact_upper(result.interval).value_or(Rational(result.given.upper() + beyond));
    result.values = {low, high, (low + 2 * high) / 3};
    if (sgn(low) < 0 && sgn(high) > 0) result.values.emplace_back(0);
    return result;
  }

  void check_enclosure(const Operand& x)
  {
    expect(contains(x.interval, x.given.lower()) && contains(x.interval, x.given.upper()), "enclose", x);
    for (const auto& end : {exact_lower(x.interval), exact_upper(x.interval)})
      if (end) expect(same(enclose<I>(*end), end, end), "enclose (a number that the type represents is a point)", x);
  }

  void check_end_points(const Operand& x)
  {
    const auto low = exact_lower(x.interval);
    const auto high = exact_upper(x.interval);
    expect(!low || !high || *low <= *high, "order of the end points", x);
    if (low) expect(same(lower(x.interval), low, low), "lower", x);
    if (high) expect(same(upper(x.interval), high, high), "upper", x);
    expect(Interval_traits<I>::lower_sign(x.interval) == (low ? sgn(*low) : -1), "lower_sign", x);
    expect(Interval_traits<I>::upper_sign(x.interval) == (high ? sgn(*high) : 1), "upper_sign", x);
    const int sign = low && sgn(*low) > 0 ? 1 : high && sgn(*high) < 0 ? -1 : 0;
    expect(strict_sign(x.interval) == sign && contains_zero(x.interval) == (sign == 0), "strict_sign", x);
  }

  /// An end point that is no number must not pass for a finite one nor for an infinity of the wrong sign.
  void check_form(const I& result, const char* operation, const Operand& x, const Operand* y = nullptr)
  {
    const auto low = exact_lower(result);
    const auto high = exact_upper(result);
    const int low_sign = Interval_traits<I>::lower_sign(result);
    const int high_sign = Interval_traits<I>::upper_sign(result);
    expect(low_sign == (low ? sgn(*low) : -1) && high_sign == (high ? sgn(*high) : 1)
               && (!low || !high || *low <= *high),
           operation, x, y, &result);
  }

  void check_hull(const Operand& x, const Operand& y)
  {
    const auto low = both(exact_lower(x.interval), exact_lower(y.interval));
    const auto high = both(exact_upper(x.interval), exact_upper(y.interval));
    const I joined = hull(x.interval, y.interval);
    expect(same(joined, low ? std::optional(std::min(low->first, low->second)) : std::nullopt,
                high ? std::optional(std::max(high->first, high->second)) : std::nullopt),
           "hull", x, &y, &joined);
    for (const auto& value : x.values) {
      expect_value(hull_with_zero(x.interval), value, "hull_with_zero", x);
      expect_value(symmetric_hull(x.interval), -value, "symmetric_hull", x);
    }
  }

  void check_unary(const Operand& x)
  {
    const auto low = exact_lower(x.interval);
    const auto high = exact_upper(x.interval);
    const I negated = -x.interval;
    expect(same(negated, high ? std::optional<Rational>(-*high) : std::nullopt,
                low ? std::optional<Rational>(-*low) : std::nullopt),
           "negation", x, nullptr, &negated);
    const I squared = square(x.interval);
    const I cubed = power(x.interval, 3);
    const I fourth = power(x.interval, 4);
    expect(Interval_traits<I>::lower_sign(squared) >= 0, "sign of square", x, nullptr, &squared);
    check_form(squared, "form of square", x);
    check_form(cubed, "form of power 3", x);
    for (const auto& value : x.values) {
      expect_value(squared, value * value, "square", x);
      expect_value(cubed, value * value * value, "power 3", x);
      expect_value(fourth, value * value * value * value, "power 4", x);
    }
    if constexpr (is_exact<I>) expect_equal(squared, square(exactly(x.interval)), "square", x);
  }

  void check_binary(const Operand& x, const Operand& y)
  {
    const I sum = x.interval + y.interval;
    const I difference = x.interval - y.interval;
    const I product = x.interval * y.interval;
    check_form(sum, "form of sum", x, &y);
    check_form(difference, "form of difference", x, &y);
    check_form(product, "form of product", x, &y);
    for (const auto& a : x.values)
      for (const auto& b : y.values) {
        expect_value(sum, a + b, "sum", x, &y);
        expect_value(difference, a - b, "difference", x, &y);
        expect_value(product, a * b, "product", x, &y);
      }
    check_assignments(x, y, {sum, difference, product});
    if constexpr (is_exact<I>) {
      expect_equal(sum, exactly(x.interval) + exactly(y.interval), "sum", x, &y);
      expect_equal(difference, exactly(x.interval) - exactly(y.interval), "difference", x, &y);
      expect_equal(product, exactly(x.interval) * exactly(y.interval), "product", x, &y);
    }
  }

  void check_assignments(const Operand& x, const Operand& y, const std::array<I, 3>& results)
  {
    std::array<I, 3> assigned{x.interval, x.interval, x.interval};
    assigned[0] += y.interval;
    assigned[1] -= y.interval;
    assigned[2] *= y.interval;
    for (std::size_t i = 0; i < 3; ++i)
      expect(same(assigned[i], exact_lower(results[i]), exact_upper(results[i])), "assignment", x, &y, &assigned[i]);
    I own = x.interval;
    own *= own; // an operation may read what it overwrites
    for (const auto& value : x.values) expect_value(own, value * value, "x *= x", x);
  }

  static std::optional<std::pair<Rational, Rational>> both(const std::optional<Rational>& a,
                                                           const std::optional<Rational>& b)
  {
    return a && b ? std::optional(std::pair(*a, *b)) : std::nullopt;
  }

  static bool same(const I& x, const std::optional<Rational>& low, const std::optional<Rational>& high)
  {
    return exact_lower(x) == low && exact_upper(x) == high;
  }

  static Rational_interval exactly(const I& x) { return {exact_lower(x).value(), exact_upper(x).value()}; }

  static std::string text(const I& x)
  {
    const auto low = exact_lower(x);
    const auto high = exact_upper(x);
    return std::string("[") + (low ? to_string(*low) : "-inf") + ", " + (high ? to_string(*high) : "inf") + "]";
  }

  void expect_value(const I& result, const Rational& value, const char* operation, const Operand& x,
                    const Operand* y = nullptr)
  {
    ++checks_;
    expect(contains(result, value), operation, x, y, &result, &value);
  }

  void expect_equal(const I& result, const Rational_interval& exact, const char* operation, const Operand& x,
                    const Operand* y = nullptr)
  {
    expect(same(result, exact.lower(), exact.upper()), operation, x, y, &result);
  }

  void expect(bool holds, const char* operation, const Operand& x, const Operand* y = nullptr,
              const I* result = nullptr, const Rational* value = nullptr)
  {
    if (holds || !fault_.empty()) return;
    fault_ = std::string(Interval_traits<I>::name) + ": wrong " + operation + "\n  x given = ["
             + to_string(x.given.lower()) + ", " + to_string(x.given.upper()) + "]\n  x = " + text(x.interval);
    if (y != nullptr) fault_ += "\n  y = " + text(y->interval);
    if (result != nullptr) fault_ += "\n  result = " + text(*result);
    if (value != nullptr) fault_ += "\n  lost value = " + to_string(*value);
  }

  Random random_;
  std::uint64_t checks_ = 0;
  std::string fault_;
};

/// The first counterexample to the contract of `IntervalNumber`, or "" if none was found.
template <IntervalNumber I>
std::string find_number_fault(std::uint64_t seed, int number_of_rounds = rounds(1000))
{
  return Number_conformance<I>(seed).find_fault(number_of_rounds);
}

} // namespace corral::test

#endif
