// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_NUMBER_CGAL_INTERVAL_H
#define CORRAL_NUMBER_CGAL_INTERVAL_H

#include <corral/number/Double_bracket.h>
#include <corral/number/Environment.h>
#include <corral/number/Interval_number.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cmath>

namespace corral {

/// \brief Model of `IntervalNumber`: CGAL's interval of doubles without its own protection, so that the rounding mode
/// is set once for each `Arithmetic_scope` and not for each operation.
///
/// A class of its own, because CGAL's functions `hull` and the like would make Corral's ambiguous. With g++ all code
/// that uses it must be compiled with -frounding-math, as the CMake target does.
class Cgal_interval
{
public:
  using Value = CGAL::Interval_nt<false>;

  Cgal_interval() : value_(0) {}
  template <UnfitNumber T>
  Cgal_interval(T value) = delete;
  /// The tightest interval around a built-in number.
  template <MachineNumber T>
  Cgal_interval(T value) : Cgal_interval(bracket(value))
  {}
  /// The tightest interval around both. \throw Invalid_input unless lower <= upper.
  template <MachineNumber L, MachineNumber U>
  Cgal_interval(L lower, U upper) : value_(0)
  {
    const double below = bracket(lower).below;
    const double above = bracket(upper).above;
    if (!(below <= above)) detail::refuse_order("cgal_interval", below, above);
    value_ = Value(below, above);
  }
  explicit Cgal_interval(const Double_bracket& doubles) : value_(doubles.below, doubles.above) {}
  explicit Cgal_interval(const Value& value) : value_(value) {}

  [[nodiscard]] const Value& value() const { return value_; }
  [[nodiscard]] double lower() const { return value_.inf(); }
  [[nodiscard]] double upper() const { return value_.sup(); }

  Cgal_interval& operator+=(const Cgal_interval& b) { return *this = *this + b; }
  Cgal_interval& operator-=(const Cgal_interval& b) { return *this = *this - b; }
  Cgal_interval& operator*=(const Cgal_interval& b) { return *this = *this * b; }
  friend Cgal_interval operator-(const Cgal_interval& a) { return Cgal_interval(-a.value_); }
  friend Cgal_interval operator+(const Cgal_interval& a, const Cgal_interval& b)
  {
    check_rounding();
    return Cgal_interval(a.value_ + b.value_);
  }
  friend Cgal_interval operator-(const Cgal_interval& a, const Cgal_interval& b)
  {
    check_rounding();
    return Cgal_interval(a.value_ - b.value_);
  }
  friend Cgal_interval operator*(const Cgal_interval& a, const Cgal_interval& b)
  {
    check_rounding();
    return Cgal_interval(a.value_ * b.value_);
  }
  friend Cgal_interval square(const Cgal_interval& a)
  {
    check_rounding();
    return Cgal_interval(CGAL::square(a.value_));
  }

private:
  static void check_rounding()
  {
    CORRAL_PRECONDITION(rounds_upward(),
                        "cgal_interval: arithmetic while the thread does not round upward; expected an "
                        "Arithmetic_scope<Cgal_interval> on this thread");
  }

  Value value_;
};

/// \brief Sets the rounding mode that `Cgal_interval` needs and restores it, exceptions included.
///
/// Do no arithmetic with other doubles while it lives: their guards refuse to begin.
class Cgal_scope
{
public:
  /// \throw Unsafe_environment if subnormals are lost, or intervals do not widen in this translation unit.
  [[gnu::always_inline]] Cgal_scope()
  {
    if (const auto fault = find_subnormal_fault(); fault != Environment_fault::none) refuse_environment(fault);
    if (!rounds_outward()) refuse_environment(Environment_fault::directed_rounding);
  }

private:
  /// Whether sums and products of full mantissas have two end points, with the true value between.
  [[nodiscard, gnu::always_inline]] static inline bool rounds_outward()
  {
    volatile double factor_again = 1 + 0x1p-30;
    const double factor = factor_again;
    using Value = Cgal_interval::Value;
    const Value square = Value(factor) * Value(factor); // 1 + 2^-29 + 2^-60
    const Value sum = Value(factor) + Value(0x1p-60);
    return square.inf() == 1 + 0x1p-29 && square.sup() == 1 + 0x1p-29 + 0x1p-52 && sum.inf() == factor
           && sum.sup() == 1 + 0x1p-30 + 0x1p-52;
  }

  Cgal_interval::Value::Protector protector_;
};

template <>
struct Interval_traits<Cgal_interval>
{
  static constexpr std::string_view name = "cgal_interval";
  static constexpr bool is_guaranteed = true;
  static constexpr bool is_exact = false;
  using Scope = Cgal_scope;

  static Cgal_interval enclose(const Rational& value) { return Cgal_interval(bracket(value)); }
  static Cgal_interval enclose(const Integer& mantissa, long exponent)
  {
    return Cgal_interval(bracket(mantissa, exponent));
  }
  static bool is_number(const Cgal_interval& x) { return !std::isnan(x.lower()) && !std::isnan(x.upper()); }
  static Cgal_interval hull(const Cgal_interval& a, const Cgal_interval& b)
  {
    return from_ends(std::min(a.lower(), b.lower()), std::max(a.upper(), b.upper()));
  }
  static Cgal_interval intersection(const Cgal_interval& a, const Cgal_interval& b)
  {
    const auto [low, high] = std::minmax({std::fmax(a.lower(), b.lower()), std::fmin(a.upper(), b.upper())});
    return from_ends(low, high);
  }
  static Cgal_interval lower(const Cgal_interval& x) { return from_ends(x.lower(), x.lower()); }
  static Cgal_interval upper(const Cgal_interval& x) { return from_ends(x.upper(), x.upper()); }
  static std::optional<Rational> exact_lower(const Cgal_interval& x) { return exact(x.lower()); }
  static std::optional<Rational> exact_upper(const Cgal_interval& x) { return exact(x.upper()); }
  static int lower_sign(const Cgal_interval& x) { return x.lower() > 0 ? 1 : x.lower() == 0 ? 0 : -1; }
  static int upper_sign(const Cgal_interval& x) { return x.upper() < 0 ? -1 : x.upper() == 0 ? 0 : 1; }

private:
  static Cgal_interval from_ends(double lower, double upper)
  {
    return Cgal_interval(Cgal_interval::Value(lower, upper));
  }
  static std::optional<Rational> exact(double x)
  {
    return std::isfinite(x) ? std::optional<Rational>(x) : std::nullopt;
  }
};

} // namespace corral

#endif
