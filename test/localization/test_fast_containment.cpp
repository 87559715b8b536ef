// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/localization/localize.h>
#include <corral/polynomial/evaluate.h>

#include "exact_cells.h"
#include "paper_polynomials.h"
#include "random_cases.h"
#include "rounds.h"

#include <gtest/gtest.h>

#include <algorithm>

/// \file
/// Verdicts of the fast engine against exact signs and exact zeros, a hundred million of them with
/// CORRAL_TEST_MULTIPLIER=30.
namespace {

using namespace corral;
using test::for_each_cell;

/// Compares one verdict with the exact signs of f at the corners; `description` if they contradict each other.
template <std::size_t D, std::size_t N>
std::string contradiction(const Polynomial<Rational, D>& f, const Grid<D>& grid, const Cell<D>& cell, Verdict verdict,
                          const int (&corners)[N])
{
  const auto [low, high] = std::minmax_element(std::begin(corners), std::end(corners));
  const bool one_sign = *low == *high && *low != 0;
  if (verdict == Verdict::unknown || (verdict == Verdict::empty) == one_sign) return "";
  if (verdict == Verdict::hit) return test::contradiction(f, grid, cell, verdict);
  std::string text = "lost cell";
  for (const auto k : cell) text += " " + std::to_string(k);
  return text + " of " + test::text_of(f);
}

/// Checks every cell; returns the number of cells.
std::uint64_t check_corners(const Polynomial<Rational, 2>& f, const Grid<2>& grid)
{
  const auto cells = localize(f, grid);
  const test::Grid_signs signs(f, grid);
  std::uint64_t checked = 0;
  for_each_cell<2>(grid.resolution(), [&](const Cell<2>& cell) {
    const auto [x, y] = cell;
    const int corners[] = {signs.at(x, y), signs.at(x + 1, y), signs.at(x, y + 1), signs.at(x + 1, y + 1)};
    const auto wrong = contradiction(f, grid, cell, cells.verdict(cell), corners);
    if (!wrong.empty()) ADD_FAILURE() << wrong;
    ++checked;
  });
  return checked;
}

/// f on the plane where the last coordinate is `z`.
Polynomial<Rational, 2> on_plane(const Polynomial<Rational, 3>& f, const Rational& z)
{
  std::vector<Polynomial<Rational, 2>::Term> terms{{{0, 0}, 0}};
  for (const auto& term : f.terms()) {
    Rational coefficient = term.coefficient;
    for (unsigned k = 0; k < term.exponents[2]; ++k) coefficient *= z;
    terms.push_back({{term.exponents[0], term.exponents[1]}, coefficient});
  }
  return collect<Rational, 2>(std::move(terms));
}

std::uint64_t check_corners(const Polynomial<Rational, 3>& f, const Grid<3>& grid)
{
  const auto cells = localize(f, grid);
  const auto [nx, ny, nz] = grid.resolution();
  const Grid<2> layer({grid.box()[0], grid.box()[1]}, {nx, ny});
  const auto signs_at = [&](std::uint32_t z) { return test::Grid_signs(on_plane(f, grid.line(2, z)), layer); };
  auto below = signs_at(0);
  std::uint64_t checked = 0;
  for (std::uint32_t z = 0; z < nz; ++z) {
    auto above = signs_at(z + 1);
    for_each_cell<2>(layer.resolution(), [&](const Cell<2>& at) {
      const auto [x, y] = at;
      const int corners[] = {below.at(x, y), below.at(x + 1, y), below.at(x, y + 1), below.at(x + 1, y + 1),
                             above.at(x, y), above.at(x + 1, y), above.at(x, y + 1), above.at(x + 1, y + 1)};
      const Cell<3> cell{x, y, z};
      const auto wrong = contradiction(f, grid, cell, cells.verdict(cell), corners);
      if (!wrong.empty()) ADD_FAILURE() << wrong;
      ++checked;
    });
    below = std::move(above);
  }
  return checked;
}

TEST(Fast_containment, agrees_with_the_exact_signs_of_all_corners_in_the_plane)
{
  Trouble_source random(5);
  std::uint64_t checked = 0;
  for (int round = 0; round < test::rounds(20); ++round)
    checked += check_corners(test::random_polynomial<2>(random, static_cast<unsigned>(random.integer(2, 9))),
                             test::random_grid<2>(random, 700));
  for (std::size_t k = 0; k < 10; ++k) checked += check_corners(test::paper_curve(k), test::paper_grid_2(256));
  const Rational_interval side(-2, 2); // the values reach 2^60
  const auto steep = parse_polynomial<2>("x^60 + y^60 - 1", {"x", "y"});
  checked += check_corners(steep, Grid<2>({side, side}, {90, 77}));
  checked += check_corners(steep, Grid<2>({side, side}, {7, 13}));
  RecordProperty("cells", std::to_string(checked));
  std::printf("%llu cells checked\n", static_cast<unsigned long long>(checked));
}

TEST(Fast_containment, agrees_with_the_exact_signs_of_all_corners_in_space)
{
  Trouble_source random(6);
  std::uint64_t checked = 0;
  for (int round = 0; round < test::rounds(8); ++round)
    checked += check_corners(test::random_polynomial<3>(random, static_cast<unsigned>(random.integer(2, 7))),
                             test::random_grid<3>(random, 90));
  for (std::size_t k = 0; k < 10; ++k) checked += check_corners(test::paper_surface(k), test::paper_grid_3(32));
  RecordProperty("cells", std::to_string(checked));
  std::printf("%llu cells checked\n", static_cast<unsigned long long>(checked));
}

/// A polynomial in all variables but the last, as one in all.
template <std::size_t D>
Polynomial<Rational, D> over_the_base(Trouble_source& random)
{
  std::vector<typename Polynomial<Rational, D>::Term> terms;
  for (int count = static_cast<int>(random.integer(1, 6)); count > 0; --count) {
    Exponents<D> exponents{};
    for (std::size_t axis = 0; axis + 1 < D; ++axis) exponents[axis] = static_cast<std::uint16_t>(random.integer(0, 4));
    terms.push_back({exponents, random.full_mantissa()});
  }
  return collect<Rational, D>(std::move(terms));
}

/// The first and last cell along an axis that contain a number, or none.
template <std::size_t D>
std::vector<std::uint32_t> cells_around(const Grid<D>& grid, std::size_t axis, const Rational& x)
{
  const Rational position = (x - grid.box()[axis].lower()) / grid.step(axis);
  Integer below;
  mpz_fdiv_q(below.get_mpz_t(), position.get_num_mpz_t(), position.get_den_mpz_t());
  std::vector<std::uint32_t> cells;
  for (const Integer& cell : {Integer(below - 1), below})
    if (cell >= 0 && cell < grid.resolution()[axis] && (cell == below || position == below))
      cells.push_back(static_cast<std::uint32_t>(cell.get_ui()));
  return cells;
}

struct Zero_count
{
  std::uint64_t checked = 0; ///< pairs of a zero and a cell that contains it
  std::uint64_t lost = 0;    ///< of these, the cells called empty
};

/// Localises a(x) y - b(x), or the like in space, and looks up cells that contain points (x, b(x) / a(x) + `offset`).
template <std::size_t D>
Zero_count look_up_zeros(Trouble_source& random, const Rational& offset)
{
  const auto a = over_the_base<D>(random);
  const auto b = over_the_base<D>(random);
  const auto f = a * variable<Rational, D>(D - 1) - b;
  Zero_count count;
  if (a.is_zero() || f.is_zero()) return count;
  const auto grid = test::random_grid<D>(random, D == 2 ? 3000 : 200);
  const auto cells = localize(f, grid);
  for (int k = 0; k < 300; ++k) {
    std::array<Rational, D> point;
    for (std::size_t axis = 0; axis + 1 < D; ++axis) {
      const std::uint32_t n = grid.resolution()[axis];
      const auto line = static_cast<std::uint32_t>(random.integer(0, n));
      point[axis] = grid.line(axis, line);
      if (random.chance(2)) point[axis] += grid.step(axis) * abs(random.full_mantissa());
    }
    const Rational divisor = evaluate(a, point);
    if (divisor == 0) continue;
    point[D - 1] = evaluate(b, point) / divisor + offset * grid.step(D - 1);
    std::vector<Cell<D>> around{{}};
    for (std::size_t axis = 0; axis < D; ++axis) {
      std::vector<Cell<D>> more;
      for (const auto& cell : around)
        for (const auto index : cells_around(grid, axis, point[axis])) {
          more.push_back(cell);
          more.back()[axis] = index;
        }
      around = std::move(more);
    }
    for (const auto& cell : around) {
      ++count.checked;
      if (cells.verdict(cell) == Verdict::empty) ++count.lost;
    }
  }
  return count;
}

template <std::size_t D>
Zero_count look_up_zeros(std::uint64_t seed, int rounds, const Rational& offset)
{
  Trouble_source random(seed);
  Zero_count sum;
  for (int round = 0; round < rounds; ++round) {
    const auto count = look_up_zeros<D>(random, offset);
    sum.checked += count.checked;
    sum.lost += count.lost;
  }
  return sum;
}

TEST(Fast_containment, plots_every_cell_that_contains_a_known_zero)
{
  const auto plane = look_up_zeros<2>(7, test::rounds(200), 0);
  const auto space = look_up_zeros<3>(8, test::rounds(60), 0);
  EXPECT_EQ(plane.lost, 0U);
  EXPECT_EQ(space.lost, 0U);
  EXPECT_GT(plane.checked, 4000U);
  EXPECT_GT(space.checked, 1000U);
  RecordProperty("zeros", std::to_string(plane.checked + space.checked));
  std::printf("%llu zeros checked\n", static_cast<unsigned long long>(plane.checked + space.checked));
}

TEST(Fast_containment, points_beside_the_zeros_are_in_empty_cells)
{
  // The check above would fail if the answer were about a curve three cells away.
  EXPECT_GT(look_up_zeros<2>(7, 50, 3).lost, 0U);
  EXPECT_GT(look_up_zeros<3>(8, 20, 3).lost, 0U);
}

} // namespace
