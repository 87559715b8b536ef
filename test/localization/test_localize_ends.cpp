// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/errors.h>
#include <corral/localization/localize.h>
#include <corral/polynomial/parse.h>

#include "exact_cells.h"
#include "localization/fast/Search.h"
#include "stopped_rasters.h"
#include "stopping_run.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

/// \file
/// Inputs on which the fast engine went on and on, or took the stack: counted in nodes, since a test reads no clock.
namespace {

using namespace corral;

template <std::size_t D>
Polynomial<Rational, D> polynomial(const std::string& text)
{
  std::array<std::string, D> names;
  for (std::size_t axis = 0; axis < D; ++axis) names[axis] = std::string(1, "xyz"[axis]);
  return parse_polynomial<D>(text, names);
}

template <std::size_t D>
Grid<D> cube(const Rational& half_side, std::uint32_t cells)
{
  Rational_box<D> box;
  box.fill(Rational_interval(-half_side, half_side));
  Resolution<D> resolution;
  resolution.fill(cells);
  return {box, resolution};
}

struct Row
{
  const char* text;
  const char* same_zeros; ///< a polynomial without repeated factors, or ""
  std::uint32_t cells;
  std::uint64_t nodes; ///< at most
};

template <std::size_t D>
void expect_end(const std::vector<Row>& rows)
{
  for (const Row& row : rows) {
    const auto grid = cube<D>(1, row.cells);
    const auto found = localize(polynomial<D>(row.text), grid);
    EXPECT_LE(found.counters().bounds, row.nodes) << row.text;
    if (*row.same_zeros != 0) {
      EXPECT_EQ(found, localize(polynomial<D>(row.same_zeros), grid)) << row.text;
    }
  }
}

TEST(Localize_ends, with_powers_in_the_plane)
{
  expect_end<2>({{"(x+1)^40", "x+1", 8, 10},
                 {"((x+1)^2+(y+1)^2)^20", "(x+1)^2+(y+1)^2", 8, 10},
                 {"(x-1/3)^36", "3*x-1", 1024, 2000},
                 {"(x-y)^100", "x-y", 1024, 2000},
                 {"(x^2+y^2-1)^50", "x^2+y^2-1", 4096, 20000},
                 {"(x+y+1)^40", "x+y+1", 8, 10},
                 {"(x+y/3-1/7)^20*(x-y/5+1/9)^23", "(x+y/3-1/7)*(x-y/5+1/9)", 256, 3000},
                 {"(x^2+y^2-1/2)^2", "x^2+y^2-1/2", 256, 6000},
                 {"(x^2+y^2-1/2)^3", "x^2+y^2-1/2", 256, 6000}});
}

TEST(Localize_ends, with_powers_in_space)
{
  expect_end<3>({{"(x+y+z-1/3)^32", "x+y+z-1/3", 16, 200}, {"(x^2+y^2+z^2-1/2)^2", "x^2+y^2+z^2-1/2", 32, 5000}});
}

TEST(Localize_ends, with_powers_in_systems)
{
  const auto grid = cube<2>(1, 256);
  const std::vector system{polynomial<2>("(x-y)^40"), polynomial<2>("(x^2+y^2-1/2)^9")};
  const std::vector simple{polynomial<2>("x-y"), polynomial<2>("x^2+y^2-1/2")};
  const auto found = localize(system, grid);
  EXPECT_EQ(found, localize(simple, grid));
  EXPECT_LE(found.counters().bounds, 3000U);
}

// Nearly powers: no factor can be taken out, and rounding hides nearly all.
TEST(Localize_ends, with_what_is_nearly_a_power)
{
  expect_end<2>({{"(x+1)^40+y/10^100", "", 8, 30000},
                 {"((x+1)^2+(y+1)^2)^20+1/10^300", "", 8, 30000},
                 {"(x-1/3)^20+(y/1000)^21", "", 128, 1000000},
                 {"(x-y)^12*(x-y+1/10^20)^12", "", 64, 1000000}});
  expect_end<3>({{"(x+y+z-1/3)^9+x*y*z/10^40", "", 8, 1000000}});
}

TEST(Localize_ends, where_values_lie_beyond_doubles)
{
  const auto grid = cube<2>(2, 64);
  const auto f = polynomial<2>("x^1000*y^1000+x-y/3");
  const auto found = localize(f, grid);
  EXPECT_LE(found.counters().bounds, 20000U);
  EXPECT_GT(found.hit(), 100U);
  EXPECT_NE(found.verdict({32, 32}), Verdict::empty);
  EXPECT_EQ(found.verdict({0, 0}), Verdict::empty);
}

/// That a run asks whether to go on, and stops iff it is told to, at any time. How often it asks depends on the clock.
template <std::size_t D>
void expect_obedience(const std::vector<Polynomial<Rational, D>>& system, const Grid<D>& grid)
{
  std::uint64_t calls = 0;
  Run_options options;
  options.progress = [&](double part) {
    EXPECT_GE(part, 0);
    EXPECT_LE(part, 1);
    ++calls;
  };
  const auto whole = localize(system, grid, options);
  EXPECT_FALSE(whole.was_stopped());
  for (const std::uint64_t report : {std::uint64_t{1}, calls / 2, calls - 1}) {
    const auto stopped = localize(system, grid, test::stopping_at(report));
    if (report == 1) {
      EXPECT_EQ(stopped.unvisited_cells(), grid.cell_count());
    }
    if (stopped.was_stopped()) {
      EXPECT_EQ(test::doubts_of_stopped(stopped, whole), "") << report << " of " << calls;
    } else {
      EXPECT_EQ(stopped, whole); // it was done before it asked again
    }
  }
}

TEST(Localize_ends, when_it_is_told_to)
{
  expect_obedience<2>({polynomial<2>("x^60 + y^60 - 1 + x*y")}, cube<2>(2, 256));
  expect_obedience<2>({polynomial<2>("x^40*y^40 - x + y/3")}, cube<2>(1, 16));
  expect_obedience<2>({polynomial<2>("(x-1/3)^20+(y/1000)^21")}, cube<2>(1, 64));
  expect_obedience<2>({polynomial<2>("x-y"), polynomial<2>("x^40*y^40 - x + y/3")}, cube<2>(1, 64));
  expect_obedience<3>({polynomial<3>("(x+y+z-1/3)^9+x*y*z/10^40")}, cube<3>(1, 8));
}

} // namespace
