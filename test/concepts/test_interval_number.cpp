// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Interval_archetype.h"

#include <corral/audit/audit_number.h>

#include <gtest/gtest.h>

#include <string_view>
#include <utility>

namespace corral {

namespace test {
namespace {

static_assert(IntervalNumber<Interval_archetype>);

/// An interval by name only.
struct Without_traits : Rational_interval
{
  using Rational_interval::Rational_interval;
};
static_assert(!IntervalNumber<Without_traits>);
static_assert(!IntervalNumber<double>);

} // namespace

/// The archetype without one thing.
template <int Missing>
class Poor
{
public:
  Poor() = default;
  template <MachineNumber T>
  Poor(T)
  {}
  template <UnfitNumber T>
  Poor(T) = delete;
  Poor& operator+=(const Poor&) requires(Missing != 6);
  Poor& operator-=(const Poor&) requires(Missing != 7);
  Poor& operator*=(const Poor&) requires(Missing != 8);
};
template <int Missing>
  requires(Missing != 1)
Poor<Missing>
operator+(const Poor<Missing>&, const Poor<Missing>&);
template <int Missing>
  requires(Missing != 2)
Poor<Missing>
operator-(const Poor<Missing>&, const Poor<Missing>&);
template <int Missing>
  requires(Missing != 3)
Poor<Missing>
operator*(const Poor<Missing>&, const Poor<Missing>&);
template <int Missing>
  requires(Missing != 4)
Poor<Missing>
operator-(const Poor<Missing>&);
template <int Missing>
  requires(Missing != 5)
Poor<Missing> square(const Poor<Missing>&);

} // namespace test

template <int Missing>
struct Interval_traits<test::Poor<Missing>>
{
  using I = test::Poor<Missing>;
  static constexpr std::string_view name = "poor";
  static constexpr bool is_guaranteed = true;
  static constexpr bool is_exact = true;
  struct Scope
  {
  };
  static I enclose(const Rational&) requires(Missing != 9);
  static bool is_number(const I&) requires(Missing != 10);
  static I hull(const I&, const I&) requires(Missing != 11);
  static I intersection(const I&, const I&) requires(Missing != 12);
  static I lower(const I&) requires(Missing != 13);
  static I upper(const I&) requires(Missing != 14);
  static std::optional<Rational> exact_lower(const I&) requires(Missing != 15);
  static std::optional<Rational> exact_upper(const I&) requires(Missing != 16);
  static int lower_sign(const I&) requires(Missing != 17);
  static int upper_sign(const I&) requires(Missing != 18);
};

namespace test {
namespace {

static_assert(IntervalNumber<Poor<0>>); // nothing is missing
template <int... Missing>
constexpr bool none_is_a_model(std::integer_sequence<int, Missing...>)
{
  return !(IntervalNumber<Poor<Missing + 1>> || ...);
}
static_assert(none_is_a_model(std::make_integer_sequence<int, 18>()));

TEST(Concepts, a_number_that_offers_no_more_is_audited)
{
  EXPECT_EQ(audit_number<Interval_archetype>({.cases = 50}).faults, 0U);
}

} // namespace
} // namespace test

} // namespace corral
