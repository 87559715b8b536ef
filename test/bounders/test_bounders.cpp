// SPDX-License-Identifier: LGPL-3.0-or-later
#include "rounds.h"

#include <corral/algebra/exact_range.h>
#include <corral/audit/Trouble_source.h>
#include <corral/audit/audit_cases.h>
#include <corral/bounders/Any_bounder.h>
#include <corral/bounders/all.h>
#include <corral/bounders/enclose_range.h>
#include <corral/errors.h>
#include <corral/number/Outward_interval.h>
#include <corral/number/Rational_interval.h>
#include <corral/polynomial/parse.h>
#include <corral/polynomial/substitution.h>

#include <gtest/gtest.h>

#include <limits>

namespace {

using namespace corral;
using namespace corral::test;
using Exact = Rational_interval;

// Exact arithmetic shows the methods themselves: what one promises of another, and where it is exact.

template <std::size_t D>
Polynomial<Exact, D> over_points(const Polynomial<Rational, D>& f)
{
  return transform<Exact>(f, [](const Rational& c) { return Exact(c); });
}

bool is_inside(const Exact& a, const Exact& b) { return b.lower() <= a.lower() && a.upper() <= b.upper(); }

void expect_range(const Exact& bound, const Rational& low, const Rational& high, std::string_view method)
{
  EXPECT_EQ(bound.lower(), low) << method;
  EXPECT_EQ(bound.upper(), high) << method;
}

template <std::size_t D>
void check_relations(std::uint64_t seed)
{
  int maa_is_tighter = 0;
  int bernstein_is_tighter = 0;
  for (int round = 0; round < rounds(60); ++round) {
    const auto example = generated_case<D>(seed, static_cast<std::uint64_t>(round));
    const auto& box = example.boxes.front().box;
    const auto f = over_points(example.polynomial);
    const auto centred = Centred_bounder<Exact, D>(f).bound(box);
    const auto maa = Modified_affine_bounder<Exact, D>(f).bound(box);
    const auto bernstein = Bernstein_bounder<Exact, D>(f).bound(box);
    const auto both = Best_intersection<Exact, D>(f).bound(box);
    EXPECT_TRUE(is_inside(maa, centred));
    EXPECT_TRUE(is_inside(bernstein, centred));
    EXPECT_TRUE(is_inside(both, maa) && is_inside(both, bernstein));
    maa_is_tighter += is_inside(centred, maa) ? 0 : 1;
    bernstein_is_tighter += is_inside(centred, bernstein) ? 0 : 1;
  }
  EXPECT_GT(maa_is_tighter, 0); // the comparison can tell them apart
  EXPECT_GT(bernstein_is_tighter, 0);
}

TEST(Bounders, maa_and_bernstein_lie_inside_the_centred_form)
{
  check_relations<1>(1);
  check_relations<2>(2);
  check_relations<3>(3);
}

template <std::size_t D>
void check_expansion(std::uint64_t seed)
{
  for (std::uint64_t number = 0; number < 40; ++number) {
    const auto example = generated_case<D>(seed, number);
    const auto& box = example.boxes.front().box;
    const auto expansion = Scaled_taylor<Exact, D>(over_points(example.polynomial)).expand(box);
    std::array<Rational, D> centre;
    for (std::size_t axis = 0; axis < D; ++axis) {
      const auto& side = box[axis];
      centre[axis] = (side.lower() + side.upper()) / 2;
      EXPECT_EQ(expansion.radius[axis].lower(), (side.upper() - side.lower()) / 2);
    }
    std::vector<typename Polynomial<Rational, D>::Term> terms;
    for (const auto& term : expansion.taylor.terms()) terms.push_back({term.exponents, term.coefficient.lower()});
    EXPECT_EQ((collect<Rational, D>(std::move(terms))), taylor_shift(example.polynomial, centre));
  }
}

TEST(Scaled_taylor, agrees_with_the_exact_shift)
{
  check_expansion<1>(1);
  check_expansion<2>(2);
  check_expansion<3>(3);
  check_expansion<4>(4);
}

TEST(Bounders, are_exact_at_points)
{
  for (std::uint64_t number = 0; number < 20; ++number) {
    const auto example = generated_case<3>(5, number);
    auto box = example.boxes.front().box;
    std::array<Rational, 3> point;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      point[axis] = box[axis].upper();
      box[axis] = Exact(point[axis]);
    }
    const Rational value = evaluate(example.polynomial, point);
    Bounders::for_each<Exact, 3>([&](auto bounder) {
      using B = typename decltype(bounder)::type;
      expect_range(B(over_points(example.polynomial)).bound(box), value, value, B::name);
    });
  }
}

TEST(Bounders, are_exact_for_affine_functions)
{
  const Polynomial<Rational, 2> f({{{0, 0}, Rational(1, 3)}, {{0, 1}, -5}, {{1, 0}, Rational(2, 7)}});
  const Rational_box<2> box = {Exact(-1, 3), Exact(Rational(1, 2), 2)};
  Bounders::for_each<Exact, 2>([&](auto bounder) {
    using B = typename decltype(bounder)::type;
    expect_range(B(over_points(f)).bound(box), Rational(1, 3) - 10 - Rational(2, 7),
                 Rational(1, 3) - Rational(5, 2) + Rational(6, 7), B::name);
  });
}

