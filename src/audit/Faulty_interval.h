// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_AUDIT_FAULTY_INTERVAL_H
#define CORRAL_AUDIT_FAULTY_INTERVAL_H

#include <corral/number/Outward_interval.h>

#include <algorithm>
#include <optional>
#include <string_view>

namespace corral::audit {

/// \brief A number type that is right but for one operation.
///
/// \tparam Fault  derives from `No_fault` and replaces operations on `Outward_interval`s; it has a `name`.
template <class Fault>
class Faulty_interval
{
public:
  Faulty_interval() = default;
  template <UnfitNumber T>
  Faulty_interval(T value) = delete;
  template <MachineNumber T>
  Faulty_interval(T value) : value_(value)
  {}
  explicit Faulty_interval(const Outward_interval& value) : value_(value) {}

  [[nodiscard]] const Outward_interval& value() const { return value_; }

  Faulty_interval& operator+=(const Faulty_interval& b) { return *this = *this + b; }
  Faulty_interval& operator-=(const Faulty_interval& b) { return *this = *this - b; }
  Faulty_interval& operator*=(const Faulty_interval& b) { return *this = *this * b; }
  friend Faulty_interval operator-(const Faulty_interval& a) { return Faulty_interval(-a.value_); }
  friend Faulty_interval operator+(const Faulty_interval& a, const Faulty_interval& b)
  {
    return Faulty_interval(Fault::add(a.value_, b.value_));
  }
  friend Faulty_interval operator-(const Faulty_interval& a, const Faulty_interval& b)
  {
    return Faulty_interval(Fault::subtract(a.value_, b.value_));
  }
  friend Faulty_interval operator*(const Faulty_interval& a, const Faulty_interval& b)
  {
    return Faulty_interval(Fault::multiply(a.value_, b.value_));
  }
  friend Faulty_interval square(const Faulty_interval& a) { return Faulty_interval(Fault::square_of(a.value_)); }

private:
  Outward_interval value_;
};

/// The operations of `Outward_interval`. The control: nothing may be caught.
struct No_fault
{
  using X = Outward_interval;
  static constexpr std::string_view name = "no_fault";
  static constexpr std::string_view description = "outward-rounded doubles as they are";

  static X add(const X& a, const X& b) { return a + b; }
  static X subtract(const X& a, const X& b) { return a - b; }
  static X multiply(const X& a, const X& b) { return a * b; }
  static X square_of(const X& a) { return square(a); }
  static X hull(const X& a, const X& b) { return Interval_traits<X>::hull(a, b); }
  static X enclose(const Rational& value) { return Interval_traits<X>::enclose(value); }
};

} // namespace corral::audit

template <class Fault>
struct corral::Interval_traits<corral::audit::Faulty_interval<Fault>>
{
  using I = corral::audit::Faulty_interval<Fault>;
  using Traits = Interval_traits<Outward_interval>;
  static constexpr std::string_view name = Fault::name;
  static constexpr bool is_guaranteed = false;
  static constexpr bool is_exact = false;
  using Scope = Nearest_scope;
  static I enclose(const Rational& value) { return I(Fault::enclose(value)); }
  static I hull(const I& a, const I& b) { return I(Fault::hull(a.value(), b.value())); }
  static bool is_number(const I& x) { return Traits::is_number(x.value()); }
  static I intersection(const I& a, const I& b) { return I(Traits::intersection(a.value(), b.value())); }
  static I lower(const I& x) { return I(Traits::lower(x.value())); }
  static I upper(const I& x) { return I(Traits::upper(x.value())); }
  static std::optional<Rational> exact_lower(const I& x) { return Traits::exact_lower(x.value()); }
  static std::optional<Rational> exact_upper(const I& x) { return Traits::exact_upper(x.value()); }
  static int lower_sign(const I& x) { return Traits::lower_sign(x.value()); }
  static int upper_sign(const I& x) { return Traits::upper_sign(x.value()); }
};

#endif
