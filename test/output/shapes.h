// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_TEST_OUTPUT_SHAPES_H
#define CORRAL_TEST_OUTPUT_SHAPES_H

#include <corral/localization/Cell_set.h>

#include <algorithm>
#include <functional>
#include <vector>

/// Cells made by hand, for the tests of the writers.
namespace corral::test {

template <std::size_t D>
Grid<D> grid(std::uint32_t resolution, Rational lower = 0, Rational upper = 1)
{
  Rational_box<D> box;
  box.fill(Rational_interval(lower, upper));
  Resolution<D> all;
  all.fill(resolution);
  return Grid<D>(box, all);
}

/// The set of these cells in any order.
template <std::size_t D>
Cell_set<D> cell_set(std::vector<std::pair<Cell<D>, Verdict>> list)
{
  const auto block = [](const Cell<D>& cell) {
    Cell<D> index;
    for (std::size_t axis = 0; axis < D; ++axis) index[axis] = cell[axis] / block_side<D>;
    return index;
  };
  std::sort(list.begin(), list.end(), [&](const auto& a, const auto& b) { return block(a.first) < block(b.first); });
  Cell_set<D> cells;
  for (const auto& [cell, verdict] : list) cells.append(cell, verdict);
  cells.finish();
  return cells;
}

/// Every cell of the grid for which `verdict` does not say empty.
template <std::size_t D>
Cell_set<D> select(const Grid<D>& grid, const std::function<Verdict(const Cell<D>&)>& verdict)
{
  std::vector<std::pair<Cell<D>, Verdict>> list;
  Cell<D> cell{};
  for (bool more = true; more;) {
    if (const Verdict found = verdict(cell); found != Verdict::empty) list.emplace_back(cell, found);
    more = false;
    for (std::size_t axis = D; axis-- > 0 && !more;) {
      more = ++cell[axis] < grid.resolution()[axis];
      if (!more) cell[axis] = 0;
    }
  }
  return cell_set<D>(std::move(list));
}

} // namespace corral::test

#endif
