// SPDX-License-Identifier: LGPL-3.0-or-later
#include "exact_values.h"

#include <algebra/on_box.h>

#include <corral/polynomial/evaluate.h>

#include <gtest/gtest.h>

namespace {

using namespace corral;
using namespace corral::exact;

/// The one factor by which a form on a box is the polynomial there; 0 if there is none, or it is not positive.
template <std::size_t D>
Rational factor_to(const Bernstein_form<D>& form, const Polynomial<Integer, D>& f, const Rational_box<D>& box,
                   truth::Random_polynomials& random)
{
  Rational factor = 0;
  for (int k = 0; k < 8; ++k) {
    std::array<Rational, D> u;
    Rational_point<D> x;
    for (std::size_t axis = 0; axis < D; ++axis) {
      u[axis] = abs(random.rational()) / 101;
      x[axis] = box[axis].lower() + u[axis] * (box[axis].upper() - box[axis].lower());
    }
    const Rational expected = evaluate(truth::over_rationals(f), x);
    const Rational given = truth::value(form, u);
    if (expected == 0) {
      if (given != 0) return 0;
      continue;
    }
    const Rational seen = given / expected;
    if (seen <= 0 || (factor != 0 && seen != factor)) return 0;
    factor = seen;
  }
  return factor;
}

template <std::size_t D>
Rational_box<D> some_box(truth::Random_polynomials& random)
{
  Rational_box<D> box;
  for (auto& side : box) {
    const Rational lower = random.rational();
    side = Rational_interval(lower, Rational(lower + abs(random.rational()) + Rational(1, 7)));
  }
  return box;
}

template <std::size_t D>
void expect_values(unsigned seed)
{
  truth::Random_polynomials random(seed);
  for (unsigned degree = 1; degree <= 5; ++degree) {
    const auto f = random.dense<D>(degree, 60);
    const auto box = some_box<D>(random);
    auto form = bernstein_form(f, box);
    EXPECT_GT(factor_to(form, f, box, random), 0);
    for (std::size_t axis = 0; axis < D; ++axis) {
      auto upper = form;
      const auto lower = halve(upper, axis);
      const Rational middle = (box[axis].lower() + box[axis].upper()) / 2;
      auto half = box;
      half[axis] = Rational_interval(box[axis].lower(), middle);
      EXPECT_GT(factor_to(lower, f, half, random), 0);
      half[axis] = Rational_interval(middle, box[axis].upper());
      EXPECT_GT(factor_to(upper, f, half, random), 0);
      EXPECT_GT(factor_to(exact::derivative(form, axis), derivative(f, axis), box, random), 0);
    }
    // Negative control: one coefficient off by one.
    form.values[form.values.size() / 2] += 1;
    EXPECT_EQ(factor_to(form, f, box, random), 0);
  }
}

TEST(Bernstein_form, has_the_values_of_the_polynomial)
{
  expect_values<1>(1);
  expect_values<2>(2);
  expect_values<3>(3);
}

TEST(Bernstein_form, has_the_facets_of_the_polynomial)
{
  truth::Random_polynomials random(4);
  const auto f = random.dense<3>(4, 60);
  const auto form = bernstein_form(f, some_box<3>(random));
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const bool upper : {false, true}) {
      const auto side = facet(form, axis, upper);
      const std::array<Rational, 2> u{Rational(1, 3), Rational(2, 5)};
      std::array<Rational, 3> there;
      for (std::size_t k = 0, from = 0; k < 3; ++k) there[k] = k == axis ? Rational(upper ? 1 : 0) : u[from++];
      EXPECT_EQ(truth::value(side, u), truth::value(form, there));
    }
}

TEST(Bernstein_form, knows_signs_only_where_they_are_proved)
{
  const Rational_box<2> unit{Rational_interval(0, 1), Rational_interval(0, 1)};
  EXPECT_EQ(sign_pattern(bernstein_form(truth::plane("x^2 + y + 1"), unit)).closed(), 1);
  EXPECT_EQ(sign_pattern(bernstein_form(truth::plane("-x^2 - y - 1"), unit)).closed(), -1);
  EXPECT_TRUE(sign_pattern(bernstein_form(truth::plane("x - y"), unit)).crosses); // zero at a corner
  EXPECT_TRUE(one_sign_inside(bernstein_form(truth::plane("x + y"), unit)));
  EXPECT_EQ(sign_pattern(bernstein_form(truth::plane("x + y"), unit)).closed(), 0);
  EXPECT_EQ(sign_pattern(bernstein_form(truth::plane("(3*x - 1)^2 + (3*y - 1)^2 - 1/100"), unit)).closed(), 0);
}

} // namespace
