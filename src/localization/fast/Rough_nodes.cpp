// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Rough_nodes.h"

#include "Runner.h"
#include "grid_part.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

namespace corral::fast {
namespace {

template <std::size_t D>
Grid<D> refined(const Grid<D>& grid)
{
  Resolution<D> resolution = grid.resolution();
  for (auto& n : resolution) n *= block_side<D>;
  return {grid.box(), resolution};
}

/// What is known from some blocks and from `fine`, blocks of the grid in which these have the size of a cell.
template <std::size_t D>
Block_list<D> merged(const Block_list<D>& blocks, const Block_list<D>& fine)
{
  std::map<std::array<std::uint32_t, D>, Cell_block<D>> coarse;
  fine.visit([&](const Cell_block<D>& block) {
    auto index = block.index;
    for (auto& i : index) i /= block_side<D>;
    Cell_block<D>& to = coarse.try_emplace(index, Cell_block<D>{index, 0, 0}).first->second;
    const std::uint64_t cell = std::uint64_t{1} << bit_of<D>(block.index);
    to.plotted |= cell;
    if (block.hit != 0) to.hit |= cell;
  });
  Block_list<D> result;
  blocks.visit([&](const Cell_block<D>& block) {
    if (const auto found = coarse.find(block.index); found != coarse.end())
      if (const std::uint64_t plotted = block.plotted & found->second.plotted; plotted != 0)
        result.add({block.index, plotted, block.hit | found->second.hit});
  });
  return result;
}

} // namespace

template <std::size_t D>
bool Rough_nodes<D>::can_decide(const Grid<D>& grid)
{
  return std::all_of(grid.resolution().begin(), grid.resolution().end(),
                     [](auto n) { return n <= Grid<D>::max_resolution / block_side<D>; });
}

template <std::size_t D>
Rough_nodes<D>::Rough_nodes(const Polynomial<Rational, D>& f, const Grid<D>& grid, const Plan<D>& plan)
    : f_(f), plan_(plan), fine_grid_(refined(grid)), fine_plan_(f, fine_grid_)
{
  fine_plan_.tells_rough = plan_.tells_rough = plan_.tells_hidden = false;
  plan_.cell_budget = std::numeric_limits<std::uint64_t>::max(); // what both see is counted once they are merged
}

template <std::size_t D>
Harvest<D> Rough_nodes<D>::decide(Task<D> seeds) const
{
  Harvest<D> coarse;
  subdivide(plan_, plan_.rough_level, seeds, 0, coarse);
  std::vector<Seed<D>> fine_seeds(seeds.begin(), seeds.end());
  for (auto& seed : fine_seeds)
    for (std::size_t axis = 0; axis < D; ++axis) seed.rows[2 + axis] *= block_side<D>;
  Harvest<D> fine;
  subdivide<D>(fine_plan_, plan_.rough_level + (fine_plan_.root_level - plan_.root_level), fine_seeds, 0, fine);
  for (const auto& node : fine.hidden) {
    const auto found = localize_part(f_, part(fine_grid_, fine_plan_, node), {}, false);
    fine.nodes += found.counters.bounds;
    append_part(found.cells, node.corner, fine.blocks);
  }
  fine.hidden.clear();
  fine.nodes += coarse.nodes;
  fine.blocks = merged(coarse.blocks, fine.blocks);
  return fine;
}

template class Rough_nodes<2>;
template class Rough_nodes<3>;

} // namespace corral::fast
