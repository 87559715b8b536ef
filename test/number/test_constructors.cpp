// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/errors.h>
#include <corral/number/all.h>

#include <gtest/gtest.h>

#include <concepts>
#include <cstdint>
#include <limits>

namespace {

using namespace corral;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// Whether no constructor of `I`, neither of one nor of two ends, takes a `T`.
template <class I, class T>
constexpr bool refuses = !std::constructible_from<I, T> && !std::constructible_from<I, T, T>;

template <class I>
constexpr bool refuses_what_is_not_exact = refuses<I, bool>&& refuses<I, char>&& refuses<I, char16_t>&&
    refuses<I, wchar_t>&& refuses<I, long double>&& refuses<I, detail::Int128>&& refuses<I, detail::Uint128>;
static_assert(refuses_what_is_not_exact<Nearest_interval> && refuses_what_is_not_exact<Outward_interval>);
static_assert(refuses_what_is_not_exact<Cgal_interval> && refuses_what_is_not_exact<Counted<Outward_interval>>);
static_assert(!std::constructible_from<Rational_interval,
                                       long double> && !std::constructible_from<Rational_interval, detail::Int128>);
static_assert(!std::constructible_from<Mpfr_interval, long double> && !std::constructible_from<Mpfr_interval, bool>);

/// A number type whose constructor takes `int` alone, as all did once: it truncates, so it is no `IntervalNumber`.
struct Truncating : Outward_interval
{
  Truncating() = default;
  Truncating(int value) : Outward_interval(value) {}
};

template <class I>
class Constructors : public ::testing::Test
{
};
using Types = ::testing::Types<Nearest_interval, Outward_interval, Cgal_interval, Mpfr_interval, Rational_interval,
                               Counted<Outward_interval>, Counted<Rational_interval>>;
TYPED_TEST_SUITE(Constructors, Types);

TYPED_TEST(Constructors, take_doubles_exactly)
{
  using I = TypeParam;
  const Arithmetic_scope<I> scope;
  for (const double x : {0.5, -0.1, 0x1.fffffffffffffp+1023, 0x1p-1074, 0.0}) {
    const I made = x;
    EXPECT_EQ(exact_lower(made), Rational(x)) << x;
    EXPECT_EQ(exact_upper(made), Rational(x)) << x;
  }
  EXPECT_EQ(exact_upper(I(I(3) * 0.5)), Rational(3, 2));
  EXPECT_EQ(exact_upper(I(0.1F)), Rational(0.1F));
}

TYPED_TEST(Constructors, take_integers_of_every_width)
{
  using I = TypeParam;
  const Arithmetic_scope<I> scope;
  EXPECT_EQ(exact_lower(I(5000000000L)), Rational(5000000000L));
  EXPECT_EQ(exact_lower(I(std::int8_t{-7})), Rational(-7));
  const auto expect_tightest = [](auto value) {
    const I made = value;
    const auto tightest = enclose<I>(exact_value(value));
    EXPECT_EQ(exact_lower(made), exact_lower(tightest)) << value;
    EXPECT_EQ(exact_upper(made), exact_upper(tightest)) << value;
    EXPECT_TRUE(!is_guaranteed<I> || contains(made, exact_value(value))) << value;
  };
  expect_tightest((1L << 53) + 1);
  expect_tightest(-(1L << 53) - 1);
  expect_tightest(std::numeric_limits<long>::min());
  expect_tightest(std::numeric_limits<long long>::max());
  expect_tightest(std::numeric_limits<unsigned long>::max());
  expect_tightest(std::numeric_limits<unsigned>::max());
}

TYPED_TEST(Constructors, never_take_infinities_for_numbers)
{
  using I = TypeParam;
  if constexpr (is_exact<I>) {
    for (const double x : {infinity, -infinity, not_a_number}) EXPECT_THROW((void)I(x), Invalid_input);
  } else if constexpr (is_guaranteed<I>) {
    EXPECT_TRUE(contains(I(infinity), Rational(Integer(1) << 1024)) && strict_sign(I(infinity)) == 1);
    EXPECT_TRUE(contains(I(-infinity), Rational(-(Integer(1) << 1024))) && strict_sign(I(-infinity)) == -1);
    const I unknown = not_a_number;
    EXPECT_FALSE(exact_lower(unknown) || exact_upper(unknown));
    EXPECT_EQ(strict_sign(unknown), 0);
  }
}

TEST(Constructors, of_two_ends_are_exact_or_outward_and_in_order)
{
  static_assert(!IntervalNumber<Truncating>);
  constexpr long odd = (1L << 53) + 1;
  EXPECT_TRUE(contains(Outward_interval(odd, odd), Rational(odd)));
  EXPECT_TRUE(contains(Cgal_interval(-odd, odd), Rational(odd)));
  EXPECT_EQ(Rational_interval(0.5, 5000000000L).upper(), Rational(5000000000L));
  EXPECT_EQ(Rational_interval(Rational(1, 3), 0.5).upper(), Rational(1, 2));
  EXPECT_THROW(Outward_interval(1, 0), Invalid_input);
  EXPECT_THROW(Cgal_interval(1.0, 0.5), Invalid_input);
  EXPECT_THROW(Rational_interval(1, 0), Invalid_input);
  EXPECT_THROW(Rational_interval(Rational(1, 3), Rational(1, 4)), Invalid_input);
  EXPECT_THROW(Rational_interval(not_a_number, 1), Invalid_input);
  EXPECT_THROW(Rational_interval(Rational(0), infinity), Invalid_input);
}

TEST(Is_number, tells_not_a_number_from_infinity)
{
  const auto unbounded = Outward_interval(-infinity, infinity);
  const auto nothing = Outward_interval::from_ends(not_a_number, 1);
  EXPECT_TRUE(is_number(unbounded) && contains(unbounded, 2));
  EXPECT_FALSE(is_number(nothing) || contains(nothing, 0));
  EXPECT_FALSE(is_number(Counted<Outward_interval>(nothing)) || contains(Counted<Outward_interval>(nothing), 0));
  EXPECT_FALSE(contains(Outward_interval::from_ends(infinity, infinity), 0)); // an infinity on the wrong side
  const Mpfr_interval no_mpfr = not_a_number;
  EXPECT_FALSE(is_number(no_mpfr) || contains(no_mpfr, 0));
  EXPECT_TRUE(contains(intersection(nothing, Outward_interval(0, 1)), 0)); // it restricts nothing
}

TEST(Bracket, of_a_scaled_integer_is_that_of_the_rational)
{
  for (const char* digits : {"1", "-1", "9007199254740993", "-9007199254740993", "18014398509481985", "-3",
                             "1267650600228229401496703205377", "-1267650600228229401496703205377"})
    for (long exponent :
         {0L, 1L, -1L, 900L, 960L, 970L, 971L, 1100L, -1000L, -1070L, -1074L, -1075L, -1130L, -1180L, -5000L}) {
      const Integer mantissa(digits);
      const Rational value(exponent < 0 ? Rational(Rational(mantissa) >> static_cast<mp_bitcnt_t>(-exponent))
                                        : Rational(Rational(mantissa) << static_cast<mp_bitcnt_t>(exponent)));
      const auto expected = bracket(value);
      const auto found = bracket(mantissa, exponent);
      EXPECT_EQ(found.below, expected.below) << digits << " 2^" << exponent;
      EXPECT_EQ(found.nearest, expected.nearest) << digits << " 2^" << exponent;
      EXPECT_EQ(found.above, expected.above) << digits << " 2^" << exponent;
    }
}

} // namespace
