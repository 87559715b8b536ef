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
  Cgal_interval(int value) : value_(value) {}
  explicit Cgal_interval(const Value& value) : value_(value) {}
  /// \pre lower <= upper.
  Cgal_interval(double lower, double upper) : value_(lower, upper) {}

  [[nodiscard]] const Value& value() const { return value_; }
  [[nodiscard]] double lower() const { return value_.inf(); }
  [[nodiscard]] double upper() const { return value_.sup(); }

  Cgal_interval& operator+=(const Cgal_interval& b) { return *this = *this + b; }
  Cgal_interval& operator-=(const Cgal_interval& b) { return *this = *this - b; }
  Cgal_interval& operator*=(const Cgal_interval& b) { return *this = *this * b; }
  friend Cgal_interval operator-(const Cgal_interval& a) { return Cgal_interval(-a.value_); }
  friend Cgal_interval operator+(const Cgal_interval& a, const Cgal_interval& b)
  {
    return Cgal_interval(a.value_ + b.value_);
  }
  friend Cgal_interval operator-(const Cgal_interval& a, const Cgal_interval& b)
  {
    return Cgal_interval(a.value_ - b.value_);
  }
  friend Cgal_interval operator*(const Cgal_interval& a, const Cgal_interval& b)
  {
    return Cgal_interval(a.value_ * b.value_);
  }
  friend Cgal_interval square(const Cgal_interval& a) { return Cgal_interval(CGAL::square(a.value_)); }

private:
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

  static Cgal_interval enclose(const Rational& value)
  {
    const auto doubles = bracket(value);
    return {doubles.below, doubles.above};
  }
  static Cgal_interval hull(const Cgal_interval& a, const Cgal_interval& b)
  {
    return {std::min(a.lower(), b.lower()), std::max(a.upper(), b.upper())};
  }
  static Cgal_interval lower(const Cgal_interval& x) { return {x.lower(), x.lower()}; }
  static Cgal_interval upper(const Cgal_interval& x) { return {x.upper(), x.upper()}; }
  static std::optional<Rational> exact_lower(const Cgal_interval& x) { return exact(x.lower()); }
  static std::optional<Rational> exact_upper(const Cgal_interval& x) { return exact(x.upper()); }
  static int lower_sign(const Cgal_interval& x) { return x.lower() > 0 ? 1 : x.lower() == 0 ? 0 : -1; }
  static int upper_sign(const Cgal_interval& x) { return x.upper() < 0 ? -1 : x.upper() == 0 ? 0 : 1; }

private:
  static std::optional<Rational> exact(double x)
  {
    return std::isfinite(x) ? std::optional<Rational>(x) : std::nullopt;
  }
};

} // namespace corral

#endif
