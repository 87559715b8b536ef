// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_TEST_NUMBER_FAULTY_INTERVAL_H
#define CORRAL_TEST_NUMBER_FAULTY_INTERVAL_H

#include <corral/number/Outward_interval.h>

namespace corral::test {

/// \brief A type that is right but for one operation: the negative control of the conformance suite.
///
/// \tparam Fault  offers `add`, `multiply` and `square` of two `Outward_interval`s.
template <class Fault>
class Faulty_interval
{
public:
  Faulty_interval() = default;
  Faulty_interval(int value) : value_(value) {}
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
  friend Faulty_interval operator-(const Faulty_interval& a, const Faulty_interval& b) { return a + -b; }
  friend Faulty_interval operator*(const Faulty_interval& a, const Faulty_interval& b)
  {
    return Faulty_interval(Fault::multiply(a.value_, b.value_));
  }
  friend Faulty_interval square(const Faulty_interval& a) { return Faulty_interval(Fault::square_of(a.value_)); }

private:
  Outward_interval value_;
};

struct No_fault
{
  using X = Outward_interval;
  static X add(const X& a, const X& b) { return a + b; }
  static X multiply(const X& a, const X& b) { return a * b; }
  static X square_of(const X& a) { return square(a); }
};

/// The upper bound of a sum is rounded down.
struct Sum_rounded_wrongly : No_fault
{
  static X add(const X& a, const X& b)
  {
    return {Outward_rounding::add_down(a.lower(), b.lower()), Outward_rounding::add_down(a.upper(), b.upper())};
  }
};

/// A product of wide intervals is a little too narrow.
struct Product_shrinks : No_fault
{
  static X multiply(const X& a, const X& b)
  {
    const X product = a * b;
    return product.lower() < product.upper() ? X(std::nextafter(product.lower(), product.upper()), product.upper())
                                             : product;
  }
};

/// The square of an interval of both signs does not reach zero.
struct Square_loses_zero : No_fault
{
  static X square_of(const X& a)
  {
    const X low = square(X(a.lower()));
    const X high = square(X(a.upper()));
    return {std::min(low.lower(), high.lower()), std::max(low.upper(), high.upper())};
  }
};

} // namespace corral::test

template <class Fault>
struct corral::Interval_traits<corral::test::Faulty_interval<Fault>>
{
  using I = corral::test::Faulty_interval<Fault>;
  using Traits = Interval_traits<Outward_interval>;
  static constexpr std::string_view name = "faulty";
  static constexpr bool is_guaranteed = false;
  static constexpr bool is_exact = false;
  using Scope = Nearest_scope;
  static I enclose(const Rational& value) { return I(Traits::enclose(value)); }
  static I hull(const I& a, const I& b) { return I(Traits::hull(a.value(), b.value())); }
  static I lower(const I& x) { return I(Traits::lower(x.value())); }
  static I upper(const I& x) { return I(Traits::upper(x.value())); }
  static std::optional<Rational> exact_lower(const I& x) { return Traits::exact_lower(x.value()); }
  static std::optional<Rational> exact_upper(const I& x) { return Traits::exact_upper(x.value()); }
  static int lower_sign(const I& x) { return Traits::lower_sign(x.value()); }
  static int upper_sign(const I& x) { return Traits::upper_sign(x.value()); }
};

#endif
