// SPDX-License-Identifier: LGPL-3.0-or-later
#include "exact_cells.h"
#include "stopped_rasters.h"
#include "stopping_run.h"

#include <corral/bounders/Modified_affine_bounder.h>
#include <corral/bounders/Recursive_taylor_bounder.h>
#include <corral/localization/localize_with_bounder.h>
#include <corral/number/Nearest_interval.h>
#include <corral/number/Outward_interval.h>
#include <corral/number/Rational_interval.h>
#include <corral/polynomial/arithmetic.h>
#include <corral/polynomial/evaluate.h>
#include <corral/polynomial/parse.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <thread>
#include <vector>

namespace {

using namespace corral;
using Curve = Polynomial<Rational, 2>;

Curve curve(const char* text) { return parse_polynomial<2>(text, {"x", "y"}); }

Grid<2> unit_grid(std::uint32_t nx, std::uint32_t ny)
{
  return Grid<2>({Rational_interval(0, 1), Rational_interval(0, 1)}, {nx, ny});
}

// Twenty lines whose slopes and offsets spread over many magnitudes.
Curve twenty_lines()
{
  Curve product = curve("1");
  for (int k = 1; k <= 20; ++k)
    product = product
              * collect<Rational, 2>({{{1, 0}, Rational(3 * k + 1)},
                                      {{0, 1}, Rational(k % 2 == 0 ? 41 - k : k - 41)},
                                      {{0, 0}, Rational(-k * k) / 7}});
  return product;
}

// Cells in which exact arithmetic sees a change of sign and which the set lacks.
std::size_t lost_cells(const Curve& f, const Grid<2>& grid, const Raster<2>& cells)
{
  std::size_t lost = 0;
  const corral::test::Grid_signs signs(f, grid);
  for (std::uint32_t i = 0; i < grid.resolution()[0]; ++i)
    for (std::uint32_t j = 0; j < grid.resolution()[1]; ++j) {
      const auto corners = {signs.at(i, j), signs.at(i + 1, j), signs.at(i, j + 1), signs.at(i + 1, j + 1)};
      const bool is_hit = std::min(corners) <= 0 && std::max(corners) >= 0;
      if (is_hit && cells.verdict({i, j}) == Verdict::empty) ++lost;
    }
  return lost;
}

TEST(Localize, loses_no_cell_over_a_guaranteed_type_and_some_over_plain_doubles)
{
  const Curve f = twenty_lines();
  const auto grid = unit_grid(256, 256);
  const auto outward = localize<Recursive_taylor_bounder<Outward_interval, 2>>({f}, grid);
  EXPECT_TRUE(outward.is_guaranteed());
  EXPECT_EQ(lost_cells(f, grid, outward), 0U);
  const auto nearest = localize<Recursive_taylor_bounder<Nearest_interval, 2>>({f}, grid);
  EXPECT_FALSE(nearest.is_guaranteed());
  EXPECT_GT(lost_cells(f, grid, nearest), 0U); // negative control
}

TEST(Localize, loses_no_cell_of_grids_that_are_no_powers_of_two)
{
  for (const char* const text : {"x^2 + y^2 - 1/2", "y - x^3", "x - 1/3", "x*y - 1/10"}) {
    const Curve f = curve(text);
    for (const auto& grid : {unit_grid(100, 7), unit_grid(1, 33), unit_grid(64, 65)}) {
      const auto found =
          localize<Modified_affine_bounder<Outward_interval, 2>>({f}, grid, {}, {.sample = true, .refine_depth = 2});
      EXPECT_EQ(lost_cells(f, grid, found), 0U) << text;
    }
  }
}

TEST(Localize, calls_hit_what_changes_sign)
{
  const auto grid = unit_grid(50, 50);
  const Curve f = curve("x^2 + y^2 - 1/2");
  const auto found = localize<Recursive_taylor_bounder<Outward_interval, 2>>({f}, grid, {}, {.sample = true});
  EXPECT_GT(found.hit(), 50U);
  for (const auto& [cell, verdict] : found) {
    if (verdict != Verdict::hit) continue;
    int low = 1;
    int high = -1;
    for (std::uint32_t corner = 0; corner < 4; ++corner) {
      const int sign = sgn(
          evaluate(f, std::array<Rational, 2>{grid.line(0, cell[0] + corner % 2), grid.line(1, cell[1] + corner / 2)}));
      low = std::min(low, sign);
      high = std::max(high, sign);
    }
    EXPECT_TRUE(low <= 0 && high >= 0);
  }
}

TEST(Localize, keeps_a_common_zero_of_two_curves)
{
  const auto found = localize<Recursive_taylor_bounder<Rational_interval, 2>>(
      {curve("x^2 + y^2 - 1/2"), curve("x - y")}, unit_grid(64, 64), {}, {.sample = true, .refine_depth = 1});
  EXPECT_NE(found.verdict({32, 32}), Verdict::empty); // x = y = 1/2
  EXPECT_EQ(found.verdict({31, 31}), Verdict::hit);   // the same point, a corner of both
  EXPECT_LT(found.plotted(), 10U);
}

TEST(Localize, refuses_what_it_cannot_do)
{
  const auto grid = unit_grid(256, 256);
  using Bounder = Recursive_taylor_bounder<Outward_interval, 2>;
  const std::vector<Curve> system{curve("x^2 + y^2 - 1/2")};
  EXPECT_THROW(static_cast<void>(localize<Bounder>(system, grid, {.cell_budget = 10})), Budget_exceeded);
  EXPECT_THROW(static_cast<void>(localize<Bounder>({Curve()}, grid)), Invalid_input);
  EXPECT_THROW(static_cast<void>(localize<Bounder>(std::vector<Curve>(), grid)), Invalid_input);
}

/// A bounder of which each bound takes long, and which counts them.
struct Slow_bounder : Recursive_taylor_bounder<Outward_interval, 2>
{
  using Recursive_taylor_bounder::Recursive_taylor_bounder;
  [[nodiscard]] Outward_interval bound(const Box& box) const
  {
    ++bounds;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return Recursive_taylor_bounder::bound(box);
  }
  inline static int bounds = 0;
};

TEST(Localize, hears_a_stop_although_bounds_take_long)
{
  const auto found = localize<Slow_bounder>(curve("x^2 + y^2 - 1/2"), unit_grid(4096, 4096), test::stopping_at(1));
  EXPECT_TRUE(found.was_stopped());
  EXPECT_GT(found.unvisited_cells(), 4096U * 4096U / 2);
  EXPECT_LT(Slow_bounder::bounds, 100);
}

TEST(Localize, keeps_what_is_proved_when_it_is_stopped)
{
  using Bounder = Recursive_taylor_bounder<Outward_interval, 2>;
  const auto f = curve("x^2 + y^2 - 1/2");
  const auto grid = unit_grid(300, 200);
  const Cell_options options{.sample = true, .refine_depth = 1};
  const test::Stopping_run never(~std::uint64_t{0});
  const auto whole = localize<Bounder>(f, grid, never.options, options);
  EXPECT_FALSE(whole.was_stopped());
  EXPECT_GT(*never.reports, 3U);
  for (std::uint64_t report = 1; report <= *never.reports; ++report) {
    const auto stopped = localize<Bounder>(f, grid, test::stopping_at(report), options);
    EXPECT_EQ(test::doubts_of_stopped(stopped, whole), "") << report;
    EXPECT_LT(stopped.unvisited().size(), 40U); // some for each level of the tree
  }
  Run_options before;
  std::stop_source source;
  source.request_stop();
  before.stop = source.get_token();
  EXPECT_EQ(localize<Bounder>(f, grid, before).unvisited_cells(), 60000U);
}

TEST(Localize, takes_a_bounder_as_it_is)
{
  using Bounder = Recursive_taylor_bounder<Outward_interval, 2>;
  const auto f = curve("x^2 + y^2 - 1/2");
  const Bounder bounder(enclosure_for_localization<Outward_interval>(f));
  const auto grid = unit_grid(100, 100);
  EXPECT_EQ(localize(bounder, grid), localize<Bounder>(f, grid));
  const auto sampled = localize(bounder, grid, {}, {.sample = true});
  EXPECT_GT(sampled.hit(), 50U);
  EXPECT_EQ(lost_cells(f, grid, sampled), 0U);
  for (const auto& [cell, verdict] : localize<Bounder>(f, grid, {}, {.sample = true}))
    EXPECT_TRUE(verdict == Verdict::hit || sampled.verdict(cell) != Verdict::hit);
}

} // namespace
