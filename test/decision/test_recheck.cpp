// SPDX-License-Identifier: LGPL-3.0-or-later
#include "all_cells.h"
#include "certificate/claims.h"
#include "localization/random_cases.h"
#include "rounds.h"

#include <corral/certificate/certificate.h>
#include <corral/decision/ideal_system.h>
#include <corral/localization/localize.h>
#include <corral/polynomial/evaluate.h>
#include <corral/polynomial/parse.h>
#include <corral/polynomial/print.h>

#include "stopping_run.h"

#include <gtest/gtest.h>

#include <algorithm>

/// \file
/// Four computations that decide the same cells: the fast engine, the exact decision of what it leaves, the same
/// without floats, and the certificate. They must not contradict each other, and one that is made to must be caught.
namespace {

using namespace corral;
using test::random_grid;
using test::random_polynomial;

constexpr std::array<const char*, 3> names = {"x", "y", "z"};

template <std::size_t D>
std::array<std::string, D> variables()
{
  std::array<std::string, D> result;
  std::copy_n(names.begin(), D, result.begin());
  return result;
}

template <std::size_t D>
struct Problem
{
  std::vector<Polynomial<Rational, D>> system;
  Grid<D> grid;
};

template <std::size_t D>
Ideal_raster<D> rechecked(const Problem<D>& problem, const Raster<D>& cells, const Run_options& run = {})
{
  if constexpr (D > 1)
    if (problem.system.size() > 1) return ideal_raster<D>(problem.system, cells, run, {.recheck = true});
  return ideal_raster<D>(problem.system.front(), cells, run, {.recheck = true});
}

template <std::size_t D>
Raster<D> localized(const Problem<D>& problem)
{
  return localize(problem.system, problem.grid);
}

template <std::size_t D>
std::string text_of(const Problem<D>& problem)
{
  std::string text;
  for (const auto& f : problem.system) text += (text.empty() ? "" : ", ") + to_string(f, variables<D>());
  for (std::size_t k = 0; k < D; ++k)
    text += " [" + to_string(problem.grid.box()[k].lower()) + ", " + to_string(problem.grid.box()[k].upper()) + "]/"
            + std::to_string(problem.grid.resolution()[k]);
  return text;
}

struct Count
{
  int problems = 0;
  std::uint64_t cells = 0;
  std::uint64_t hits = 0;
  std::uint64_t uncertified = 0;
};

/// Compares the four computations. Only a certificate may leave a cell of these problems open.
template <std::size_t D>
void confront(const Problem<D>& problem, Count& count)
{
  SCOPED_TRACE(text_of(problem));
  const auto fast = localized(problem);
  Ideal_raster<D> ideal{fast};
  ASSERT_NO_THROW(ideal = rechecked(problem, fast));
  EXPECT_EQ(ideal.rechecked, problem.grid.cell_count());
  EXPECT_EQ(ideal.raster.unknown(), 0U);
  const auto claims = certificate_test::read_claims(to_json(certify(problem.system, problem.grid), variables<D>()));
  ASSERT_TRUE(claims);
  const auto& side = problem.grid.resolution();
  test::for_each_cell<D>(side, [&](const Cell<D>& cell) {
    const Verdict truth = ideal.raster.verdict(cell);
    const Verdict said = fast.verdict(cell);
    EXPECT_TRUE(said == Verdict::unknown || said == truth);
    std::size_t index = 0;
    for (std::size_t k = 0; k < D; ++k) index = index * side[k] + cell[k];
    const char certified = claims->verdicts[index];
    EXPECT_TRUE(certified == 'u' || (certified == 'h') == (truth == Verdict::hit));
    count.uncertified += certified == 'u' ? 1U : 0U;
    ++count.cells;
  });
  count.hits += ideal.raster.hit();
  ++count.problems;
}

/// Few terms of high degree with coefficients that fill the mantissa.
template <std::size_t D>
Polynomial<Rational, D> few_terms(Trouble_source& random, long degree)
{
  std::vector<typename Polynomial<Rational, D>::Term> terms;
  for (long left = random.integer(2, 5); left > 0; --left) {
    Exponents<D> exponents;
    for (auto& e : exponents) e = static_cast<std::uint16_t>(random.chance(3) ? 0 : random.integer(1, degree));
    terms.push_back({exponents, random.full_mantissa()});
  }
  const auto f = collect<Rational, D>(std::move(terms));
  return f.is_zero() ? variable<Rational, D>(0) : f;
}

/// A product of lines or planes: many cells with several of them.
template <std::size_t D>
Polynomial<Rational, D> many_lines(Trouble_source& random)
{
  auto f = constant<Rational, D>(1);
  for (long left = random.integer(2, D == 2 ? 5 : 3); left > 0; --left) {
    auto line = constant<Rational, D>(random.full_mantissa());
    for (std::size_t k = 0; k < D; ++k)
      line = line + constant<Rational, D>(random.full_mantissa()) * variable<Rational, D>(k);
    f = f * line;
  }
  return f;
}

/// Repeated factors, with and without a positive rest: no sign changes.
template <std::size_t D>
Polynomial<Rational, D> repeated(Trouble_source& random)
{
  const auto f = random_polynomial<D>(random, 2);
  auto g = random.chance(2) ? f * f : f * f * random_polynomial<D>(random, 1);
  if (random.chance(3)) g = f * f + constant<Rational, D>(Rational(1, 1000));
  return g;
}

/// Moved by a constant so that it is zero, or an ulp from it, at a corner of a cell.
template <std::size_t D>
Polynomial<Rational, D> near_corner(Polynomial<Rational, D> f, const Grid<D>& grid, Trouble_source& random)
{
  Rational_point<D> corner;
  for (std::size_t k = 0; k < D; ++k)
    corner[k] = grid.line(k, static_cast<std::uint32_t>(random.integer(0, grid.resolution()[k])));
  const Rational ulp = Trouble_source::scaled(Integer(random.integer(-2, 2)), -random.integer(52, 56));
  const auto moved = f - constant<Rational, D>(evaluate(f, corner) + ulp);
  return moved.is_zero() ? variable<Rational, D>(0) : moved;
}

/// A grid around the origin with dyadic corners, so that the coefficients stay doubles on it.
template <std::size_t D>
Grid<D> dyadic_grid(Trouble_source& random, long most_cells)
{
  Rational_box<D> box;
  Resolution<D> resolution;
  for (std::size_t k = 0; k < D; ++k) {
    const Rational side(1, 1L << random.integer(0, 4));
    box[k] = Rational_interval(-side, side);
    resolution[k] = 2;
    while (2 * resolution[k] <= most_cells && !random.chance(3)) resolution[k] *= 2;
  }
  return {box, resolution};
}

/// Problems of one kind by one maker of polynomials, on a grid of each sort.
template <std::size_t D, class Make>
void confront_kind(std::uint64_t seed, int number, long most_cells, const Make& make)
{
  Trouble_source random(seed);
  Count count;
  for (int k = test::rounds(number); k > 0; --k) {
    const auto any = random_grid<D>(random, most_cells);
    const auto dyadic = dyadic_grid<D>(random, most_cells);
    auto f = make(random);
    confront(Problem<D>{{f}, any}, count);
    confront(Problem<D>{{near_corner(f, dyadic, random)}, dyadic}, count);
    confront(Problem<D>{{near_corner(std::move(f), any, random)}, any}, count);
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GE(count.problems, 3 * number); // that the checks ran
  EXPECT_GT(count.hits, 0U);
  EXPECT_LT(count.hits, count.cells);
  EXPECT_LT(count.uncertified, count.cells / 20);
}

TEST(Recheck, agrees_on_dense_polynomials)
{
  confront_kind<2>(1, 30, 16, [](Trouble_source& random) {
    return random_polynomial<2>(random, static_cast<unsigned>(random.integer(1, 8)));
  });
  confront_kind<3>(2, 8, 6, [](Trouble_source& random) {
    return random_polynomial<3>(random, static_cast<unsigned>(random.integer(1, 3)));
  });
}

TEST(Recheck, agrees_on_few_terms_of_high_degree)
{
  confront_kind<2>(3, 16, 16, [](Trouble_source& random) { return few_terms<2>(random, 24); });
  confront_kind<3>(4, 4, 4, [](Trouble_source& random) { return few_terms<3>(random, 5); });
}

TEST(Recheck, agrees_where_many_branches_meet)
{
  confront_kind<2>(5, 30, 16, [](Trouble_source& random) { return many_lines<2>(random); });
  confront_kind<3>(6, 6, 5, [](Trouble_source& random) { return many_lines<3>(random); });
}

TEST(Recheck, agrees_where_no_sign_changes)
{
  confront_kind<2>(7, 12, 12, [](Trouble_source& random) { return repeated<2>(random); });
}

TEST(Recheck, agrees_on_systems)
{
  Trouble_source random(8);
  Count count;
  for (int k = test::rounds(16); k > 0; --k) {
    const auto grid = dyadic_grid<2>(random, 12);
    const auto f = random_polynomial<2>(random, 3);
    const auto g = random.chance(3) ? few_terms<2>(random, 6) : random_polynomial<2>(random, 2);
    confront(Problem<2>{{f, g}, random_grid<2>(random, 12)}, count);
    confront(Problem<2>{{near_corner(f, grid, random), near_corner(g, grid, random)}, grid}, count);
  }
  for (int k = test::rounds(6); k > 0; --k) {
    const auto grid = dyadic_grid<3>(random, 4);
    const auto f = random_polynomial<3>(random, 2);
    const auto g = random_polynomial<3>(random, 1);
    confront(Problem<3>{{near_corner(f, grid, random), near_corner(g, grid, random)}, grid}, count);
  }
  EXPECT_GE(count.problems, 38);
  EXPECT_GT(count.hits, 0U);
}

// ---- negative controls: a raster with one false verdict ----

template <std::size_t D>
Problem<D> problem(const std::vector<std::string>& texts, const Rational& side, std::uint32_t cells)
{
  Rational_box<D> box;
  box.fill(Rational_interval(-side, side));
  Resolution<D> resolution;
  resolution.fill(cells);
  Problem<D> result{{}, Grid<D>(box, resolution)};
  for (const auto& text : texts) result.system.push_back(parse_polynomial<D>(text, variables<D>()));
  return result;
}

/// The set with other verdicts for some cells.
template <std::size_t D>
Raster<D> doctored(const Raster<D>& cells, const std::vector<Cell<D>>& where, Verdict verdict)
{
  Raster_builder<D> result;
  check::all_cells<D>(cells.grid()).for_each_visited([&](const Cell<D>& cell, Verdict) {
    const bool is_doctored = std::find(where.begin(), where.end(), cell) != where.end();
    const Verdict said = is_doctored ? verdict : cells.verdict(cell);
    if (said != Verdict::empty) result.append(cell, said);
  });
  return std::move(result).finish(cells.grid(), true);
}

template <std::size_t D>
void expect_caught(const Problem<D>& problem, const std::vector<Cell<D>>& where, Verdict claimed)
{
  SCOPED_TRACE(text_of(problem));
  const auto truth = rechecked(problem, check::all_cells<D>(problem.grid)).raster;
  for (const auto& cell : where)
    ASSERT_EQ(truth.verdict(cell), claimed == Verdict::hit ? Verdict::empty : Verdict::hit);
  try {
    (void)rechecked(problem, doctored(truth, where, claimed));
    ADD_FAILURE() << "a false raster passed";
  } catch (const Contradiction& found) {
    EXPECT_EQ(found.cell, (std::vector<std::uint32_t>(where.front().begin(), where.front().end())));
    EXPECT_EQ(found.claimed, claimed);
    EXPECT_EQ(found.exact, claimed == Verdict::hit ? Verdict::empty : Verdict::hit);
    EXPECT_EQ(found.cells, where.size());
    EXPECT_NE(std::string(found.what()).find("(" + std::to_string(where.front()[0]) + ", "), std::string::npos);
  }
}

// Rasters that a faulty engine has really drawn: a rounding that was counted as exact lost these cells, or made them
// up.
TEST(Recheck, catches_a_cell_that_is_falsely_empty)
{
  expect_caught<2>(problem<2>({"x^10*y^10 + x + 0x1.999999999999ap-4*y"}, Rational(1, 16), 16), {{7, 7}, {8, 8}},
                   Verdict::empty);
  expect_caught<2>(problem<2>({"x^10*y^10 + 16*x + 3/2^51*y + 5/2^56"}, Rational(1, 16), 16), {{8, 0}}, Verdict::empty);
  expect_caught<3>(
      problem<3>({"x^4*y^4*z^4 + 0x1.7851eb851eb85p+0*x + 0x1.e666666666666p+0*y + 0x1.428f5c28f5c29p+0*z"},
                 Rational(1, 16), 4),
      {{1, 1, 1}, {2, 2, 2}}, Verdict::empty);
  expect_caught<2>(problem<2>({"x^10*y^10 + x + 0x1.999999999999ap-4*y", "x - 2*y"}, Rational(1, 16), 8), {{3, 3}},
                   Verdict::empty);
}

TEST(Recheck, catches_a_cell_that_is_falsely_hit)
{
  expect_caught<2>(problem<2>({"x^10*y^10 + 754746360430811/562949953421312*x + 6037970883105047/4503599627370496*y"
                               " + 6037970882422165/576460752303423488"},
                              Rational(1, 16), 16),
                   {{10, 5}}, Verdict::hit);
  expect_caught<2>(problem<2>({"x^2 + y^2 - 1"}, 2, 64), {{0, 0}, {31, 31}, {63, 0}}, Verdict::hit);
  expect_caught<3>(problem<3>({"x^2 + y^2 + z^2 - 1"}, 2, 8), {{0, 7, 3}}, Verdict::hit);
  expect_caught<3>(problem<3>({"x^2 + y^2 + z^2 - 1", "x - y"}, 2, 4), {{0, 3, 3}}, Verdict::hit);
}

TEST(Recheck, costs_what_is_near_the_curve)
{
  const auto whole = problem<2>({"x^2 + y^2 - 2"}, 2, 1U << 20); // 10^12 cells
  const test::Stopping_run run(20'000);
  const auto none = ideal_raster<2>(parse_polynomial<2>("x^2 + y^2 - 99", {"x", "y"}),
                                    Raster_builder<2>().finish(whole.grid, true), run.options, {.recheck = true});
  EXPECT_EQ(none.rechecked, 0x1p40);
  EXPECT_LT(*run.reports, 10U);
}

// What was not reached when it was stopped is no contradiction, and is not counted.
TEST(Recheck, stops_when_asked_to)
{
  const auto circle = problem<2>({"x^2 + y^2 - 1"}, 2, 64);
  const auto cells = localized(circle);
  for (const std::uint64_t patience : {2U, 40U, 100U}) {
    const auto ideal = rechecked(circle, cells, test::stopping_at(patience));
    EXPECT_LT(ideal.rechecked, 64.0 * 64.0);
    EXPECT_EQ(ideal.raster.plotted(), cells.plotted());
  }
  EXPECT_EQ(rechecked(circle, cells).rechecked, 64.0 * 64.0);
  EXPECT_EQ(ideal_raster<2>(circle.system.front(), cells).rechecked, 0);
}

TEST(Recheck, decides_the_line)
{
  const auto roots = problem<1>({"(x^2 - 2)*(x - 1/2)^2"}, 2, 8);
  const auto ideal = rechecked(roots, check::all_cells<1>(roots.grid));
  EXPECT_EQ(ideal.rechecked, 8);
  EXPECT_EQ(ideal.raster.hit(), 4U);
  EXPECT_THROW((void)rechecked(roots, Raster_builder<1>().finish(roots.grid, true)), Contradiction);
}

} // namespace
