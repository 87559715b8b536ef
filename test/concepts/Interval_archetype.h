// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_TEST_CONCEPTS_INTERVAL_ARCHETYPE_H
#define CORRAL_TEST_CONCEPTS_INTERVAL_ARCHETYPE_H

#include <corral/number/Rational_interval.h>

#include <optional>

namespace corral::test {

/// What the concept says and nothing else: results of operators are of another type, which is converted; nothing is
/// compared, divided or printed.
class Interval_archetype
{
public:
  /// The result of an operation.
  struct Result
  {
    Rational_interval value;
    operator Interval_archetype() const { return of(value); }
  };

  Interval_archetype() = default;
  template <UnfitNumber T>
  Interval_archetype(T value) = delete;
  template <MachineNumber T>
  Interval_archetype(T value) : value_(value)
  {}

  void operator+=(const Interval_archetype& b) { value_ += b.value_; }
  void operator-=(const Interval_archetype& b) { value_ -= b.value_; }
  void operator*=(const Interval_archetype& b) { value_ *= b.value_; }
  friend Result operator+(const Interval_archetype& a, const Interval_archetype& b) { return {a.value_ + b.value_}; }
  friend Result operator-(const Interval_archetype& a, const Interval_archetype& b) { return {a.value_ - b.value_}; }
  friend Result operator*(const Interval_archetype& a, const Interval_archetype& b) { return {a.value_ * b.value_}; }
  friend Result operator-(const Interval_archetype& a) { return {-a.value_}; }
  friend Result square(const Interval_archetype& a) { return {square(a.value_)}; }

private:
  friend struct Interval_traits<Interval_archetype>;
  static Interval_archetype of(const Rational_interval& value)
  {
    Interval_archetype result;
    result.value_ = value;
    return result;
  }
  Rational_interval value_;
};

} // namespace corral::test

namespace corral {

template <>
struct Interval_traits<test::Interval_archetype>
{
  using I = test::Interval_archetype;
  using Own = Interval_traits<Rational_interval>;
  static constexpr const char* name = "archetype";
  static constexpr bool is_guaranteed = true;
  static constexpr bool is_exact = true;
  struct Scope
  {
    Scope() {}
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;
  };
  static I enclose(const Rational& value) { return I::Result{Own::enclose(value)}; }
  static bool is_number(const I&) { return true; }
  static I hull(const I& a, const I& b) { return I::Result{Own::hull(a.value_, b.value_)}; }
  static I intersection(const I& a, const I& b) { return I::Result{Own::intersection(a.value_, b.value_)}; }
  static I lower(const I& x) { return I::Result{Own::lower(x.value_)}; }
  static I upper(const I& x) { return I::Result{Own::upper(x.value_)}; }
  static std::optional<Rational> exact_lower(const I& x) { return x.value_.lower(); }
  static std::optional<Rational> exact_upper(const I& x) { return x.value_.upper(); }
  static int lower_sign(const I& x) { return sgn(x.value_.lower()); }
  static int upper_sign(const I& x) { return sgn(x.value_.upper()); }
};

} // namespace corral

#endif
