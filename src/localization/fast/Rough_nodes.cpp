// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Rough_nodes.h"

#include "Search.h"
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
bool Rough_nodes<D>::can_decide(const Polynomial<Rational, D>& f, const Grid<D>& grid)
{
  return Term_form<D>::has_few_terms(f) || std::all_of(grid.resolution().begin(), grid.resolution().end(), [](auto n) {
           return n <= Grid<D>::max_resolution / block_side<D>;
         });
}

template <std::size_t D>
Rough_nodes<D>::Rough_nodes(const Polynomial<Rational, D>& f, const Grid<D>& grid, const Plan<D>& plan, Pulse& pulse)
    : level_(plan.rough_level)
{
  if (Term_form<D>::has_few_terms(f))
    by_terms_.emplace(f, grid, pulse);
  else
    twice_.emplace(f, grid, plan, pulse);
}

template <std::size_t D>
Harvest<D> Rough_nodes<D>::decide(Task<D> seeds) const
{
  if (twice_) return twice_->decide(seeds);
  std::vector<Cell<D>> corners;
  for (const auto& seed : seeds) corners.push_back(seed.corner);
  return by_terms_->decide(level_, corners);
}

template <std::size_t D>
Rough_nodes<D>::Twice::Twice(const Polynomial<Rational, D>& f, const Grid<D>& grid, const Plan<D>& given,
                             Pulse& for_all)
    : pulse(for_all), system{f}, plan(given), fine_grid(refined(grid)), fine_plan(plan.shape, fine_grid)
{
  plan.tells_rough = plan.tells_hidden = fine_plan.tells_rough = false;
  plan.cell_budget = std::numeric_limits<std::uint64_t>::max(); // counted once both are merged
}

template <std::size_t D>
Harvest<D> Rough_nodes<D>::Twice::decide(Task<D> seeds) const
{
  Harvest<D> coarse;
  subdivide(plan, pulse, plan.rough_level, seeds, 0, coarse);
  std::vector<Seed<D>> fine_seeds(seeds.begin(), seeds.end());
  for (auto& seed : fine_seeds)
    for (auto& line : seed.corner) line *= block_side<D>;
  Harvest<D> fine;
  subdivide<D>(fine_plan, pulse, plan.rough_level + (fine_plan.root_level - plan.root_level), fine_seeds, 0, fine);
  std::vector<Grid_part<D>> parts;
  for (const auto& node : fine.hidden) parts.push_back(part_of(fine_plan, node));
  fine.hidden.clear();
  Search<D> rest{system, pulse};
  rest.refines = false; // else finer and finer grids without end
  std::vector<Grid_part<D>> left;
  fine.nodes += coarse.nodes + search_parts(rest, fine_grid, std::move(parts), 0, fine.blocks, left);
  if (!left.empty()) throw Cancelled("localize: stopped on request"); // so that the caller leaves the nodes
  fine.blocks = merged(coarse.blocks, fine.blocks);
  return fine;
}

template class Rough_nodes<2>;
template class Rough_nodes<3>;

} // namespace corral::fast
