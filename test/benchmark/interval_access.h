// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_TEST_BENCHMARK_INTERVAL_ACCESS_H
#define CORRAL_TEST_BENCHMARK_INTERVAL_ACCESS_H

#include "baselines.h"

#include <CGAL/Interval_nt.h>
#include <boost/numeric/interval.hpp>

#include <arb.h>
#include <mpfi.h>

/// \file
/// The interval libraries that a user of Debian finds, each as he would use it.
namespace corral::benchmark {

/// The two doubles around a rational.
inline std::pair<double, double> bracket(const Rational& value)
{
  const double near = value.get_d();
  if (Rational(near) == value) return {near, near};
  return {std::nextafter(near, -INFINITY), std::nextafter(near, INFINITY)};
}

using Cgal_number = CGAL::Interval_nt<false>;

template <>
struct Interval_access<Cgal_number>
{
  static constexpr const char* name = "CGAL";
  using Scope = CGAL::Protect_FPU_rounding<true>;
  static Cgal_number number(const Rational& value) { return Cgal_number(bracket(value)); }
  static Cgal_number span(double low, double high) { return {low, high}; }
  static bool zero_inside(const Cgal_number& x) { return x.inf() <= 0 && x.sup() >= 0; }
};

using Boost_number = boost::numeric::interval<double>;

template <>
struct Interval_access<Boost_number>
{
  static constexpr const char* name = "Boost";
  struct Scope
  {
    Scope() {}
  };
  static Boost_number number(const Rational& value)
  {
    const auto [low, high] = bracket(value);
    return {low, high};
  }
  static Boost_number span(double low, double high) { return {low, high}; }
  static bool zero_inside(const Boost_number& x) { return x.lower() <= 0 && x.upper() >= 0; }
};

/// A C number of one of the multiple-precision libraries with value semantics.
template <class Traits>
class Wrapped
{
public:
  Wrapped() { Traits::init(value_); }
  Wrapped(const Wrapped& other) : Wrapped() { Traits::set(value_, other.value_); }
  Wrapped& operator=(const Wrapped& other)
  {
    Traits::set(value_, other.value_);
    return *this;
  }
  ~Wrapped() { Traits::clear(value_); }
  friend Wrapped operator+(const Wrapped& a, const Wrapped& b)
  {
    Wrapped result;
    Traits::add(result.value_, a.value_, b.value_);
    return result;
  }
  friend Wrapped operator-(const Wrapped& a, const Wrapped& b)
  {
    Wrapped result;
    Traits::sub(result.value_, a.value_, b.value_);
    return result;
  }
  friend Wrapped operator*(const Wrapped& a, const Wrapped& b)
  {
    Wrapped result;
    Traits::mul(result.value_, a.value_, b.value_);
    return result;
  }
  auto& get() { return value_; }
  const auto& get() const { return value_; }

private:
  typename Traits::Type value_;
};

struct Mpfi_traits
{
  using Type = mpfi_t;
  static void init(Type& x) { mpfi_init2(x, 53); }
  static void clear(Type& x) { mpfi_clear(x); }
  static void set(Type& x, const Type& y) { mpfi_set(x, y); }
  static void add(Type& r, const Type& a, const Type& b) { mpfi_add(r, a, b); }
  static void sub(Type& r, const Type& a, const Type& b) { mpfi_sub(r, a, b); }
  static void mul(Type& r, const Type& a, const Type& b) { mpfi_mul(r, a, b); }
};
using Mpfi_number = Wrapped<Mpfi_traits>;

template <>
struct Interval_access<Mpfi_number>
{
  static constexpr const char* name = "MPFI";
  struct Scope
  {
    Scope() {}
  };
  static Mpfi_number number(const Rational& value)
  {
    Mpfi_number result;
    mpfi_set_q(result.get(), value.get_mpq_t());
    return result;
  }
  static Mpfi_number span(double low, double high)
  {
    Mpfi_number result;
    mpfi_interv_d(result.get(), low, high);
    return result;
  }
  static bool zero_inside(const Mpfi_number& x) { return mpfi_has_zero(x.get()) != 0; }
};

struct Arb_traits
{
  using Type = arb_t;
  static void init(Type& x) { arb_init(x); }
  static void clear(Type& x) { arb_clear(x); }
  static void set(Type& x, const Type& y) { arb_set(x, y); }
  static void add(Type& r, const Type& a, const Type& b) { arb_add(r, a, b, 53); }
  static void sub(Type& r, const Type& a, const Type& b) { arb_sub(r, a, b, 53); }
  static void mul(Type& r, const Type& a, const Type& b) { arb_mul(r, a, b, 53); }
};
using Arb_number = Wrapped<Arb_traits>;

template <>
struct Interval_access<Arb_number>
{
  static constexpr const char* name = "Arb";
  struct Scope
  {
    Scope() {}
  };
  static Arb_number number(const Rational& value)
  {
    fmpq_t q;
    fmpq_init(q);
    fmpq_set_mpq(q, value.get_mpq_t());
    Arb_number result;
    arb_set_fmpq(result.get(), q, 53);
    fmpq_clear(q);
    return result;
  }
  static Arb_number span(double low, double high)
  {
    arf_t a;
    arf_t b;
    arf_init(a);
    arf_init(b);
    arf_set_d(a, low);
    arf_set_d(b, high);
    Arb_number result;
    arb_set_interval_arf(result.get(), a, b, 53);
    arf_clear(a);
    arf_clear(b);
    return result;
  }
  static bool zero_inside(const Arb_number& x) { return arb_contains_zero(x.get()) != 0; }
};

} // namespace corral::benchmark

#endif
