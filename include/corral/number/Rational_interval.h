// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_NUMBER_RATIONAL_INTERVAL_H
#define CORRAL_NUMBER_RATIONAL_INTERVAL_H

#include <corral/number/Interval_number.h>

#include <algorithm>
#include <utility>

namespace corral {

/// \brief Model of `IntervalNumber` with exact rational end points: no rounding at all, so that a
/// bound over it is the method's own answer.
class Rational_interval
{
public:
  Rational_interval() = default;
  template <UnfitNumber T>
  Rational_interval(T value) = delete;
  /// A built-in number. \throw Invalid_input if it is infinite or not a number.
  template <MachineNumber T>
  Rational_interval(T value) : lower_(exact_value(value)), upper_(lower_)
  {}
  explicit Rational_interval(const Rational& value) : lower_(value), upper_(value) {}
  /// \throw Invalid_input unless lower <= upper.
  Rational_interval(Rational lower, Rational upper) : lower_(std::move(lower)), upper_(std::move(upper))
  {
    if (lower_ > upper_) refuse_order();
  }
  /// \throw Invalid_input unless lower <= upper, and if a built-in number is infinite or not a number.
  template <MachineNumber L, MachineNumber U>
  Rational_interval(L lower, U upper) : Rational_interval(exact_value(lower), exact_value(upper))
  {}
  template <MachineNumber L>
  Rational_interval(L lower, Rational upper) : Rational_interval(exact_value(lower), std::move(upper))
  {}
  template <MachineNumber U>
  Rational_interval(Rational lower, U upper) : Rational_interval(std::move(lower), exact_value(upper))
  {}

  /// \brief The interval of these two ends as they are. Nothing is checked: for who has just computed them.
  static Rational_interval from_ends(Rational lower, Rational upper)
  {
    Rational_interval result;
    result.lower_ = std::move(lower);
    result.upper_ = std::move(upper);
    return result;
  }

  [[nodiscard]] const Rational& lower() const { return lower_; }
  [[nodiscard]] const Rational& upper() const { return upper_; }

  Rational_interval& operator+=(const Rational_interval& b)
  {
    lower_ += b.lower_;
    upper_ += b.upper_;
    return *this;
  }
  Rational_interval& operator-=(const Rational_interval& b) { return *this += -b; }
  Rational_interval& operator*=(const Rational_interval& b) { return *this = *this * b; }

  friend Rational_interval operator-(const Rational_interval& a) { return from_ends(-a.upper_, -a.lower_); }
  friend Rational_interval operator+(Rational_interval a, const Rational_interval& b) { return a += b; }
  friend Rational_interval operator-(Rational_interval a, const Rational_interval& b) { return a -= b; }
  friend Rational_interval operator*(const Rational_interval& a, const Rational_interval& b)
  {
    if (a.is_point()) return b.scaled(a.lower_);
    if (b.is_point()) return a.scaled(b.lower_);
    const Rational products[] = {a.lower_ * b.lower_, a.lower_ * b.upper_, a.upper_ * b.lower_, a.upper_ * b.upper_};
    const auto [low, high] = std::minmax_element(std::begin(products), std::end(products));
    return from_ends(*low, *high);
  }
  friend Rational_interval square(const Rational_interval& a)
  {
    Rational low = a.lower_ * a.lower_;
    Rational high = a.upper_ * a.upper_;
    if (low > high) std::swap(low, high);
    return from_ends(sgn(a.lower_) * sgn(a.upper_) <= 0 ? Rational() : std::move(low), std::move(high));
  }

private:
  [[noreturn]] void refuse_order() const
  {
    throw Invalid_input("rational: given the end points " + to_string(lower_) + " and " + to_string(upper_)
                        + "; expected lower <= upper");
  }
  [[nodiscard]] bool is_point() const { return lower_ == upper_; }
  [[nodiscard]] Rational_interval scaled(const Rational& factor) const
  {
    Rational low = lower_ * factor;
    Rational high = is_point() ? low : Rational(upper_ * factor);
    if (sgn(factor) < 0) std::swap(low, high);
    return from_ends(std::move(low), std::move(high));
  }

  Rational lower_;
  Rational upper_;
};

template <>
struct Interval_traits<Rational_interval>
{
  static constexpr std::string_view name = "rational";
  static constexpr bool is_guaranteed = true;
  static constexpr bool is_exact = true;
  struct Scope
  {
    Scope() {} // user-provided, so that an unused guard draws no warning
  };
  static Rational_interval enclose(const Rational& value) { return Rational_interval(value); }
  static Rational_interval hull(const Rational_interval& a, const Rational_interval& b)
  {
    return Rational_interval::from_ends(std::min(a.lower(), b.lower()), std::max(a.upper(), b.upper()));
  }
  static bool is_number(const Rational_interval&) { return true; }
  static Rational_interval intersection(const Rational_interval& a, const Rational_interval& b)
  {
    const auto [low, high] = std::minmax({std::max(a.lower(), b.lower()), std::min(a.upper(), b.upper())});
    return Rational_interval::from_ends(low, high);
  }
  static Rational_interval lower(const Rational_interval& x) { return Rational_interval(x.lower()); }
  static Rational_interval upper(const Rational_interval& x) { return Rational_interval(x.upper()); }
  static std::optional<Rational> exact_lower(const Rational_interval& x) { return x.lower(); }
  static std::optional<Rational> exact_upper(const Rational_interval& x) { return x.upper(); }
  static int lower_sign(const Rational_interval& x) { return sgn(x.lower()); }
  static int upper_sign(const Rational_interval& x) { return sgn(x.upper()); }
};

} // namespace corral

#endif
