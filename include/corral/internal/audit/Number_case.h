// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_INTERNAL_AUDIT_NUMBER_CASE_H
#define CORRAL_INTERNAL_AUDIT_NUMBER_CASE_H

#include <corral/audit/Number_audit.h>
#include <corral/audit/Trouble_source.h>
#include <corral/number/Interval_number.h>
#include <corral/number/Rational_interval.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace corral::detail {

/// \brief All operations on one pair of operands.
///
/// The operands of every operation are the intervals that `enclose` gave, and the arguments tried are their own exact
/// end points, zero, and numbers between, so that one missing rounding in one operation shows.
template <IntervalNumber I>
class Number_case
{
public:
  Number_case(std::uint64_t seed, std::uint64_t number) : number_(number), source_(seed * 0x9e3779b97f4a7c15U + number)
  {
    const Operand x = operand();
    const Operand y = source_.chance(20) ? x : operand();
    check_enclosure(x);
    check_end_points(x);
    check_hull(x, y);
    check_unary(x);
    check_binary(x, y);
    check_constructors();
  }

  /// How many exact values were looked for in a result.
  [[nodiscard]] std::uint64_t checks() const { return checks_; }
  /// The first wrong result.
  [[nodiscard]] const std::optional<Number_fault>& fault() const { return fault_; }

private:
  struct Operand
  {
    Rational_interval given;
    I interval;
    std::vector<Rational> values;
  };

  Operand operand()
  {
    Operand result{source_.interval(), {}, {}};
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
    check_intersection(x, y);
    for (const auto& value : x.values) {
      expect_value(hull_with_zero(x.interval), value, "hull_with_zero", x);
      expect_value(symmetric_hull(x.interval), -value, "symmetric_hull", x);
    }
  }

  void check_intersection(const Operand& x, const Operand& y)
  {
    auto low = greater(exact_lower(x.interval), exact_lower(y.interval));
    auto high = lesser(exact_upper(x.interval), exact_upper(y.interval));
    if (low && high && *low > *high) std::swap(low, high);
    const I common = intersection(x.interval, y.interval);
    expect(same(common, low, high), "intersection", x, &y, &common);
  }

  /// Built-in numbers, which must become the tightest intervals around them.
  void check_constructors()
  {
    const double number = std::ldexp(source_.full_mantissa().get_d(), static_cast<int>(source_.integer(-1074, 1020)));
    check_constructor(number);
    check_constructor(static_cast<float>(source_.integer(-(1L << 24), 1L << 24)));
    const long integer = source_.integer(std::numeric_limits<long>::min(), std::numeric_limits<long>::max());
    check_constructor(integer);
    check_constructor(static_cast<long long>(integer));
    check_constructor(static_cast<unsigned long>(integer));
    check_constructor(static_cast<unsigned long long>(integer));
    check_constructor(static_cast<int>(integer));
    check_constructor(static_cast<unsigned>(integer));
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const Rational beyond(Integer(1) << 1024);
    check_infinite(infinity, beyond);
    check_infinite(-infinity, -beyond);
    check_infinite(std::numeric_limits<double>::quiet_NaN(), std::nullopt);
  }

  template <MachineNumber T>
  void check_constructor(T value)
  {
    ++checks_;
    const Operand exactly{Rational_interval(value), enclose<I>(exact_value(value)), {}};
    const I made = value;
    expect(same(made, exact_lower(exactly.interval), exact_upper(exactly.interval)), "constructor", exactly, nullptr,
           &made);
  }

  /// An infinity stands for every number beyond the largest double, "not a number" for any; or both are refused.
  void check_infinite(double value, const std::optional<Rational>& stands_for)
  {
    ++checks_;
    try {
      const I made = value;
      const bool is_open = stands_for ? contains(made, *stands_for) : !exact_lower(made) && !exact_upper(made);
      expect(is_open && strict_sign(made) == (stands_for ? sgn(*stands_for) : 0),
             "constructor (infinite or not a number)", {}, nullptr, &made);
    } catch (const Invalid_input&) {
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

  static std::optional<Rational> greater(const std::optional<Rational>& a, const std::optional<Rational>& b)
  {
    return a && b ? std::max(*a, *b) : a ? a : b;
  }
  static std::optional<Rational> lesser(const std::optional<Rational>& a, const std::optional<Rational>& b)
  {
    return a && b ? std::min(*a, *b) : a ? a : b;
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
    if (holds || fault_) return;
    fault_ = Number_fault{number_, operation,
                          std::string(Interval_traits<I>::name) + ": wrong " + operation + "\n  x given = ["
                              + to_string(x.given.lower()) + ", " + to_string(x.given.upper())
                              + "]\n  x = " + text(x.interval)};
    if (y != nullptr) fault_->text += "\n  y = " + text(y->interval);
    if (result != nullptr) fault_->text += "\n  result = " + text(*result);
    if (value != nullptr) fault_->text += "\n  lost value = " + to_string(*value);
  }

  std::uint64_t number_;
  Trouble_source source_;
  std::uint64_t checks_ = 0;
  std::optional<Number_fault> fault_;
};

} // namespace corral::detail

#endif
