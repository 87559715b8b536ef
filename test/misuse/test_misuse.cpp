// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/algebra/real_roots.h>
#include <corral/bounders/all.h>
#include <corral/certificate/certificate.h>
#include <corral/decision/ideal_system.h>
#include <corral/errors.h>
#include <corral/localization/localize.h>
#include <corral/localization/localize_with_bounder.h>
#include <corral/number/Outward_interval.h>
#include <corral/number/format.h>
#include <corral/polynomial/cgal_polynomial.h>
#include <corral/polynomial/parse.h>

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>

namespace {

using namespace corral;

/// Whether an action is refused as invalid input, in one line that has these words.
::testing::AssertionResult refuses(const std::string& words, const std::function<void()>& action)
{
  try {
    action();
  } catch (const Invalid_input& error) {
    const std::string text = error.what();
    if (text.find('\n') == std::string::npos && text.find(words) != std::string::npos)
      return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << "refused otherwise: " << text;
  }
  return ::testing::AssertionFailure() << "not refused";
}

const Grid<2>& grid64()
{
  static const Grid<2> grid({Rational_interval(-2, 2), Rational_interval(-2, 2)}, {64, 64});
  return grid;
}

Polynomial<Rational, 2> circle() { return parse_polynomial<2>("x^2 + y^2 - 1", {"x", "y"}); }

TEST(Misuse, terms_out_of_order_are_no_polynomial)
{
  using P = Polynomial<Rational, 2>;
  std::vector<P::Term> terms = {{{2, 0}, 1}, {{0, 0}, -1}, {{0, 2}, 1}};
  EXPECT_TRUE(refuses("order", [&] { (void)P(terms); }));
  EXPECT_TRUE(refuses("twice", [] { (void)P({{{1, 0}, 1}, {{1, 0}, 1}}); }));
  EXPECT_TRUE(refuses("coefficient 0", [] { (void)P({{{1, 0}, 0}}); }));
  EXPECT_TRUE(refuses("axis", [] { (void)variable<Rational, 2>(2); }));
  const auto sorted = collect<Rational, 2>(std::move(terms));
  EXPECT_EQ(sorted, circle());
  EXPECT_EQ(localize(sorted, grid64()), localize(circle(), grid64()));
}

// A raster knows its grid, so that its cells cannot be taken for those of another one.
TEST(Misuse, cells_of_another_grid_are_refused)
{
  const auto f = circle();
  const Grid<2> moved({Rational_interval(-1, 3), Rational_interval(-2, 2)}, {64, 64});
  for (const auto& cells : {localize(f, moved), localize<Modified_affine_bounder<Outward_interval, 2>>(f, moved)}) {
    const auto ideal = ideal_raster(f, cells).raster;
    EXPECT_EQ(ideal.grid(), moved);
    EXPECT_EQ(ideal.unknown(), 0U);
  }
  Raster_builder<2> by_hand;
  by_hand.append({64, 3}, Verdict::unknown);
  EXPECT_TRUE(refuses("(64, 3)", [&] { (void)std::move(by_hand).finish(grid64(), true); }));
  EXPECT_TRUE(refuses("(1000, 1000)", [&] { (void)localize(f, grid64()).verdict({1000, 1000}); }));
}

TEST(Misuse, cells_outside_of_the_grid_are_refused)
{
  Cell_decider<2> decider(circle(), grid64());
  EXPECT_TRUE(refuses("(1000, 1000)", [&] { (void)decider.decide({1000, 1000}); }));
  EXPECT_TRUE(refuses("64 x 64", [&] { (void)decider.decide({0, 64}); }));
  EXPECT_EQ(decider.decide({63, 63}).verdict, Verdict::empty);
  System_decider<2> system({circle(), circle()}, grid64());
  EXPECT_TRUE(refuses("(1000, 1000)", [&] { (void)system.decide({1000, 1000}); }));
}

TEST(Misuse, of_a_set_of_cells)
{
  Raster_builder<2> cells;
  EXPECT_TRUE(refuses("empty cell", [&] { cells.append({1, 1}, Verdict::empty); }));
  EXPECT_TRUE(refuses("block", [&] { cells.append({{0, 0}, 0, 0}); }));
  EXPECT_TRUE(refuses("block", [&] { cells.append({{0, 0}, 1, 2}); }));
  EXPECT_TRUE(refuses("block", [&] { cells.append(std::vector<Cell_block<2>>{{{0, 0}, 1, 1}, {{0, 1}, 0, 0}}); }));
  cells.append({9, 1}, Verdict::unknown);
  cells.append({0, 0}, Verdict::hit);
  cells.append({9, 1}, Verdict::hit); // again, in a block that is not the last
  cells.append({9, 2}, Verdict::unknown);
  const auto raster = std::move(cells).finish(grid64(), true);
  EXPECT_EQ(raster.blocks().size(), 2U);
  EXPECT_EQ(raster.plotted(), 3U);
  EXPECT_EQ(raster.verdict({9, 1}), Verdict::hit);
  EXPECT_EQ(raster.verdict({9, 2}), Verdict::unknown);
}

TEST(Misuse, of_the_loop_over_bounders)
{
  using B = Modified_affine_bounder<Outward_interval, 2>;
  const Polynomial<Outward_interval, 2> f({{{1, 0}, 1}});
  EXPECT_TRUE(refuses("1 bounder for 2 polynomials", [&] { Bounder_form<B>({f, f}, {B(f)}, grid64(), {}, {}); }));
  EXPECT_TRUE(refuses("before", [&] { (void)Bounder_form<B>({f}, {B(f)}, grid64(), {}, {}).take(); }));
}

TEST(Misuse, of_texts_and_conversions)
{
  EXPECT_TRUE(refuses("power of two", [] { (void)to_hex_float(Rational(1, 3)); }));
  EXPECT_TRUE(refuses("0 digits", [] { (void)decimal_below(Rational(1, 3), 0); }));
  EXPECT_TRUE(refuses("0 digits", [] { (void)decimal_text(Outward_interval(1), 0); }));
  using Cgal = Cgal_polynomial<Rational, 1>;
  CGAL::Polynomial_traits_d<Cgal>::Construct_polynomial construct;
  const std::vector<std::pair<CGAL::Exponent_vector, Rational>> high = {{CGAL::Exponent_vector(65536), Rational(1)}};
  EXPECT_TRUE(refuses("65535", [&] { (void)from_cgal<Rational, 1>(construct(high.begin(), high.end())); }));
}

TEST(Misuse, of_integer_polynomials_and_roots)
{
  const Integer_polynomial zero;
  const Integer_polynomial p = {-2, 0, 1};
  const auto shared = std::make_shared<const Integer_polynomial>(p);
  EXPECT_EQ((Integer_polynomial{-2, 0, 1, 0, 0}), p); // vanishing leading coefficients are dropped
  EXPECT_EQ(primitive_part(Integer_polynomial{4, 0, -2}), (Integer_polynomial{2, 0, -1})); // as in several variables
  EXPECT_EQ(normalized(Integer_polynomial{4, 0, -2}), p);
  EXPECT_EQ(greatest_common_divisor(zero, zero), zero);
  EXPECT_TRUE(refuses("divide", [&] { (void)exact_quotient(p, {0, 1}); }));
  EXPECT_TRUE(refuses("zero", [&] { (void)exact_quotient(p, zero); }));
  EXPECT_TRUE(refuses("zero", [&] { (void)divides(zero, p); }));
  EXPECT_TRUE(refuses("zero", [&] { (void)square_free_part(zero); }));
  EXPECT_TRUE(refuses("zero", [&] { (void)square_free_decomposition(zero); }));
  EXPECT_TRUE(refuses("zero", [&] { (void)root_bound(zero); }));
  EXPECT_TRUE(refuses("zero", [&] { (void)bernstein_coefficients(zero); }));
  EXPECT_TRUE(refuses("zero", [] {
    (void)isolate_simple_roots(std::make_shared<const Integer_polynomial>(), Rational_interval(0, 1));
  }));
  EXPECT_TRUE(refuses("positive", [&] { (void)compose_affine(p, 0, 0); }));
  EXPECT_TRUE(refuses("opposite signs", [&] { (void)Real_root(shared, {-2, 2}, 1); }));
  EXPECT_TRUE(refuses("positive", [&] { Real_root(shared, {1, 2}, 1).refine_to(0); }));
}

} // namespace
