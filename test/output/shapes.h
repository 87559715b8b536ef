// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_TEST_OUTPUT_SHAPES_H
#define CORRAL_TEST_OUTPUT_SHAPES_H

#include <corral/localization/Raster_builder.h>

#include <functional>
#include <utility>
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

/// The raster of these cells in any order.
template <std::size_t D>
Raster<D> raster(const Grid<D>& grid, const std::vector<Plotted_cell<D>>& list)
{
  Raster_builder<D> cells;
  for (const auto& [cell, verdict] : list) cells.append(cell, verdict);
  return std::move(cells).finish(grid, true);
}

/// Every cell of the grid for which `verdict` does not say empty.
template <std::size_t D>
Raster<D> select(const Grid<D>& grid, const std::function<Verdict(const Cell<D>&)>& verdict)
{
  std::vector<Plotted_cell<D>> list;
  Cell<D> cell{};
  for (bool more = true; more;) {
    if (const Verdict found = verdict(cell); found != Verdict::empty) list.push_back({cell, found});
    more = false;
    for (std::size_t axis = D; axis-- > 0 && !more;) {
      more = ++cell[axis] < grid.resolution()[axis];
      if (!more) cell[axis] = 0;
    }
  }
  return raster(grid, list);
}

} // namespace corral::test

#endif