TEST(Bernstein_bounder, is_exact_for_multilinear_polynomials)
{
  Trouble_source random(6);
  for (int round = 0; round < 20; ++round) {
    std::vector<Polynomial<Rational, 3>::Term> terms;
    for (std::uint16_t i = 0; i < 2; ++i)
      for (std::uint16_t j = 0; j < 2; ++j)
        for (std::uint16_t k = 0; k < 2; ++k) terms.push_back({{i, j, k}, random.full_mantissa()});
    const Polynomial<Rational, 3> f(std::move(terms));
    const auto box = generated_case<3>(6, static_cast<std::uint64_t>(round)).boxes.front().box;
    std::vector<Rational> values;
    for (unsigned bits = 0; bits < 8; ++bits) {
      std::array<Rational, 3> corner;
      for (std::size_t axis = 0; axis < 3; ++axis)
        corner[axis] = (bits >> axis & 1U) != 0 ? box[axis].upper() : box[axis].lower();
      values.push_back(evaluate(f, corner));
    }
    const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
    expect_range(Bernstein_bounder<Exact, 3>(over_points(f)).bound(box), *least, *greatest, "bernstein");
  }
}

TEST(Bounders, give_the_bounds_known_by_hand)
{
  const auto f = over_points(Polynomial<Rational, 1>({{{1}, -1}, {{2}, 1}})); // x^2 - x on [0, 1]: range [-1/4, 0]
  const auto expect = [&](std::string_view method, const Rational& low, const Rational& high) {
    expect_range(Any_bounder<Exact, 1>(method, f).bound({Exact(0, 1)}), low, high, method);
  };
  expect("natural", -1, 1);
  expect("horner", -1, 0);                               // (x - 1) x
  expect("centred", Rational(-1, 2), 0);                 // -1/4 + u^2/4, u^2 in [-1, 1]
  expect("maa", Rational(-1, 4), 0);                     // u^2 in [0, 1]
  expect("affine", Rational(-1, 2), 0);                  // (-1/2 + e/2) (1/2 + e/2)
  expect("bernstein", Rational(-1, 2), 0);               // 0, -1/2, 0
  expect("mean_value", Rational(-3, 4), Rational(1, 4)); // -1/4 + [-1, 1] [-1/2, 1/2]
  expect("intersection", Rational(-1, 4), 0);
}

TEST(Any_bounder, holds_what_was_asked_for)
{
  const auto f = over_points(Polynomial<Rational, 2>({{{0, 2}, 3}, {{3, 0}, 1}}));
  const Rational_box<2> box = {Exact(-1, 2), Exact(1, 3)};
  Bounders::for_each<Exact, 2>([&](auto bounder) {
    using B = typename decltype(bounder)::type;
    const Any_bounder<Exact, 2> any(B::name, f);
    const auto copy = any;
    const auto bound = B(f).bound(box);
    EXPECT_EQ(copy.method(), B::name);
    expect_range(copy.bound(box), bound.lower(), bound.upper(), B::name);
  });
  EXPECT_THROW((Any_bounder<Exact, 2>("magic", f)), Invalid_input);
  static_assert(RangeBounder<Any_bounder<Exact, 2>>);
}

TEST(Intersection, handles_unbounded_intervals)
{
  using I = Outward_interval;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto expect = [](const I& a, const I& b, double low, double high) {
    for (const I& c : {intersection(a, b), intersection(b, a)}) {
      EXPECT_EQ(c.lower(), low);
      EXPECT_EQ(c.upper(), high);
    }
  };
  expect(I(1, 4), I(2, 3), 2, 3);
  expect(I(1, 3), I(2, 4), 2, 3);
  expect(I(1, 2), I(2, 4), 2, 2);
  expect(I(-infinity, 3), I(2, infinity), 2, 3);
  expect(I(-infinity, 3), I(-infinity, 2), -infinity, 2);
  expect(I(-infinity, infinity), I(-infinity, 2), -infinity, 2);
  expect(I(-infinity, infinity), I(1, infinity), 1, infinity);
  expect(I(-infinity, infinity), I(1, 2), 1, 2);
}

TEST(Bounders, take_the_zero_polynomial)
{
  Bounders::for_each<Exact, 2>([](auto bounder) {
    using B = typename decltype(bounder)::type;
    expect_range(B(Polynomial<Exact, 2>()).bound({Exact(-1, 2), Exact(0, 1)}), 0, 0, B::name);
  });
}

TEST(Enclose_range, contains_the_range_of_a_polynomial_in_one_line)
{
  const auto f = parse_polynomial<2>("x^2*y - x/3 + 1/7", {"x", "y"});
  const Rational_box<2> box{Rational_interval(-1, 1), Rational_interval(Rational(1, 3), Rational(2, 3))};
  const auto range = exact_range(f, box, Rational(1, 1000)).inner;
  const auto bound = enclose_range(f, box);
  EXPECT_TRUE(contains(bound, range.lower()) && contains(bound, range.upper()));
  EXPECT_FALSE(contains(bound, Rational(range.upper() + 3)));
  const auto exact = enclose_range<Bernstein_bounder<Rational_interval, 2>>(f, box);
  EXPECT_TRUE(exact.lower() <= range.lower() && range.upper() <= exact.upper());
}

} // namespace
