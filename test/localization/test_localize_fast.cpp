// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/audit/Trouble_source.h>
#include <corral/localization/localize.h>

#include "exact_cells.h"
#include "localization/fast/Root_seed.h"
#include "localization/fast/Subdivider.h"
#include "paper_polynomials.h"
#include "random_cases.h"
#include "rounds.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

namespace {

using namespace corral;
using test::for_each_cell;
using test::random_grid;
using test::random_polynomial;

/// The first wrong verdict among all cells of small random cases.
template <std::size_t D>
std::string find_wrong_verdict(std::uint64_t seed, int rounds, long most_cells)
{
  Trouble_source random(seed);
  for (int round = 0; round < rounds; ++round) {
    const auto f = random_polynomial<D>(random, static_cast<unsigned>(random.integer(1, 7)));
    const auto grid = random_grid<D>(random, most_cells);
    const auto cells = localize(f, grid);
    std::string wrong;
    for_each_cell<D>(grid.resolution(), [&](const Cell<D>& cell) {
      if (wrong.empty()) wrong = test::contradiction(f, grid, cell, cells.verdict(cell));
    });
    if (!wrong.empty()) return "round " + std::to_string(round) + ": " + wrong;
  }
  return "";
}

TEST(Localize_fast, agrees_with_exact_subdivision_in_the_plane)
{
  EXPECT_EQ(find_wrong_verdict<2>(1, test::rounds(150), 40), "");
}
TEST(Localize_fast, agrees_with_exact_subdivision_in_space)
{
  EXPECT_EQ(find_wrong_verdict<3>(2, test::rounds(60), 11), "");
}

/// The cells of the grid, all in one piece and looked at once.
template <std::size_t D>
Raster<D> run(const Polynomial<Rational, D>& f, const Grid<D>& grid, bool with_remainder)
{
  fast::Plan<D> plan(fast::Monomial_shape<D>(f), grid);
  plan.tells_hidden = plan.tells_rough = false;
  fast::Pulse pulse({});
  auto root = fast::root_seed(plan, f, grid, pulse);
  if (!with_remainder) {
    plan.rounding = fast::Rounding{};
    root.remainder = 0;
  }
  fast::Harvest<D> harvest;
  fast::make_subdivider(plan, pulse)->run(plan.root_level, {&root, 1}, 0, harvest);
  Raster_builder<D> cells;
  harvest.blocks.visit([&](const Cell_block<D>& block) { cells.append(block); });
  return std::move(cells).finish(grid, with_remainder);
}

/// \brief The first wrong verdict beside a grid point at which f is nearly zero.
///
/// There the sign of f is far below what doubles resolve: a verdict that neglects a rounding error is as good as a
/// coin.
template <std::size_t D>
std::string find_rounding_fault(std::uint64_t seed, int rounds, bool with_remainder)
{
  Trouble_source random(seed);
  for (int round = 0; round < rounds; ++round) {
    const auto grid = random_grid<D>(random, D == 2 ? 40 : 12);
    std::array<Rational, D> point;
    Cell<D> corner;
    for (std::size_t axis = 0; axis < D; ++axis) {
      corner[axis] = static_cast<std::uint32_t>(random.integer(0, grid.resolution()[axis]));
      point[axis] = grid.line(axis, corner[axis]);
    }
    auto f = random_polynomial<D>(random, static_cast<unsigned>(random.integer(1, 7)));
    Rational offset = -evaluate(f, point);
    Rational tiny = random.integer(-1, 1);
    mpq_div_2exp(tiny.get_mpq_t(), tiny.get_mpq_t(), static_cast<mp_bitcnt_t>(random.integer(60, 120)));
    f = f + constant<Rational, D>(offset + tiny);
    if (f.is_zero()) continue;
    const auto cells = run(f, grid, with_remainder);
    for (unsigned side = 0; side < (1U << D); ++side) {
      Cell<D> cell = corner;
      bool inside = true;
      for (std::size_t axis = 0; axis < D; ++axis) {
        cell[axis] -= side >> axis & 1;
        inside = inside && cell[axis] < grid.resolution()[axis];
      }
      if (!inside) continue;
      const auto wrong = test::contradiction(f, grid, cell, cells.verdict(cell));
      if (!wrong.empty()) return "round " + std::to_string(round) + ": " + wrong;
    }
  }
  return "";
}

TEST(Localize_fast, survives_values_below_the_rounding_errors)
{
  EXPECT_EQ(find_rounding_fault<2>(3, test::rounds(2000), true), "");
  EXPECT_EQ(find_rounding_fault<3>(4, test::rounds(300), true), "");
}
TEST(Localize_fast, a_remainder_left_out_is_found)
{
  EXPECT_NE(find_rounding_fault<2>(3, 2000, false), "");
  EXPECT_NE(find_rounding_fault<3>(4, 300, false), "");
}

TEST(Localize_fast, plots_no_more_cells_than_modified_affine_arithmetic)
{
  for (std::size_t k = 0; k < 10; ++k) {
    const auto curve = localize(test::paper_curve(k), test::paper_grid_2(256));
    EXPECT_LE(curve.plotted(), test::paper_curves[k].maa_cells) << test::paper_curves[k].text;
    const auto surface = localize(test::paper_surface(k), test::paper_grid_3(32));
    EXPECT_LE(surface.plotted(), test::paper_surfaces[k].maa_cells) << test::paper_surfaces[k].text;
  }
}

/// Cells of varied problems, large enough to be cut into tasks.
std::vector<Raster<2>> varied_results(const Run_options& options)
{
  std::vector<Raster<2>> results;
  for (const std::size_t k : {2U, 3U, 8U})
    results.push_back(localize(test::paper_curve(k), test::paper_grid_2(4096), options));
  Trouble_source random(6);
  for (int round = 0; round < 20; ++round)
    results.push_back(localize(random_polynomial<2>(random, 9), random_grid<2>(random, 3000), options));
  return results;
}

TEST(Localize_fast, does_not_depend_on_the_number_of_threads)
{
  const auto one = varied_results({});
  for (const unsigned threads : {0U, 2U, 5U}) {
    Run_options options;
    options.threads = threads;
    EXPECT_EQ(varied_results(options), one) << threads << " threads";
  }
  const auto grid = test::paper_grid_3(256);
  Run_options two;
  two.threads = 2;
  EXPECT_EQ(localize(test::paper_surface(4), grid), localize(test::paper_surface(4), grid, two));
}

std::vector<Raster<3>> all_surfaces()
{
  std::vector<Raster<3>> results;
  for (std::size_t k = 0; k < 10; ++k)
    for (const std::uint32_t n : {50U, 256U})
      results.push_back(localize(test::paper_surface(k), test::paper_grid_3(n)));
  return results;
}

TEST(Localize_fast, does_not_depend_on_the_instruction_set)
{
  const auto expected = varied_results({});
  const auto expected_surfaces = all_surfaces();
  for (std::int64_t rest = hwy::SupportedTargets(); rest != 0; rest &= rest - 1) {
    const std::int64_t target = rest & -rest;
    hwy::SetSupportedTargetsForTest(target);
    EXPECT_EQ(varied_results({}), expected) << hwy::TargetName(target);
    EXPECT_EQ(all_surfaces(), expected_surfaces) << hwy::TargetName(target);
    hwy::SetSupportedTargetsForTest(0);
  }
}

TEST(Localize_fast, is_exact_where_the_data_allow_it)
{
  const auto plane = localize(test::paper_surface(0), test::paper_grid_3(32));
  EXPECT_EQ(plane.plotted(), 1791U);
  EXPECT_EQ(plane.hit(), 1791U); // 511 of these only touch it with a corner
}

TEST(Localize_fast, takes_any_size_of_coefficients)
{
  const auto grid = test::paper_grid_2(64);
  const auto circle = parse_polynomial<2>("(x - 1/3)^2 + (y - 1/3)^2 - 1/16", {"x", "y"});
  const auto expected = localize(circle, grid);
  for (const int exponent : {-20000, -1074, 900, 30000}) {
    Rational factor = 1;
    if (exponent < 0)
      mpq_div_2exp(factor.get_mpq_t(), factor.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
    else
      mpq_mul_2exp(factor.get_mpq_t(), factor.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
    EXPECT_EQ(localize(constant<Rational, 2>(factor) * circle, grid), expected) << exponent;
  }
  Rational tiny = 1;
  mpq_div_2exp(tiny.get_mpq_t(), tiny.get_mpq_t(), 1200);
  const auto f = parse_polynomial<2>("x - y", {"x", "y"}) + constant<Rational, 2>(tiny); // misses every corner
  const auto cells = localize(f, grid);
  for_each_cell<2>(grid.resolution(), [&](const Cell<2>& cell) {
    EXPECT_EQ(test::contradiction(f, grid, cell, cells.verdict(cell)), "");
  });
}

TEST(Localize_fast, sees_past_the_rounding_errors_of_a_large_box)
{
  // The values reach 2^60 at the ends of the box, and 1 beside the curve.
  const Rational_interval side(-2, 2);
  const auto f = parse_polynomial<2>("x^60 + y^60 - 1", {"x", "y"});
  const Grid<2> grid({side, side}, {1024, 1024});
  const auto cells = localize(f, grid);
  EXPECT_GT(cells.hit(), 700U);
  EXPECT_LT(cells.plotted(), 5000U);
  Run_options two;
  two.threads = 2;
  EXPECT_EQ(localize(f, grid, two), cells);
  EXPECT_LE(localize(f, Grid<2>({side, side}, {256, 256})).plotted(), 1012U); // what MAA plots
  EXPECT_LE(localize(f, Grid<2>({side, side}, {16, 16})).plotted(), 220U);    // the same
  const Rational_interval unit(0, 1);                                         // of the curve y = x^60, 31 of 256 cells
  EXPECT_EQ(localize(parse_polynomial<2>("y - x^60", {"x", "y"}), Grid<2>({unit, unit}, {16, 16})).plotted(), 31U);
  const auto g = parse_polynomial<3>("x^40 + y^40 + z^40 - 1", {"x", "y", "z"});
  EXPECT_GT(localize(g, Grid<3>({side, side, side}, {96, 96, 96})).hit(), 1000U);
}

TEST(Localize_fast, needs_memory_for_the_plotted_cells_only)
{
  const auto cells = localize(test::paper_curve(0), test::paper_grid_2(65536)); // of 4.3 billion pixels
  EXPECT_GT(cells.hit(), 130000U);
  EXPECT_LT(cells.unknown(), 100U);
  EXPECT_LT(cells.blocks().size(), 20000U);
  const auto plane = localize(test::paper_surface(0), test::paper_grid_3(1024));
  EXPECT_LT(plane.blocks().size(), 150000U);
}

TEST(Localize_fast, proves_nearly_all_hits_by_floats_alone)
{
  for (std::size_t k = 0; k < 10; ++k)
    for (const std::uint32_t n : {256U, 1024U}) {
      const auto cells = localize(test::paper_curve(k), test::paper_grid_2(n));
      EXPECT_GE(cells.hit() * 100, cells.plotted() * 97) << test::paper_curves[k].text << " at " << n;
    }
  // The cells that truly hold a zero, counted by the exact decision.
  constexpr std::uint64_t hit_at_32[] = {1791, 3944, 3712, 3152, 1840, 2032, 4852, 6976, 1544, 3200};
  constexpr std::uint64_t hit_at_128[] = {28671, 62576, 58880, 50400, 27720, 32184, 81220, 112048, 24720, 50440};
  for (std::size_t k = 0; k < 10; ++k)
    for (const std::uint32_t n : {32U, 128U}) {
      const std::uint64_t ideal = n == 32 ? hit_at_32[k] : hit_at_128[k];
      const auto cells = localize(test::paper_surface(k), test::paper_grid_3(n));
      EXPECT_LE(cells.hit(), ideal) << test::paper_surfaces[k].text << " at " << n;
      EXPECT_GE(cells.hit() * 100, ideal * 97) << test::paper_surfaces[k].text << " at " << n;
      EXPECT_GE(cells.plotted(), ideal) << test::paper_surfaces[k].text << " at " << n;
    }
}

TEST(Localize_fast, refuses_what_it_cannot_do)
{
  const auto grid = test::paper_grid_2(4096);
  EXPECT_THROW((void)localize(Polynomial<Rational, 2>(), grid), Invalid_input);
  Run_options few;
  few.cell_budget = 1000;
  EXPECT_THROW((void)localize(test::paper_curve(0), grid, few), Budget_exceeded);
  const auto line = parse_polynomial<2>("y - 1/2", {"x", "y"}); // two rows, of 25 blocks
  few.cell_budget = 399;
  EXPECT_THROW((void)localize(line, test::paper_grid_2(200), few), Budget_exceeded);
  few.cell_budget = 400;
  EXPECT_EQ(localize(line, test::paper_grid_2(200), few).plotted(), 400U);
}

TEST(Localize_fast, knows_constants)
{
  const auto grid = test::paper_grid_2(100);
  EXPECT_EQ(localize(constant<Rational, 2>(Rational(-1, 7)), grid).plotted(), 0U);
  const auto line = localize(parse_polynomial<2>("y - 1/2", {"x", "y"}), grid);
  EXPECT_EQ(line.plotted(), 200U);
}

} // namespace
