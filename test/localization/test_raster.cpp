// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/localization/Raster_builder.h>
#include <corral/localization/connected_components.h>

#include "exact_cells.h"
#include "random_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <sstream>

namespace {

using namespace corral;

static_assert(std::forward_iterator<Raster<2>::Iterator>);

TEST(Grid, finds_its_dimension_in_braces)
{
  const Grid plane({{-2, 2}, {-1, 1}}, {64, 32});
  static_assert(std::same_as<decltype(plane), const Grid<2>>);
  EXPECT_EQ(plane, Grid<2>({Rational_interval(-2, 2), Rational_interval(-1, 1)}, {64, 32}));
  const Grid space({{0, Rational(1, 3)}, {-1, 1}, {5, 7}}, 9);
  static_assert(std::same_as<decltype(space), const Grid<3>>);
  EXPECT_EQ(space.resolution(), (Resolution<3>{9, 9, 9}));
  EXPECT_EQ(space.box()[0].upper(), Rational(1, 3));
  EXPECT_THROW((void)Grid({{1, 1}, {0, 1}}, 4), Invalid_input);
  EXPECT_THROW((void)Grid({{0, 1}, {0, 1}}, 0), Invalid_input);
}

template <std::size_t D>
Grid<D> unit_grid(const Resolution<D>& resolution)
{
  Rational_box<D> box;
  box.fill(Rational_interval(0, 1));
  return {box, resolution};
}

template <std::size_t D>
Raster<D> raster(const Resolution<D>& resolution, const std::vector<Plotted_cell<D>>& cells)
{
  Raster_builder<D> builder;
  for (const auto& [cell, verdict] : cells) builder.append(cell, verdict);
  return std::move(builder).finish(unit_grid<D>(resolution), true);
}

TEST(Raster, gives_back_the_verdict_of_every_cell)
{
  const auto cells = raster<2>({16, 16}, {{{9, 1}, Verdict::unknown}, {{8, 7}, Verdict::hit}, {{0, 3}, Verdict::hit}});
  EXPECT_EQ(cells.verdict({9, 1}), Verdict::unknown);
  EXPECT_EQ(cells.verdict({8, 7}), Verdict::hit);
  EXPECT_EQ(cells.verdict({0, 3}), Verdict::hit);
  EXPECT_EQ(cells.verdict({1, 9}), Verdict::empty);
  EXPECT_EQ(cells.verdict({9, 2}), Verdict::empty);
  EXPECT_EQ(cells.plotted(), 3U);
  EXPECT_EQ(cells.hit(), 2U);
}

template <std::size_t D>
void check_block_numbering()
{
  std::array<std::uint32_t, D> block{};
  block.fill(5);
  const unsigned cells = D == 5 ? 32 : D == 4 ? 16 : 64;
  for (unsigned bit = 0; bit < cells; ++bit) EXPECT_EQ(bit_of<D>(cell_of<D>(block, bit)), bit);
}

TEST(Cell_block, numbers_its_cells_without_repetition)
{
  check_block_numbering<1>();
  check_block_numbering<2>();
  check_block_numbering<3>();
  check_block_numbering<4>();
  check_block_numbering<5>();
}

TEST(Raster, sorts_by_the_first_axis_first)
{
  const auto cells = raster<2>({32, 32}, {{{3, 20}, Verdict::unknown},
                                          {{9, 0}, Verdict::unknown},
                                          {{3, 2}, Verdict::unknown},
                                          {{1, 5}, Verdict::unknown}});
  std::vector<Cell<2>> order;
  cells.for_each_sorted([&](const Cell<2>& cell, Verdict) { order.push_back(cell); });
  EXPECT_EQ(order, (std::vector<Cell<2>>{{1, 5}, {3, 2}, {3, 20}, {9, 0}}));
}

/// Random rasters, some parts of which were not visited, beside a table of all cells.
template <std::size_t D>
void compare_with_a_table(std::uint64_t seed, const Resolution<D>& resolution)
{
  std::mt19937_64 random(seed);
  std::map<Cell<D>, Verdict> table;
  Raster_builder<D> builder;
  Cell_range<D> left{resolution, resolution}; // a corner of the grid
  for (auto& index : left.first) index -= static_cast<std::uint32_t>(1 + random() % index);
  builder.leave(left);
  test::for_each_cell<D>(resolution, [&](const Cell<D>& cell) {
    if (left.contains(cell)) {
      table[cell] = Verdict::unknown;
      return;
    }
    const auto verdict = static_cast<Verdict>(random() % 3);
    if (verdict == Verdict::empty) return;
    table[cell] = verdict;
    builder.append(cell, verdict);
  });
  const auto found = std::move(builder).finish(unit_grid<D>(resolution), true);
  test::for_each_cell<D>(resolution, [&](const Cell<D>& cell) {
    EXPECT_EQ(found.verdict(cell), table.contains(cell) ? table[cell] : Verdict::empty);
  });
  std::map<Cell<D>, Verdict> seen;
  for (const auto& [cell, verdict] : found) EXPECT_TRUE(seen.emplace(cell, verdict).second) << "twice";
  EXPECT_EQ(seen, table);
  std::vector<std::pair<Cell<D>, Verdict>> sorted;
  found.for_each_sorted([&](const Cell<D>& cell, Verdict verdict) { sorted.emplace_back(cell, verdict); });
  EXPECT_TRUE(std::equal(sorted.begin(), sorted.end(), table.begin(), table.end(),
                         [](const auto& a, const auto& b) { return a.first == b.first && a.second == b.second; }));
  EXPECT_EQ(found.size(), table.size());
  EXPECT_EQ(found.hit() + found.unknown(), table.size());
  EXPECT_EQ(static_cast<double>(found.unvisited_cells()), left.count());
}

TEST(Raster, is_a_range_of_all_cells_that_are_not_empty)
{
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    compare_with_a_table<1>(seed, {100});
    compare_with_a_table<2>(seed, {13, 29});
    compare_with_a_table<3>(seed, {5, 9, 7});
    compare_with_a_table<4>(seed, {3, 2, 5, 4});
  }
}

