// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/audit/Trouble_source.h>
#include <corral/localization/localize.h>
#include <corral/number/Environment.h>
#include <corral/polynomial/evaluate.h>
#include <corral/polynomial/parse.h>

#include "exact_cells.h"
#include "localization/fast/Term_bounds.h"
#include "localization/fast/Term_form.h"
#include "random_cases.h"
#include "rounds.h"

#include <gtest/gtest.h>

#include <algorithm>

/// \file
/// Polynomials of high degree with few terms, which the fast engine bounds by their terms.
namespace {

using namespace corral;
using fast::Term_bounds;
using fast::Term_form;
using test::random_grid;

/// A few terms with coefficients of 1 to 2 in absolute value that fill the mantissa.
template <std::size_t D>
Polynomial<Rational, D> sparse_polynomial(Trouble_source& random, long most_degree)
{
  std::vector<typename Polynomial<Rational, D>::Term> terms;
  for (long count = random.integer(2, 6); count > 0; --count) {
    Exponents<D> exponents;
    for (auto& e : exponents) e = static_cast<std::uint16_t>(random.chance(4) ? 0 : random.integer(1, most_degree));
    Rational size(random.integer(1L << 52, (1L << 53) - 1), 1L << 52);
    size.canonicalize();
    terms.push_back({exponents, random.chance(2) ? size : Rational(-size)});
  }
  return collect<Rational, D>(std::move(terms));
}

template <std::size_t D>
std::array<Rational, D> random_point(Trouble_source& random)
{
  std::array<Rational, D> point;
  for (auto& x : point) x = Rational(random.integer(-64, 64), 64);
  return point;
}

template <std::size_t D>
Rational value_of(const fast::Low_form<D>& form, const std::vector<Exponents<D>>& orders,
                  const std::array<Rational, D>& point)
{
  Rational sum = 0;
  for (std::size_t k = 0; k < orders.size(); ++k) {
    Rational product = form.coefficients[k];
    for (std::size_t axis = 0; axis < D; ++axis)
      for (unsigned e = 0; e < orders[k][axis]; ++e) product *= point[axis];
    sum += product;
  }
  return sum;
}

struct Faults
{
  int forms = 0;     ///< values beyond the remainder of a form of low degree
  int too_small = 0; ///< the same for a 2^-10 of the remainder
  int signs = 0;     ///< values of the sign that a bound excludes
  int checked = 0;
};

template <std::size_t D>
Faults find_faults(std::uint64_t seed, int rounds)
{
  const Nearest_scope environment;
  Trouble_source random(seed);
  Faults faults;
  for (int round = 0; round < rounds; ++round) {
    const auto f = sparse_polynomial<D>(random, 30);
    const auto is_unscaled = [](const auto& term) { return abs(term.coefficient) >= 1 && abs(term.coefficient) < 2; };
    if (!std::ranges::all_of(f.terms(), is_unscaled)) continue; // since the form is of f times a power of two
    const auto grid = random_grid<D>(random, 1000);
    const Subdivision_tree<D> tree(grid.resolution());
    const auto orders = Term_form<D>::model_monomials();
    const Term_form<D> form(f, orders);
    const fast::Grid_lines<D> lines(grid);
    Term_bounds<D> bounds(form, lines, tree);
    auto node = tree.root();
    while (node.level > 0 && !random.chance(6)) node = tree.child(node, random.integer(0, 1) != 0 ? 0 : 1);
    const auto low = bounds.low_form(node);
    const bool is_excluded = bounds.excludes_zero(node) || low.excludes_zero();
    int sign = 0;
    for (int k = 0; k < 8; ++k) {
      const auto u = random_point<D>(random);
      std::array<Rational, D> x;
      for (std::size_t axis = 0; axis < D; ++axis)
        x[axis] = grid.box()[axis].lower()
                  + grid.step(axis) * (node.corner[axis] + tree.span(node.level, axis) * (u[axis] + 1) / 2);
      const Rational value = evaluate(f, x);
      const Rational error = abs(value - value_of(low, orders, u));
      faults.forms += error > Rational(low.remainder) ? 1 : 0;
      faults.too_small += error * 1024 > Rational(low.remainder) ? 1 : 0;
      if (is_excluded && (sgn(value) == 0 || sgn(value) == -sign)) ++faults.signs;
      sign = sgn(value);
      ++faults.checked;
    }
  }
  return faults;
}

template <std::size_t D>
void expect_none(const Faults& faults)
{
  EXPECT_GT(faults.checked, 1000);
  EXPECT_EQ(faults.forms, 0);
  EXPECT_EQ(faults.signs, 0);
  EXPECT_GT(faults.too_small, 50); // negative control: the remainder is not idle
}

TEST(Term_bounds, contain_the_values_in_the_plane) { expect_none<2>(find_faults<2>(21, test::rounds(600))); }
TEST(Term_bounds, contain_the_values_in_space) { expect_none<3>(find_faults<3>(22, test::rounds(600))); }

struct Errors
{
  std::size_t lost = 0; ///< cells with a known zero that are not plotted
  std::string wrong;    ///< the first verdict that is not true
  std::uint64_t plotted = 0;
  int by_terms = 0; ///< cases that the terms decide
};

/// \param looks  the number of cells near the zero whose verdict is compared with exact subdivision.
/// \param moved  added, so that the polynomial misses the zero.
template <std::size_t D>
Errors errors(std::uint64_t seed, int rounds, long most_degree, long most_cells, int looks, const Rational& moved = 0)
{
  Trouble_source random(seed);
  Errors result;
  for (int round = 0; round < rounds; ++round) {
    const auto grid = random_grid<D>(random, most_cells);
    std::array<Rational, D> zero;
    Cell<D> near;
    for (std::size_t axis = 0; axis < D; ++axis) {
      near[axis] = static_cast<std::uint32_t>(random.integer(0, grid.resolution()[axis] - 1));
      zero[axis] = grid.line(axis, near[axis]) + grid.step(axis) * Rational(random.integer(0, 8), 8);
    }
    auto f = sparse_polynomial<D>(random, most_degree);
    f = f - constant<Rational, D>(evaluate(f, zero) + moved);
    if (f.is_zero()) continue;
    const auto cells = localize(f, grid);
    result.lost += test::lost_cells(cells, grid, zero);
    result.plotted += cells.plotted();
    result.by_terms += Term_form<D>::suits(f, grid) ? 1 : 0;
    for (int k = 0; k < looks && result.wrong.empty(); ++k) {
      for (std::size_t axis = 0; axis < D; ++axis) {
        const long at = long{near[axis]} + random.integer(-2, 2);
        near[axis] = static_cast<std::uint32_t>(std::clamp(at, 0L, long{grid.resolution()[axis]} - 1));
      }
      result.wrong = test::contradiction(f, grid, near, cells.verdict(near));
    }
  }
  return result;
}

void expect_right(const Errors& errors, int least_by_terms)
{
  EXPECT_EQ(errors.lost, 0U);
  EXPECT_EQ(errors.wrong, "");
  EXPECT_GT(errors.plotted, 0U);
  EXPECT_GE(errors.by_terms, least_by_terms);
}

TEST(Localize_terms, is_right_in_the_plane) { expect_right(errors<2>(23, test::rounds(100), 16, 40, 8), 20); }
TEST(Localize_terms, is_right_in_space) { expect_right(errors<3>(24, test::rounds(40), 6, 9, 3), 8); }

TEST(Localize_terms, keeps_the_zeros_of_fine_grids)
{
  expect_right(errors<2>(25, test::rounds(60), 45, 3000, 0), 10);
  expect_right(errors<3>(26, test::rounds(20), 20, 80, 0), 3);
}

// Negative control: polynomials that miss the zero by little are seen to do so.
TEST(Localize_terms, loses_points_that_are_no_zeros)
{
  EXPECT_GT((errors<2>(23, 200, 16, 40, 0, Rational(1, 8)).lost), 0U);
  EXPECT_GT((errors<3>(24, 100, 7, 9, 0, Rational(1, 8)).lost), 0U);
}

template <std::size_t D>
Grid<D> cube(int half_side, std::uint32_t cells)
{
  Rational_box<D> box;
  box.fill(Rational_interval(-half_side, half_side));
  Resolution<D> resolution;
  resolution.fill(cells);
  return {box, resolution};
}

// What the natural interval extension plots, with the signs at corners, and hits.
TEST(Localize_terms, is_no_worse_than_natural_intervals)
{
  struct Row
  {
    const char* text;
    std::uint32_t cells;
    std::uint64_t plotted;
    std::uint64_t hit;
  };
  for (const auto& [text, n, plotted, hit] : {Row{"x^60 + y^60 - 1", 4, 12, 12},
                                              {"x^60 + y^60 - 1", 16, 44, 32},
                                              {"x^60 + y^60 - 1", 256, 652, 384},
                                              {"x^30 + y^30 - 1", 8, 20, 20},
                                              {"(x^30 - y^31)^2 + x^7*y^9", 16, 64, 29},
                                              {"(x^30 - y^31)^2 + x^7*y^9", 256, 1579, 526}}) {
    const auto cells = localize(parse_polynomial<2>(text, {"x", "y"}), cube<2>(2, n));
    EXPECT_LE(cells.plotted(), plotted) << text << " at " << n;
    EXPECT_GE(cells.hit(), hit) << text << " at " << n;
  }
  const auto f = parse_polynomial<3>("x^31*y^22*z^10*914144 + 356205*x^28*y^32*z^33 - 223716*x^16*y^32*z^2"
                                     " - 963382*x^5*y^8*z^11 + 924571*x^6*y^12*z^15 - 1",
                                     {"x", "y", "z"});
  const auto found = localize(f, cube<3>(2, 33));
  EXPECT_LE(found.plotted(), 12986U);
  EXPECT_GE(found.hit(), 5136U);
  EXPECT_LE(found.counters().bounds, 30000U);
}

TEST(Localize_terms, takes_degrees_of_which_no_dense_form_fits_in_memory)
{
  const auto f = parse_polynomial<3>("x^300*y^300*z^300 - x + y^7 - 1/3", {"x", "y", "z"});
  EXPECT_GT(localize(f, cube<3>(1, 64)).hit(), 4000U);
}

TEST(Localize_terms, does_not_depend_on_the_number_of_threads)
{
  const auto f = parse_polynomial<2>("(x^30 - y^31)^2 + x^7*y^9", {"x", "y"});
  const auto g = parse_polynomial<2>("x^60 + y^60 - 1", {"x", "y"});
  const auto line = parse_polynomial<2>("x - 2*y + 1/3", {"x", "y"});
  Run_options two;
  two.threads = 2;
  for (const std::uint32_t n : {100U, 1000U}) {
    const auto grid = cube<2>(2, n);
    for (const auto& system : {std::vector{f}, std::vector{g}, std::vector{f, line}, std::vector{line, g}})
      EXPECT_EQ(localize(system, grid, two), localize(system, grid)) << n;
  }
}

} // namespace
