// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_NUMBER_DOUBLE_INTERVAL_H
#define CORRAL_NUMBER_DOUBLE_INTERVAL_H

#include <corral/number/Double_bracket.h>
#include <corral/number/Environment.h>
#include <corral/number/Interval_number.h>

#include <algorithm>
#include <cmath>

namespace corral {

/// \brief An interval of doubles, infinite end points allowed; model of `IntervalNumber`.
///
/// \tparam Rounding  all the rounding of the type, in one place: `add_down`, `add_up`, `multiply_down`, `multiply_up`
///         of two doubles, `lower_of` and `upper_of` a `Double_bracket`, `name` and `is_guaranteed`.
template <class Rounding>
class Double_interval
{
public:
  Double_interval() = default;
  template <UnfitNumber T>
  Double_interval(T value) = delete;
  /// The tightest interval around a built-in number.
  template <MachineNumber T>
  Double_interval(T value) : Double_interval(bracket(value))
  {}
  /// The tightest interval around both. \throw Invalid_input unless lower <= upper.
  template <MachineNumber L, MachineNumber U>
  Double_interval(L lower, U upper)
      : lower_(Rounding::lower_of(bracket(lower))), upper_(Rounding::upper_of(bracket(upper)))
  {
    if (!(lower_ <= upper_)) detail::refuse_order(Rounding::name, lower_, upper_);
  }
  explicit Double_interval(const Double_bracket& doubles)
      : lower_(Rounding::lower_of(doubles)), upper_(Rounding::upper_of(doubles))
  {}

  /// \brief The interval of these two doubles as they are. Nothing is checked: for who has just computed them.
  static Double_interval from_ends(double lower, double upper)
  {
    Double_interval result;
    result.lower_ = lower;
    result.upper_ = upper;
    return result;
  }

  [[nodiscard]] double lower() const { return lower_; }
  [[nodiscard]] double upper() const { return upper_; }

  Double_interval& operator+=(const Double_interval& b) { return *this = *this + b; }
  Double_interval& operator-=(const Double_interval& b) { return *this = *this - b; }
  Double_interval& operator*=(const Double_interval& b) { return *this = *this * b; }

  friend Double_interval operator-(const Double_interval& a) { return from_ends(-a.upper_, -a.lower_); }
  friend Double_interval operator+(const Double_interval& a, const Double_interval& b)
  {
    check_environment();
    return from_ends(Rounding::add_down(a.lower_, b.lower_), Rounding::add_up(a.upper_, b.upper_));
  }
  friend Double_interval operator-(const Double_interval& a, const Double_interval& b) { return a + -b; }
  friend Double_interval operator*(const Double_interval& a, const Double_interval& b)
  {
    check_environment();
    if (a.lower_ >= 0) return multiply_by_positive(b, a);
    if (a.upper_ <= 0) return multiply_by_positive(-b, -a);
    if (b.lower_ >= 0) return multiply_by_positive(a, b);
    if (b.upper_ <= 0) return multiply_by_positive(-a, -b);
    return from_ends(std::min(Rounding::multiply_down(a.lower_, b.upper_), Rounding::multiply_down(a.upper_, b.lower_)),
                     std::max(Rounding::multiply_up(a.lower_, b.lower_), Rounding::multiply_up(a.upper_, b.upper_)));
  }
  friend Double_interval square(const Double_interval& a)
  {
    check_environment();
    const double low = std::fabs(a.lower_);
    const double high = std::fabs(a.upper_);
    const double largest = std::max(low, high);
    const bool mixed = a.lower_ < 0 && a.upper_ > 0;
    const double smallest = mixed ? 0 : std::min(low, high);
    return from_ends(Rounding::multiply_down(smallest, smallest), Rounding::multiply_up(largest, largest));
  }

private:
  static void check_environment()
  {
    CORRAL_PRECONDITION(rounds_to_nearest(),
                        "interval of doubles: arithmetic while the thread does not round to nearest, as "
                        "its Arithmetic_scope would have told");
  }
  /// \pre factor.lower_ >= 0.
  static Double_interval multiply_by_positive(const Double_interval& a, const Double_interval& factor)
  {
    return from_ends(Rounding::multiply_down(a.lower_, a.lower_ >= 0 ? factor.lower_ : factor.upper_),
                     Rounding::multiply_up(a.upper_, a.upper_ >= 0 ? factor.upper_ : factor.lower_));
  }

  double lower_ = 0;
  double upper_ = 0;
};

template <class Rounding>
struct Interval_traits<Double_interval<Rounding>>
{
  using Interval = Double_interval<Rounding>;
  static constexpr std::string_view name = Rounding::name;
  static constexpr bool is_guaranteed = Rounding::is_guaranteed;
  static constexpr bool is_exact = false;
  using Scope = Nearest_scope;

  static Interval enclose(const Rational& value) { return Interval(bracket(value)); }
  static Interval enclose(const Integer& mantissa, long exponent) { return Interval(bracket(mantissa, exponent)); }
  static bool is_number(const Interval& x) { return !std::isnan(x.lower()) && !std::isnan(x.upper()); }
  static Interval hull(const Interval& a, const Interval& b)
  {
    return Interval::from_ends(std::min(a.lower(), b.lower()), std::max(a.upper(), b.upper()));
  }
  static Interval intersection(const Interval& a, const Interval& b)
  {
    const auto [low, high] = std::minmax({std::fmax(a.lower(), b.lower()), std::fmin(a.upper(), b.upper())});
    return Interval::from_ends(low, high);
  }
  static Interval lower(const Interval& x) { return Interval::from_ends(x.lower(), x.lower()); }
  static Interval upper(const Interval& x) { return Interval::from_ends(x.upper(), x.upper()); }
  static std::optional<Rational> exact_lower(const Interval& x) { return exact(x.lower()); }
  static std::optional<Rational> exact_upper(const Interval& x) { return exact(x.upper()); }
  static int lower_sign(const Interval& x) { return x.lower() > 0 ? 1 : x.lower() == 0 ? 0 : -1; }
  static int upper_sign(const Interval& x) { return x.upper() < 0 ? -1 : x.upper() == 0 ? 0 : 1; }

private:
  static std::optional<Rational> exact(double x)
  {
    return std::isfinite(x) ? std::optional<Rational>(x) : std::nullopt;
  }
};

} // namespace corral

#endif