TEST(Raster, holds_more_unvisited_cells_than_memory)
{
  constexpr std::uint32_t n = Grid<3>::max_resolution;
  Raster_builder<3> builder;
  builder.append({0, 0, 0}, Verdict::hit);
  builder.leave({{1, 0, 0}, {n, n, n}});
  const auto found = std::move(builder).finish(unit_grid<3>({n, n, n}), true);
  EXPECT_EQ(found.verdict({n - 1, 3, 7}), Verdict::unknown);
  EXPECT_EQ(found.verdict({0, 3, 7}), Verdict::empty);
  EXPECT_EQ(found.unknown(), ~std::uint64_t{0}); // more than can be counted
  EXPECT_EQ((*std::next(found.begin())).cell, (Cell<3>{1, 0, 0}));
}

TEST(Raster, compares_what_is_said_of_cells)
{
  const std::vector<Plotted_cell<2>> two{{{9, 1}, Verdict::unknown}, {{8, 7}, Verdict::hit}};
  const auto a = raster<2>({16, 16}, two);
  EXPECT_EQ(a, raster<2>({16, 16}, {two[1], two[0]}));
  EXPECT_FALSE(a == raster<2>({16, 17}, two)); // another grid
  EXPECT_FALSE(a == raster<2>({16, 16}, {two[0], {{8, 7}, Verdict::unknown}}));
  EXPECT_FALSE(a == raster<2>({16, 16}, {two[0]}));
  std::ostringstream out;
  out << a;
  EXPECT_EQ(out.str(), "raster of 16 x 16 cells: 1 hit, 1 unknown, all others empty");
}

