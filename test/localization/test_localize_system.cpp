// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/audit/Trouble_source.h>
#include <corral/errors.h>
#include <corral/localization/localize.h>
#include <corral/polynomial/evaluate.h>
#include <corral/polynomial/parse.h>

#include "exact_cells.h"
#include "paper_polynomials.h"
#include "random_cases.h"
#include "rounds.h"
#include "stopped_rasters.h"
#include "stopping_run.h"

#include <gtest/gtest.h>

#include <algorithm>

/// \file
/// Systems of random surfaces through a known point: no cell with that point may be lost, and hardly any cell may be
/// plotted that one surface alone excludes.
namespace {

using namespace corral;
using test::random_grid;
using test::random_polynomial;

template <std::size_t D>
using System = std::vector<Polynomial<Rational, D>>;
template <std::size_t D>
using Point = std::array<Rational, D>;

/// A system, a grid and a common zero in the box, on grid lines now and then.
template <std::size_t D>
struct Case
{
  Grid<D> grid;
  Point<D> zero;
  System<D> system;
};

template <std::size_t D>
Case<D> random_case(Trouble_source& random, unsigned degree, long most_cells)
{
  Case<D> result{random_grid<D>(random, most_cells), {}, {}};
  for (std::size_t axis = 0; axis < D; ++axis) {
    const auto line = static_cast<std::uint32_t>(random.integer(0, result.grid.resolution()[axis] - 1));
    result.zero[axis] = result.grid.line(axis, line);
    if (random.integer(0, 2) > 0) result.zero[axis] += result.grid.step(axis) * random.integer(0, 99) / 100;
  }
  for (long count = random.integer(2, 4); count > 0; --count) {
    const auto f = random_polynomial<D>(random, degree);
    const auto through = f - constant<Rational, D>(evaluate(f, result.zero));
    result.system.push_back(through.is_zero() ? variable<Rational, D>(0) - constant<Rational, D>(result.zero[0])
                                              : through);
  }
  return result;
}

/// How many cells of `a` are not in `b`.
template <std::size_t D>
std::uint64_t more(const Raster<D>& a, const Raster<D>& b)
{
  std::uint64_t count = 0;
  for (const auto& [cell, verdict] : a) count += b.verdict(cell) == Verdict::empty ? 1U : 0U;
  return count;
}

/// What each polynomial alone leaves.
template <std::size_t D>
Raster<D> intersection(const System<D>& system, const Grid<D>& grid)
{
  std::vector<Raster<D>> all;
  for (const auto& f : system) all.push_back(localize(f, grid));
  Raster_builder<D> result;
  all[0].for_each_visited([&](const Cell<D>& cell, Verdict) {
    if (std::ranges::all_of(all, [&](const auto& cells) { return cells.verdict(cell) != Verdict::empty; }))
      result.append(cell, Verdict::unknown);
  });
  return std::move(result).finish(grid, true);
}

struct Sums
{
  std::size_t lost = 0; ///< cells with the common zero that are not plotted
  std::uint64_t hits = 0;
  std::uint64_t plotted = 0;
  std::uint64_t only_together = 0;   ///< cells plotted that one polynomial alone excludes
  std::uint64_t only_one_by_one = 0; ///< the opposite
};

/// \param moved  added to the first polynomial, so that it misses the zero.
template <std::size_t D>
Sums sums(std::uint64_t seed, int rounds, long most_degree, long most_cells, const Rational& moved = 0)
{
  Trouble_source random(seed);
  Sums result;
  for (int round = 0; round < rounds; ++round) {
    auto c = random_case<D>(random, static_cast<unsigned>(random.integer(1, most_degree)), most_cells);
    c.system[0] = c.system[0] + constant<Rational, D>(moved);
    const auto cells = localize(c.system, c.grid);
    const auto one_by_one = intersection(c.system, c.grid);
    result.lost += test::lost_cells(cells, c.grid, c.zero);
    result.hits += cells.hit();
    result.plotted += cells.plotted();
    result.only_together += more(cells, one_by_one);
    result.only_one_by_one += more(one_by_one, cells);
  }
  return result;
}

// The two ways cut terms off at different nodes, which may cost one of them a cell.
void expect_good(const Sums& sums)
{
  EXPECT_EQ(sums.lost, 0U);
  EXPECT_EQ(sums.hits, 0U);
  EXPECT_GT(sums.plotted, 100U);
  EXPECT_LE(sums.only_together * 1000, sums.plotted);
  EXPECT_LE(sums.only_one_by_one * 1000, sums.plotted);
}

TEST(Localize_system, keeps_the_common_zeros_in_the_plane) { expect_good(sums<2>(11, test::rounds(300), 9, 200)); }
TEST(Localize_system, keeps_the_common_zeros_in_space) { expect_good(sums<3>(12, test::rounds(200), 6, 40)); }
TEST(Localize_system, keeps_the_common_zeros_of_high_degree_in_the_plane)
{
  expect_good(sums<2>(13, test::rounds(15), 45, 300));
}
TEST(Localize_system, keeps_the_common_zeros_of_high_degree_in_space)
{
  expect_good(sums<3>(14, test::rounds(50), 14, 50));
}

// Negative control: polynomials that miss the zero by little are seen to do so.
TEST(Localize_system, loses_points_that_are_no_zeros)
{
  EXPECT_GT((sums<2>(11, 100, 9, 200, Rational(1, 8)).lost), 0U);
  EXPECT_GT((sums<3>(12, 100, 6, 40, Rational(1, 8)).lost), 0U);
}

System<3> viviani()
{
  return {parse_polynomial<3>("x^2 + y^2 + z^2 - 4", {"x", "y", "z"}),
          parse_polynomial<3>("(x - 1)^2 + y^2 - 1", {"x", "y", "z"})};
}

template <std::size_t D>
Grid<D> cube(int half_side, const Resolution<D>& resolution)
{
  Rational_box<D> box;
  box.fill(Rational_interval(-half_side, half_side));
  return {box, resolution};
}

TEST(Localize_system, costs_what_the_curve_costs)
{
  const auto found = localize(viviani(), cube<3>(2, {4096, 4096, 4096})); // 69 billion cells, a surface of 80 million
  EXPECT_LT(found.plotted(), 75000U);
  EXPECT_LT(found.counters().bounds, 4 * found.plotted());
  const auto twice = localize(viviani(), cube<3>(2, {8192, 8192, 8192}));
  EXPECT_LT(twice.counters().bounds * 10, 23 * found.counters().bounds);
}

TEST(Localize_system, finds_points_on_the_finest_grids)
{
  const System<2> circle_and_parabola{parse_polynomial<2>("x^2 + y^2 - 2", {"x", "y"}),
                                      parse_polynomial<2>("y - x^2", {"x", "y"})}; // they meet at (-1, 1) and (1, 1)
  for (const auto& [x, y] : {Resolution<2>{1U << 20, 1U << 20}, {1U << 30, 1U << 30}, {1'000'003, 700'001}, {2, 3}}) {
    const auto grid = cube<2>(2, {x, y});
    const auto found = localize(circle_and_parabola, grid);
    for (const int side : {-1, 1}) EXPECT_EQ(test::lost_cells(found, grid, {Rational(side), Rational(1)}), 0U);
    EXPECT_LE(found.plotted(), 16U) << x << " " << y;
    EXPECT_LE(found.counters().bounds, 2000U) << x << " " << y;
  }
}

TEST(Localize_system, sees_past_the_rounding_errors_of_a_large_box)
{
  const System<2> system{parse_polynomial<2>("x^60 + y^60 - 1", {"x", "y"}), parse_polynomial<2>("x*y", {"x", "y"})};
  const auto grid = cube<2>(2, {1024, 1024});
  const auto cells = localize(system, grid);
  for (const int side : {-1, 1}) {
    EXPECT_EQ(test::lost_cells(cells, grid, {Rational(side), Rational(0)}), 0U);
    EXPECT_EQ(test::lost_cells(cells, grid, {Rational(0), Rational(side)}), 0U);
  }
  EXPECT_LE(cells.plotted(), 64U);
}

template <std::size_t D>
std::vector<Raster<D>> varied_results(const Run_options& options)
{
  std::vector<Raster<D>> results;
  Trouble_source random(15);
  for (int round = 0; round < 30; ++round) {
    const auto c = random_case<D>(random, D == 2 ? 25 : 8, D == 2 ? 3000 : 300);
    results.push_back(localize(c.system, c.grid, options));
  }
  return results;
}

TEST(Localize_system, does_not_depend_on_the_number_of_threads)
{
  const auto grid = cube<3>(2, {4096, 3000, 5000});
  const auto one = localize(viviani(), grid);
  for (const unsigned threads : {0U, 2U}) {
    Run_options options;
    options.threads = threads;
    EXPECT_EQ(localize(viviani(), grid, options), one) << threads << " threads";
    EXPECT_EQ(varied_results<2>(options), varied_results<2>({})) << threads << " threads";
    EXPECT_EQ(varied_results<3>(options), varied_results<3>({})) << threads << " threads";
  }
}

TEST(Localize_system, tells_how_far_it_is_and_stops)
{
  const auto grid = cube<3>(2, {2000, 2000, 2000});
  for (const unsigned threads : {1U, 2U}) {
    double done = 0;
    int calls = 0;
    Run_options options;
    options.threads = threads;
    options.progress = [&](double part) {
      EXPECT_LE(done, part);
      EXPECT_LE(part, 1);
      done = part;
      ++calls;
    };
    const auto cells = localize(viviani(), grid, options);
    EXPECT_GT(done, 0.999);
    EXPECT_GT(calls, 100);
    auto stopped = test::stopping_at(static_cast<std::uint64_t>(calls / 2));
    stopped.threads = threads;
    const auto half = localize(viviani(), grid, stopped);
    EXPECT_EQ(test::doubts_of_stopped(half, cells), "");
    EXPECT_LT(static_cast<double>(half.unvisited_cells()), grid.cell_count());
    options.progress = {};
    options.cell_budget = cells.plotted() - 1;
    EXPECT_THROW((void)localize(viviani(), grid, options), Budget_exceeded);
    options.cell_budget = cells.plotted();
    EXPECT_EQ(localize(viviani(), grid, options), cells);
  }
}

TEST(Localize_system, takes_any_number_of_polynomials)
{
  const auto grid = test::paper_grid_2(512);
  const auto curve = test::paper_curve(2);
  EXPECT_THROW((void)localize(System<2>(), grid), Invalid_input);
  EXPECT_THROW((void)localize(System<2>{curve, Polynomial<Rational, 2>()}, grid), Invalid_input);
  const auto alone = localize(curve, grid);
  EXPECT_EQ(localize(System<2>{curve}, grid), alone);
  const auto twice = localize(System<2>{curve, curve}, grid);
  EXPECT_LE(more(twice, alone) + more(alone, twice), 2U);
  EXPECT_EQ(twice.hit(), 0U);
  const System<2> many(9, curve);
  EXPECT_EQ(localize(many, grid), twice);
  EXPECT_EQ(localize(System<2>{curve, constant<Rational, 2>(3)}, grid).plotted(), 0U);
}

} // namespace
