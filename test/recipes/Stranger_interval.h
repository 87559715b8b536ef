// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_NUMBER_STRANGER_INTERVAL_H
#define CORRAL_NUMBER_STRANGER_INTERVAL_H

#include <corral/number/Interval_number.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

namespace corral {

/// A number type as somebody writes it who knows the contract alone: fractions, by the definition of each operation.
class Stranger_interval
{
public:
  Stranger_interval() = default;
  template <UnfitNumber T>
  Stranger_interval(T value) = delete;
  template <MachineNumber T>
  Stranger_interval(T value) : low_(exact_value(value)), high_(low_)
  {}
  Stranger_interval(std::pair<Rational, Rational> ends) : low_(std::move(ends.first)), high_(std::move(ends.second)) {}

  [[nodiscard]] const Rational& low() const { return low_; }
  [[nodiscard]] const Rational& high() const { return high_; }

  Stranger_interval& operator+=(const Stranger_interval& b) { return *this = *this + b; }
  Stranger_interval& operator-=(const Stranger_interval& b) { return *this = *this - b; }
  Stranger_interval& operator*=(const Stranger_interval& b) { return *this = *this * b; }
  friend Stranger_interval operator-(const Stranger_interval& a) { return {{-a.high_, -a.low_}}; }
  friend Stranger_interval operator+(const Stranger_interval& a, const Stranger_interval& b)
  {
    return {{a.low_ + b.low_, a.high_ + b.high_}};
  }
  friend Stranger_interval operator-(const Stranger_interval& a, const Stranger_interval& b) { return a + -b; }
  friend Stranger_interval operator*(const Stranger_interval& a, const Stranger_interval& b)
  {
    const std::array<Rational, 4> corners = {a.low_ * b.low_, a.low_ * b.high_, a.high_ * b.low_, a.high_ * b.high_};
    const auto [least, greatest] = std::minmax_element(corners.begin(), corners.end());
    return {{*least, *greatest}};
  }
  friend Stranger_interval square(const Stranger_interval& a)
  {
    const Stranger_interval product = a * a;
    return {{sgn(a.low_) < 0 && sgn(a.high_) > 0 ? Rational() : product.low_, product.high_}};
  }

private:
  Rational low_;
  Rational high_;
};

template <>
struct Interval_traits<Stranger_interval>
{
  using I = Stranger_interval;
  static constexpr std::string_view name = "stranger";
  static constexpr bool is_guaranteed = true;
  static constexpr bool is_exact = true;
  struct Scope
  {
    Scope() {}
  };
  static I enclose(const Rational& value) { return {{value, value}}; }
  static bool is_number(const I&) { return true; }
  static I hull(const I& a, const I& b) { return {{std::min(a.low(), b.low()), std::max(a.high(), b.high())}}; }
  static I intersection(const I& a, const I& b)
  {
    return {std::minmax({std::max(a.low(), b.low()), std::min(a.high(), b.high())})};
  }
  static I lower(const I& x) { return {{x.low(), x.low()}}; }
  static I upper(const I& x) { return {{x.high(), x.high()}}; }
  static std::optional<Rational> exact_lower(const I& x) { return x.low(); }
  static std::optional<Rational> exact_upper(const I& x) { return x.high(); }
  static int lower_sign(const I& x) { return sgn(x.low()); }
  static int upper_sign(const I& x) { return sgn(x.high()); }
};

} // namespace corral

#endif
