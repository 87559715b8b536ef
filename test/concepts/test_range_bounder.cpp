// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/audit/audit_bounder.h>
#include <corral/bounders/Any_bounder.h>
#include <corral/bounders/Intersection_bounder.h>
#include <corral/bounders/enclose_range.h>
#include <corral/localization/localize_with_bounder.h>
#include <corral/number/Rational_interval.h>

#include <gtest/gtest.h>

namespace {

using namespace corral;

/// What the concept says and nothing else: no default, and a name that is no string. The bound is of |x|, |y| <= 1.
struct Archetype
{
  using Interval = Rational_interval;
  using Polynomial = corral::Polynomial<Rational_interval, 2>;
  using Box = corral::Box<Rational_interval, 2>;
  static constexpr std::size_t dimension = 2;
  struct Name
  {
    constexpr operator std::string_view() const { return "archetype"; }
  };
  static constexpr Name name{};

  explicit Archetype(const Polynomial& f)
  {
    for (const auto& term : f.terms()) sum += symmetric_hull(term.coefficient);
  }
  Interval bound(const Box&) const { return sum; }

  Interval sum;
};
static_assert(RangeBounder<Archetype>);

struct Without_dimension
{
  using Interval = Archetype::Interval;
  using Polynomial = Archetype::Polynomial;
  using Box = Archetype::Box;
  [[maybe_unused]] static constexpr std::string_view name = "";
  explicit Without_dimension(const Polynomial&);
  Interval bound(const Box&) const;
};
struct Without_name
{
  using Interval = Archetype::Interval;
  using Polynomial = Archetype::Polynomial;
  using Box = Archetype::Box;
  static constexpr std::size_t dimension = 2;
  explicit Without_name(const Polynomial&);
  Interval bound(const Box&) const;
};
struct Bounds_only_when_it_may_change : Archetype
{
  using Archetype::Archetype;
  Interval bound(const Box&);
};
struct Bounds_by_something_else : Archetype
{
  using Archetype::Archetype;
  double bound(const Box&) const;
};
struct Of_no_polynomial : Archetype
{
  Of_no_polynomial();
};
struct Cannot_be_copied : Archetype
{
  using Archetype::Archetype;
  Cannot_be_copied(const Cannot_be_copied&) = delete;
};
struct Of_another_number : Archetype
{
  using Archetype::Archetype;
  using Interval = double;
};
struct Of_another_box : Archetype
{
  using Archetype::Archetype;
  using Box = corral::Box<Rational_interval, 3>;
};
static_assert(!RangeBounder<Without_dimension>);
static_assert(!RangeBounder<Without_name>);
static_assert(!RangeBounder<Bounds_only_when_it_may_change>);
static_assert(!RangeBounder<Bounds_by_something_else>);
static_assert(!RangeBounder<Of_no_polynomial>);
static_assert(!RangeBounder<Cannot_be_copied>);
static_assert(!RangeBounder<Of_another_number>);
static_assert(!RangeBounder<Of_another_box>);

TEST(Concepts, a_bounder_that_offers_no_more_works_everywhere)
{
  const auto f = collect<Rational, 2>({{{2, 0}, 1}, {{0, 1}, 1}, {{0, 0}, 3}}); // x^2 + y + 3
  const Grid grid({{-1, 1}, {-1, 1}}, 4);
  EXPECT_EQ(localize<Archetype>(f, grid).plotted(), 16U);
  EXPECT_EQ(localize<Archetype>({f, f}, grid, {}, {.sample = true, .refine_depth = 1}).unknown(), 16U);
  const Archetype bounder(enclosure_for_localization<Rational_interval>(f));
  EXPECT_EQ(localize(bounder, grid, {}, {.sample = true}).unknown(), 16U);
  EXPECT_EQ(enclose_range<Archetype>(f, grid.box()).upper(), 5);
  EXPECT_EQ((Any_bounder<Rational_interval, 2>(bounder).bound(grid.box()).upper()), 5);
  EXPECT_GT(audit_bounder<Archetype>({.cases = 40}).escapes, 0U); // beyond that square
}

} // namespace
