// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/bounders/Modified_affine_bounder.h>
#include <corral/bounders/Recursive_taylor_bounder.h>
#include <corral/number/Counted.h>
#include <corral/number/Rational_interval.h>
#include <corral/polynomial/evaluate.h>
#include <corral/polynomial/parse.h>

#include <gtest/gtest.h>

namespace {

using namespace corral;
using I = Rational_interval;

Polynomial<I, 2> curve(const char* text)
{
  return transform<I>(parse_polynomial<2>(text, {"x", "y"}), [](const Rational& c) { return I(c); });
}

bool equal(const I& a, const I& b) { return a.lower() == b.lower() && a.upper() == b.upper(); }

const char* const curves[] = {"x^9 - x^7*y + 3*x^2*y^6 - y^3 + y^5 + y^4*x - 4*y^4*x^3", "x^3*y^2 - x*y/3 + 5/7",
                              "y^4 - x^3 + x*y", "2*x - 3*y + 1", "7"};

TEST(Recursive_taylor, is_the_modified_affine_bound_above_the_degree)
{
  for (const char* const text : curves)
    for (const auto& box : {Box<I, 2>{I(-1, 2), I(Rational(1, 3), Rational(7, 2))}, Box<I, 2>{I(0, 1), I(2)}}) {
      const auto f = curve(text);
      const I direct = Recursive_taylor_bounder<I, 2>(f, {.order = 12}).bound(box);
      EXPECT_TRUE(equal(direct, Modified_affine_bounder<I, 2>(f).bound(box))) << text;
    }
}

TEST(Recursive_taylor, differs_from_the_modified_affine_bound_below_the_degree) // or the test above could not fail
{
  const auto f = curve(curves[0]);
  const Box<I, 2> box{I(0, 1), I(0, 1)};
  EXPECT_FALSE(equal(Recursive_taylor_bounder<I, 2>(f).bound(box), Modified_affine_bounder<I, 2>(f).bound(box)));
}

// The paper's Figure 2, written down as it stands: nothing shared, nothing scaled.
I bound_by_figure_2(const Polynomial<I, 2>& f, const Box<I, 2>& box)
{
  if (f.is_zero()) return I(0);
  if (f.is_constant()) return f.terms()[0].coefficient;
  const std::array<I, 2> c{midpoint(box[0]), midpoint(box[1])};
  const I half(Rational(1, 2));
  const I x1 = radius(box[0], c[0]);
  const I y1 = radius(box[1], c[1]);
  const auto fx = derivative(f, 0);
  const auto fy = derivative(f, 1);
  return evaluate(f, c) + x1 * evaluate(fx, c) * I(-1, 1) + y1 * evaluate(fy, c) * I(-1, 1)
         + half * x1 * x1 * I(0, 1) * bound_by_figure_2(derivative(fx, 0), box)
         + half * y1 * y1 * I(0, 1) * bound_by_figure_2(derivative(fy, 1), box)
         + x1 * y1 * I(-1, 1) * bound_by_figure_2(derivative(fx, 1), box);
}

TEST(Recursive_taylor, of_order_2_is_the_algorithm_of_the_paper)
{
  for (const char* const text : curves) {
    const Box<I, 2> box{I(Rational(-1, 4), Rational(3, 5)), I(Rational(1, 7), 2)};
    EXPECT_TRUE(equal(Recursive_taylor_bounder<I, 2>(curve(text)).bound(box), bound_by_figure_2(curve(text), box)))
        << text;
  }
}

// Why there is no option to stop at linear polynomials: doc/decisions/linear_polynomials.md.
TEST(Recursive_taylor, stops_at_linear_polynomials)
{
  const Box<I, 2> box{I(Rational(-1, 4), Rational(3, 5)), I(Rational(1, 7), 2)};
  const I range = I(2) * box[0] - I(3) * box[1] + I(1); // each variable once, hence exact
  using N = Counted<I>;
  const auto f =
      transform<N>(parse_polynomial<2>("2*x - 3*y + 1", {"x", "y"}), [](const Rational& c) { return enclose<N>(c); });
  const Box<N, 2> counted_box{N(box[0]), N(box[1])};
  Operation_counts fewest;
  for (unsigned order = 1; order <= 4; ++order) {
    const Recursive_taylor_bounder<N, 2> bounder(f, {.order = order});
    const Counting_scope counting;
    EXPECT_TRUE(equal(bounder.bound(counted_box).value(), range)) << order;
    if (order == 1) fewest = counting.counts();
    EXPECT_EQ(counting.counts(), fewest) << order;
  }
}

TEST(Recursive_taylor, refuses_order_zero)
{
  EXPECT_THROW((Recursive_taylor_bounder<I, 2>(curve("x"), {.order = 0})), Invalid_input);
}

} // namespace