TEST(Raster, cannot_be_made_of_cells_that_are_not_of_its_grid)
{
  const auto grid = unit_grid<2>({10, 10});
  const auto refuses = [&](const auto& fill) {
    Raster_builder<2> builder;
    fill(builder);
    EXPECT_THROW((void)std::move(builder).finish(grid, true), Invalid_input);
  };
  refuses([](auto& builder) { builder.append({10, 3}, Verdict::hit); });
  refuses([](auto& builder) { builder.append({{1, 1}, std::uint64_t{1} << 63, 0}); }); // cell (15, 15)
  refuses([](auto& builder) { builder.leave({{0, 0}, {11, 3}}); });
  refuses([](auto& builder) { builder.leave({{4, 4}, {4, 9}}); });
  const auto cells = raster<2>({10, 10}, {});
  EXPECT_TRUE(cells.empty());
  EXPECT_THROW((void)cells.verdict({10, 0}), Invalid_input);
  EXPECT_THROW((void)cells.box({0, 10}), Invalid_input);
  EXPECT_THROW((void)cells.neighbours({1000, 1000}), Invalid_input);
}

TEST(Raster, tells_the_cells_of_a_point_and_around_a_cell)
{
  std::mt19937_64 random(7);
  const Grid grid({{-1, 2}, {0, Rational(1, 3)}}, {6, 5});
  Raster_builder<2> builder;
  builder.append({2, 2}, Verdict::hit);
  const auto found = std::move(builder).finish(grid, true);
  for (int k = 0; k < 300; ++k) { // on lines of the grid, between them and outside
    const Rational_point<2> point{Rational(static_cast<int>(random() % 17) - 6) / 4,
                                  Rational(static_cast<int>(random() % 13) - 1) / 30};
    std::vector<Cell<2>> expected;
    test::for_each_cell<2>(grid.resolution(), [&](const Cell<2>& cell) {
      const auto box = grid.cell_box(cell);
      if (contains(box[0], point[0]) && contains(box[1], point[1])) expected.push_back(cell);
    });
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(grid.cells_at(point), expected);
    for (const auto& [cell, verdict] : found.cells_at(point)) EXPECT_EQ(verdict, found.verdict(cell));
  }
  test::for_each_cell<2>(grid.resolution(), [&](const Cell<2>& cell) {
    std::vector<Cell<2>> expected;
    test::for_each_cell<2>(grid.resolution(), [&](const Cell<2>& other) {
      const auto near = [](std::uint32_t a, std::uint32_t b) { return a <= b + 1 && b <= a + 1; };
      if (other != cell && near(cell[0], other[0]) && near(cell[1], other[1])) expected.push_back(other);
    });
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(grid.neighbours(cell), expected);
  });
  EXPECT_EQ(found.neighbours({1, 1}).back().verdict, Verdict::hit);
  EXPECT_EQ(found.box({1, 4})[0].upper(), 0);
  EXPECT_EQ(found.box({1, 4})[1].upper(), Rational(1, 3));
}

/// By walking from each cell to its neighbours.
template <std::size_t D>
std::set<std::set<Cell<D>>> components_by_walking(const Raster<D>& raster)
{
  std::set<std::set<Cell<D>>> result;
  for (const auto& [cell, verdict] : raster) {
    std::set<Cell<D>> reached{cell};
    std::vector<Cell<D>> open{cell};
    while (!open.empty()) {
      const auto from = open.back();
      open.pop_back();
      for (const auto& next : raster.neighbours(from))
        if (next.verdict != Verdict::empty && reached.insert(next.cell).second) open.push_back(next.cell);
    }
    result.insert(reached);
  }
  return result;
}

TEST(Raster, falls_into_components)
{
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    std::mt19937_64 random(seed);
    const Resolution<3> resolution{6, 5, 7};
    std::vector<Plotted_cell<3>> list;
    test::for_each_cell<3>(resolution, [&](const Cell<3>& cell) {
      if (random() % 12 == 0) list.push_back({cell, Verdict::unknown});
    });
    const auto cells = raster<3>(resolution, list);
    std::set<std::set<Cell<3>>> found;
    const auto components = connected_components(cells);
    for (const auto& component : components) {
      EXPECT_TRUE(std::is_sorted(component.begin(), component.end()));
      found.emplace(component.begin(), component.end());
    }
    EXPECT_EQ(found.size(), components.size());
    EXPECT_EQ(found, components_by_walking(cells));
    EXPECT_TRUE(std::is_sorted(components.begin(), components.end()));
  }
}

} // namespace
