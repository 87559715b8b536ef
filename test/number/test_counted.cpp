// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/errors.h>
#include <corral/number/all.h>

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <thread>

namespace {

using namespace corral;
using I = Counted<Outward_interval>;

TEST(Counted, counts_additions_and_multiplications_only)
{
  const Counting_scope scope;
  I x = enclose<I>(Rational(1, 3), 2);
  x = hull(lower(x), -upper(x));
  (void)strict_sign(symmetric_hull(hull_with_zero(x)));
  EXPECT_EQ(scope.counts(), (Operation_counts{0, 0}));
  x = x + x - 1;
  x += x;
  x -= I(1);
  EXPECT_EQ(scope.counts(), (Operation_counts{4, 0}));
  x = square(x) * x;
  x *= x;
  EXPECT_EQ(scope.counts(), (Operation_counts{4, 3}));
  x = power(x, 5); // ((x^2)^2) x
  EXPECT_EQ(scope.counts(), (Operation_counts{4, 6}));
  EXPECT_EQ(I::counts(), scope.counts());
}

TEST(Counted, scopes_nest_and_other_threads_count_for_themselves)
{
  const Counting_scope outer;
  (void)(I(1) + I(2));
  {
    const Counting_scope inner;
    (void)(I(1) * I(2));
    std::thread([] { (void)(I(1) * I(2)); }).join();
    EXPECT_EQ(inner.counts(), (Operation_counts{0, 1}));
  }
  EXPECT_EQ(outer.counts(), (Operation_counts{1, 1}));
  try {
    const Counting_scope inner;
    (void)(I(1) + I(2));
    throw std::runtime_error("stop");
  } catch (const std::runtime_error&) {
  }
  EXPECT_EQ(outer.counts(), (Operation_counts{2, 1}));
}

TEST(Number_types, are_found_by_name)
{
  EXPECT_EQ(Number_types::names(), "double_nearest, double_outward, cgal_interval, mpfr, rational, counted");
  Number_types::for_each([]<class Type>(std::type_identity<Type>) {
    const std::string_view name = Interval_traits<Type>::name;
    EXPECT_EQ(Number_types::visit(name, [](auto type) { return Interval_traits<typename decltype(type)::type>::name; }),
              name);
  });
  try {
    Number_types::visit("float", [](auto) {});
    FAIL();
  } catch (const Invalid_input& error) {
    EXPECT_NE(std::string(error.what()).find("'float'; expected one of double_nearest"), std::string::npos);
  }
}

} // namespace
