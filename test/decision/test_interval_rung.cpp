// SPDX-License-Identifier: LGPL-3.0-or-later
#include "all_cells.h"
#include "decision/Interval_rung.h"
#include "decision/Zero_set.h"
#include "decision/corners.h"
#include "decision/within_budget.h"
#include "rounds.h"

#include <corral/decision/ideal_raster.h>
#include <corral/internal/polynomial/integer_form.h>
#include <corral/number/Mpfr_interval.h>
#include <corral/number/Outward_interval.h>
#include <corral/polynomial/arithmetic.h>
#include <corral/polynomial/evaluate.h>
#include <corral/polynomial/parse.h>
#include <corral/polynomial/print.h>
#include <corral/polynomial/square_free.h>

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace {

using namespace corral;
using namespace corral::exact;

using Source = std::mt19937_64;

Integer random_integer(Source& random, unsigned bits)
{
  Integer result = 0;
  for (unsigned k = 0; k < bits; k += 32) result = (result << 32) + static_cast<unsigned long>(random() >> 32);
  mpz_tdiv_r_2exp(result.get_mpz_t(), result.get_mpz_t(), bits);
  return random() % 2 == 0 ? result : Integer(-result);
}

/// A polynomial on the unit box whose higher terms are smaller, as on a small cell.
template <std::size_t D>
Polynomial<Integer, D> random_polynomial(Source& random)
{
  const unsigned degree = 1 + random() % (D == 3 ? 2 : 4);
  const unsigned decay = random() % 8;
  std::vector<typename Polynomial<Integer, D>::Term> terms;
  for (unsigned k = 0; k < 3 + random() % 12; ++k) {
    Exponents<D> exponents{};
    unsigned total = 0;
    for (auto& e : exponents) total += e = static_cast<std::uint16_t>(random() % (degree + 1));
    const unsigned bits = 70U - std::min(60U, decay * total);
    terms.push_back({exponents, random_integer(random, bits)});
  }
  terms.push_back({Exponents<D>{}, random_integer(random, 70U - static_cast<unsigned>(random() % 16))});
  return collect<Integer, D>(std::move(terms));
}

template <std::size_t D>
Rational_box<D> unit_box()
{
  Rational_box<D> box;
  box.fill(Rational_interval(0, 1));
  return box;
}

/// The square of one that vanishes inside the box, and a little more or less.
template <std::size_t D>
Polynomial<Integer, D> near_square(Source& random)
{
  auto root = transform<Rational>(random_polynomial<D>(random), [](const Integer& c) { return Rational(c); });
  Rational_point<D> point;
  for (auto& x : point) {
    x = Rational(1 + random() % 15, 16);
    x.canonicalize();
  }
  root = root - constant<Rational, D>(evaluate(root, point));
  const Integer rest = random_integer(random, 90U + static_cast<unsigned>(random() % 48));
  return integer_primitive(root * root + constant<Rational, D>(Rational(rest)));
}

/// The exact decision without any interval.
template <std::size_t D>
Verdict truth(const Polynomial<Integer, D>& f)
{
  const auto free = square_free_part(f);
  const auto form = to_bernstein(power_form(free));
  return Zero_set<D>([&] { return free; }, {}, Witnesses::simple).decide(form, unit_box<D>()).verdict;
}

struct Tally
{
  int right = 0;
  int wrong = 0;
  int unclear = 0;
};

/// \param without_remainder  the fault of dropping small terms and forgetting them.
template <class I, std::size_t D>
Tally compare(Source& random, int rounds, long precision, bool without_remainder = false)
{
  Tally tally;
  Interval_rung<I, D> rung(precision);
  for (int round = 0; round < rounds; ++round) {
    const auto f = near_square<D>(random);
    if (f.is_constant()) continue;
    auto power = power_form(f);
    const int sign = corner_signs(power).common();
    if (sign == 0) continue;
    if (without_remainder) {
      std::size_t most = 0;
      for (const Integer& c : power.values) most = std::max(most, mpz_sizeinbase(c.get_mpz_t(), 2));
      for (Integer& c : power.values)
        if (mpz_sizeinbase(c.get_mpz_t(), 2) + static_cast<std::size_t>(precision) <= most) c = 0;
      if (corner_signs(power).common() != sign) continue;
    }
    const auto finding = rung.look_for_zero(power, sign);
    using Kind = typename Finding<D>::Kind;
    if (finding.kind == Kind::unclear) {
      ++tally.unclear;
      continue;
    }
    const auto verdict = truth(f);
    const bool right = (verdict == Verdict::hit) == (finding.kind == Kind::crossing);
    ++(right ? tally.right : tally.wrong);
    if (!right && !without_remainder) {
      std::array<std::string, D> names;
      for (std::size_t k = 0; k < D; ++k) names[k] = std::string(1, "xyz"[k]);
      ADD_FAILURE() << to_string(f, names) << " on the unit box";
    }
  }
  return tally;
}

TEST(Interval_rung, says_nothing_wrong_at_any_precision)
{
  Source random(20261123);
  for (const long precision : {2L, 5L, 10L, 20L, 60L}) {
    const auto plane = compare<Outward_interval, 2>(random, test::rounds(400), precision);
    EXPECT_EQ(plane.wrong, 0);
    EXPECT_GT(plane.right, precision < 10 ? 10 : 100);
    const auto space = compare<Outward_interval, 3>(random, test::rounds(60), precision);
    EXPECT_EQ(space.wrong, 0);
    EXPECT_GT(space.right, 5);
  }
  EXPECT_EQ((compare<Mpfr_interval, 2>(random, test::rounds(60), 100).wrong), 0);
}

TEST(Interval_rung, would_be_wrong_if_it_forgot_what_it_drops) // negative control
{
  Source random(20261123);
  EXPECT_GT((compare<Outward_interval, 2>(random, 400, 5, true).wrong), 0);
}

/// Cells that a product of lines meets, by the signs of each line at the corners.
std::set<Cell<2>> cells_of_lines(const std::vector<std::array<int, 3>>& lines, const Grid<2>& grid)
{
  std::set<Cell<2>> result;
  check::all_cells<2>(grid).for_each_visited([&](const Cell<2>& cell, Verdict) {
    const auto box = grid.cell_box(cell);
    for (const auto& [a, b, c] : lines) {
      std::set<int> signs;
      for (unsigned corner = 0; corner < 4; ++corner) {
        const auto point = corner_of(box, corner);
        signs.insert(sgn(Rational(a * point[0] + b * point[1] + c)));
      }
      if (signs.size() > 1 || signs.count(0) > 0) result.insert(cell);
    }
  });
  return result;
}

std::set<Cell<2>> ideal_cells(const std::string& text, const Grid<2>& grid)
{
  const auto f = parse_polynomial<2>(text, {"x", "y"});
  const auto raster = ideal_raster(f, check::all_cells<2>(grid)).raster;
  std::set<Cell<2>> result;
  for (const auto& [cell, verdict] : raster) {
    EXPECT_EQ(verdict, Verdict::hit);
    result.insert(cell);
  }
  return result;
}

const Rational_box<2> around = {Rational_interval(-2, 2), Rational_interval(-2, 2)};

TEST(Interval_rung, plots_products_of_twenty_lines)
{
  Source random(20);
  const auto small = [&] { return static_cast<int>(random() % 19) - 9; };
  std::vector<std::array<int, 3>> lines;
  std::string product = "1";
  while (lines.size() < 20) {
    lines.push_back({small() * 2 + 1, small(), small()});
    const auto& [a, b, c] = lines.back();
    product += "*(" + std::to_string(a) + "*x+(" + std::to_string(b) + ")*y+(" + std::to_string(c) + "))";
  }
  const Grid<2> grid(around, {24, 24});
  EXPECT_EQ(ideal_cells(product, grid), cells_of_lines(lines, grid));
  lines.pop_back();
  EXPECT_NE(ideal_cells(product, grid), cells_of_lines(lines, grid)); // negative control: a line less is seen
}

/// The cells that x^60 + y^60 = 1 meets: on a box that no axis cuts, the polynomial is monotone in |x| and |y|.
std::set<Cell<2>> cells_of_the_squircle(const Grid<2>& grid, unsigned degree)
{
  const auto power = [degree](const Rational& x) {
    Rational result = 1;
    for (unsigned k = 0; k < degree; ++k) result *= x;
    return result;
  };
  std::set<Cell<2>> result;
  check::all_cells<2>(grid).for_each_visited([&](const Cell<2>& cell, Verdict) {
    Rational least = -1;
    Rational most = -1;
    for (const auto& side : grid.cell_box(cell)) {
      const Rational low = abs(side.lower());
      const Rational high = abs(side.upper());
      most += power(std::max(low, high));
      least += side.lower() * side.upper() <= 0 ? Rational(0) : power(std::min(low, high));
    }
    if (least <= 0 && most >= 0) result.insert(cell);
  });
  return result;
}

TEST(Interval_rung, plots_degree_sixty)
{
  const Grid<2> grid(around, {16, 16});
  EXPECT_EQ(ideal_cells("x^60+y^60-1", grid), cells_of_the_squircle(grid, 60));
  EXPECT_NE(ideal_cells("x^60+y^60-1", grid), cells_of_the_squircle(grid, 2)); // negative control
}

TEST(Within_budget, a_cell_that_is_too_heavy_is_unknown_with_the_reason)
{
  const auto decision =
      exact::within_budget<2>([]() -> Cell_decision<2> { throw Budget_exceeded("a witness of 70000 digits"); });
  EXPECT_EQ(decision.verdict, Verdict::unknown);
  EXPECT_EQ(decision.reason, "a witness of 70000 digits");
  EXPECT_EQ(exact::within_budget<2>([] {
              return Cell_decision<2>{Verdict::hit, Rung::integers, {}, {}};
            }).verdict,
            Verdict::hit);
}

} // namespace
