// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Search.h"

#include "Runner.h"
#include "System_run.h"
#include "Term_form.h"
#include "tasks.h"

#include <corral/errors.h>

#include <bit>
#include <cassert>
#include <mutex>
#include <utility>

namespace corral::fast {

template <std::size_t D>
Found<D> search(const Search<D>& what, const Grid<D>& grid, double share)
{
  try {
    what.pulse.ask();
    if (what.system.size() > 1 || Term_form<D>::suits(what.system.front(), grid)) return run_system(what, grid, share);
    return run_alone(what, grid, share);
  } catch (const Cancelled&) { // before there was anything to keep
    Found<D> nothing;
    nothing.left.push_back({{}, grid.resolution()});
    return nothing;
  }
}

template <std::size_t D>
std::uint64_t search_parts(const Search<D>& what, const Grid<D>& grid, std::vector<Grid_part<D>> parts, double share,
                           Block_list<D>& blocks, std::vector<Grid_part<D>>& left)
{
  Search<D> alone = what;
  alone.threads = 1;
  alone.is_in_vain = {};
  std::uint64_t nodes = 0;
  std::mutex mutex;
  while (!parts.empty()) {
    const auto now = std::exchange(parts, {});
    share /= 2; // the other half is for what is hidden still
    in_parallel(what.threads, now.size(), [&](std::size_t k) {
      Found<D> found = search(alone, grid_of(grid, now[k]), share / static_cast<double>(now.size()));
      const std::scoped_lock lock(mutex);
      nodes += found.nodes;
      append_part(found.cells.blocks(), now[k].corner, blocks);
      for (const auto& part : found.left) left.push_back(moved(part, now[k].corner));
      if (blocks.plotted() > what.cell_budget) throw_over_budget(what.cell_budget);
      for (const auto& part : found.hidden) {
        assert(levels_of(part) < levels_of(now[k]));
        parts.push_back(moved(part, now[k].corner));
      }
    });
  }
  return nodes;
}

template <std::size_t D>
void add_parts(const Search<D>& what, const Grid<D>& grid, std::vector<Grid_part<D>> parts, Found<D>& found)
{
  Block_list<D> blocks;
  in_arena(what.threads, [&] { found.nodes += search_parts(what, grid, std::move(parts), 0.25, blocks, found.left); });
  blocks.visit([&](const Cell_block<D>& block) { found.cells.append(block); });
  std::uint64_t plotted = 0;
  for (const auto& block : found.cells.blocks()) plotted += static_cast<unsigned>(std::popcount(block.plotted));
  if (plotted > what.cell_budget) throw_over_budget(what.cell_budget);
}

template <std::size_t D>
Found<D> search_all(const Search<D>& what, const Grid<D>& grid)
{
  Found<D> found = search(what, grid, 0.75);
  if (found.was_in_vain) return found;
  if (!found.hidden.empty()) add_parts(what, grid, std::exchange(found.hidden, {}), found);
  what.pulse.advance(1); // all is done
  return found;
}

template Found<2> search<2>(const Search<2>&, const Grid<2>&, double);
template Found<3> search<3>(const Search<3>&, const Grid<3>&, double);
template std::uint64_t search_parts<2>(const Search<2>&, const Grid<2>&, std::vector<Grid_part<2>>, double,
                                       Block_list<2>&, std::vector<Grid_part<2>>&);
template std::uint64_t search_parts<3>(const Search<3>&, const Grid<3>&, std::vector<Grid_part<3>>, double,
                                       Block_list<3>&, std::vector<Grid_part<3>>&);
template Found<2> search_all<2>(const Search<2>&, const Grid<2>&);
template Found<3> search_all<3>(const Search<3>&, const Grid<3>&);

} // namespace corral::fast
