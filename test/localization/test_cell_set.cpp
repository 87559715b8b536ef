// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/localization/Cell_set.h>

#include <gtest/gtest.h>

namespace {

using corral::Cell;
using corral::Cell_set;
using corral::Verdict;

TEST(Cell_set, gives_back_the_verdict_of_every_cell)
{
  Cell_set<2> cells;
  cells.append({9, 1}, Verdict::unknown);
  cells.append({8, 7}, Verdict::hit);
  cells.append({0, 3}, Verdict::hit);
  cells.finish();
  EXPECT_EQ(cells.at({9, 1}), Verdict::unknown);
  EXPECT_EQ(cells.at({8, 7}), Verdict::hit);
  EXPECT_EQ(cells.at({0, 3}), Verdict::hit);
  EXPECT_EQ(cells.at({1, 9}), Verdict::empty);
  EXPECT_EQ(cells.at({9, 2}), Verdict::empty);
  EXPECT_EQ(cells.plotted(), 3U);
  EXPECT_EQ(cells.hit(), 2U);
}

template <std::size_t D>
void check_block_numbering()
{
  std::array<std::uint32_t, D> block{};
  block.fill(5);
  const unsigned cells = D == 5 ? 32 : D == 4 ? 16 : 64;
  for (unsigned bit = 0; bit < cells; ++bit) EXPECT_EQ(corral::bit_of<D>(corral::cell_of<D>(block, bit)), bit);
}

TEST(Cell_block, numbers_its_cells_without_repetition)
{
  check_block_numbering<1>();
  check_block_numbering<2>();
  check_block_numbering<3>();
  check_block_numbering<4>();
  check_block_numbering<5>();
}

TEST(Cell_set, sorts_by_the_first_axis_first)
{
  Cell_set<2> cells;
  for (const Cell<2> cell : {Cell<2>{3, 20}, Cell<2>{9, 0}, Cell<2>{3, 2}, Cell<2>{1, 5}})
    cells.append(cell, Verdict::unknown);
  cells.finish();
  std::vector<Cell<2>> order;
  cells.for_each_sorted([&](const Cell<2>& cell, Verdict) { order.push_back(cell); });
  EXPECT_EQ(order, (std::vector<Cell<2>>{{1, 5}, {3, 2}, {3, 20}, {9, 0}}));
}

} // namespace
