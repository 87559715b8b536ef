// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/localization/localize_fast.h>

#include "Fast_plan.h"
#include "sorted_blocks.h"

#include <corral/errors.h>
#include <corral/number/Environment.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <iterator>
#include <limits>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <tuple>
#include <utility>

namespace corral {
namespace {

template <std::size_t D>
std::vector<fast::Task> group(const std::vector<fast::Seed<D>>& seeds)
{
  constexpr std::size_t most = 8;
  std::vector<fast::Task> tasks;
  for (std::size_t s = 0; s < seeds.size(); ++s)
    if (!tasks.empty() && tasks.back().count < most && seeds[s].cut == seeds[tasks.back().first].cut)
      ++tasks.back().count;
    else
      tasks.push_back({s, 1});
  return tasks;
}

/// The level at which the tree is cut into tasks; 0 if it is too small for that. Large trees have more tasks, not
/// larger ones, as long as there are not too many nodes to keep.
template <std::size_t D>
unsigned task_level(const fast::Plan<D>& plan)
{
  constexpr unsigned least_depth = D == 2 ? 5 : 3;
  constexpr unsigned most_depth = D == 2 ? 12 : 6;
  constexpr unsigned least_levels = 3; // left to a task
  constexpr unsigned most_levels = D == 2 ? 7 : 6;
  const unsigned levels = plan.root_level - plan.leaf_level;
  if (levels < least_depth + least_levels) return 0;
  return plan.root_level - std::clamp(levels - std::min(levels, most_levels), least_depth, most_depth);
}

unsigned thread_count(const Fast_options& options)
{
  if (options.threads == 1) return 1;
  static const unsigned processors = std::max(1U, std::thread::hardware_concurrency());
  return options.threads == 0 ? processors : std::min(options.threads, processors);
}

/// What is known from some blocks and from `fine`, blocks of the grid in which these have the size of a cell.
template <std::size_t D>
std::vector<Cell_block<D>> merged(const std::vector<Cell_block<D>>& blocks, const std::vector<Cell_block<D>>& fine)
{
  std::map<std::array<std::uint32_t, D>, Cell_block<D>> coarse;
  for (const Cell_block<D>& block : fine) {
    auto index = block.index;
    for (auto& i : index) i /= block_side<D>;
    Cell_block<D>& to = coarse.try_emplace(index, Cell_block<D>{index, 0, 0}).first->second;
    const std::uint64_t cell = std::uint64_t{1} << bit_of<D>(block.index);
    to.plotted |= cell;
    if (block.hit != 0) to.hit |= cell;
  }
  std::vector<Cell_block<D>> result;
  for (const Cell_block<D>& block : blocks)
    if (const auto found = coarse.find(block.index); found != coarse.end())
      if (const std::uint64_t plotted = block.plotted & found->second.plotted; plotted != 0)
        result.push_back({block.index, plotted, block.hit | found->second.hit});
  return result;
}

/// \param refines  whether rough nodes are decided on a finer grid, too.
template <std::size_t D>
Localization<D> localize_part(const Polynomial<Rational, D>& f, const Grid<D>& grid, const Fast_options& options,
                              bool refines);

/// Runs the tasks and reports on them.
template <std::size_t D>
class Runner
{
public:
  Runner(const Polynomial<Rational, D>& f, const Grid<D>& grid, const Fast_options& options, bool refines)
      : f_(f), grid_(grid), options_(options), threads_(thread_count(options)), plan_(f, grid)
  {
    plan_.cell_budget = options.cell_budget;
    plan_.tells_rough = refines && std::all_of(grid.resolution().begin(), grid.resolution().end(), [](auto n) {
                          return n <= Grid<D>::max_resolution / block_side<D>;
                        });
  }

  Localization<D> run()
  {
    if (threads_ == 1 || static_cast<int>(threads_) == tbb::this_task_arena::max_concurrency()) return run_here();
    tbb::task_arena arena(static_cast<int>(threads_));
    return arena.execute([&] { return run_here(); });
  }

private:
  Localization<D> run_here()
  {
    const Nearest_scope environment;
    const fast::Seed<D> root = fast::root_seed(plan_);
    const fast::Task whole{0, 1};
    const unsigned level = task_level(plan_);
    fast::Harvest<D> harvest;
    fast::subdivide_tasks(plan_, plan_.root_level, &root, &whole, 1, level, harvest);
    seeds_ = std::move(harvest.seeds);
    std::stable_sort(seeds_.begin(), seeds_.end(), [](const auto& a, const auto& b) { return a.cut < b.cut; });
    const auto tasks = group(seeds_);
    begin(tasks.size());
    collect(std::move(harvest), 0);
    in_ranges(tasks.size(), [&](std::size_t first, std::size_t last) {
      const Nearest_scope scope;
      fast::Harvest<D> found;
      fast::subdivide_tasks(plan_, level, seeds_.data(), tasks.data() + first, last - first, 0, found);
      collect(std::move(found), last - first);
    });
    begin(hidden_.size());
    in_ranges(hidden_.size(), [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k) {
        fast::Harvest<D> found;
        uncover(grid_, plan_, hidden_[k], true, found);
        collect(std::move(found), 1);
      }
    });
    if (!rough_.empty()) decide_rough();
    result_.cells.append(sorted_blocks());
    return std::move(result_);
  }

  /// Calls `some(first, last)` for ranges that cover 0 to `count`.
  template <class Some>
  void in_ranges(std::size_t count, const Some& some) const
  {
    if (count == 0) return;
    if (threads_ > 1)
      tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count),
                        [&](const auto& range) { some(range.begin(), range.end()); });
    else if (options_.progress)
      for (std::size_t k = 0; k < count; ++k) some(k, k + 1);
    else
      some(0, count);
  }

  std::vector<Cell_block<D>> sorted_blocks()
  {
    std::array<std::uint32_t, D> extent;
    for (std::size_t axis = 0; axis < D; ++axis) extent[axis] = (grid_.resolution()[axis] - 1) / block_side<D> + 1;
    constexpr std::size_t worth_a_thread = 2000;
    const std::size_t shares = block_count_ < worth_a_thread ? 1 : threads_;
    return fast::Block_sorter<D>(std::move(parts_), extent, shares).run();
  }

  void begin(std::size_t tasks)
  {
    tasks_ = tasks;
    done_ = 0;
  }

  /// Localises on the part of a grid that a hidden node covers, and adds what it finds to the harvest.
  void uncover(const Grid<D>& grid, const fast::Plan<D>& plan, const fast::Hidden_node<D>& node, bool refines,
               fast::Harvest<D>& harvest) const
  {
    Rational_box<D> box;
    Resolution<D> cells;
    for (std::size_t axis = 0; axis < D; ++axis) {
      const std::uint32_t first = node.corner[axis];
      const std::uint32_t last = std::min(first + plan.span(node.level, axis), grid.resolution()[axis]);
      box[axis] = Rational_interval(grid.line(axis, first), grid.line(axis, last));
      cells[axis] = last - first;
    }
    Fast_options options;
    options.cell_budget = options_.cell_budget;
    const Localization<D> part = localize_part(f_, Grid<D>(std::move(box), cells), options, refines);
    harvest.nodes += part.counters.bounds;
    for (auto block : part.cells.blocks()) {
      for (std::size_t axis = 0; axis < D; ++axis) block.index[axis] += node.corner[axis] / block_side<D>;
      harvest.blocks.push_back(block);
    }
  }

  /// Decides the rough nodes twice: as all others, and on a grid in which a leaf block is as large as a cell here.
  void decide_rough()
  {
    Resolution<D> resolution = grid_.resolution();
    for (auto& n : resolution) n *= block_side<D>;
    const Grid<D> fine_grid(grid_.box(), resolution);
    fast::Plan<D> plan(f_, fine_grid);
    plan.tells_rough = plan_.tells_rough = plan_.tells_hidden = false;
    plan_.cell_budget = std::numeric_limits<std::uint64_t>::max(); // what both see is counted once they are merged
    auto seeds = std::exchange(rough_, {});
    std::sort(seeds.begin(), seeds.end(),
              [](const auto& a, const auto& b) { return std::tie(a.cut, a.rows) < std::tie(b.cut, b.rows); });
    auto fine_seeds = seeds;
    for (auto& seed : fine_seeds)
      for (std::size_t axis = 0; axis < D; ++axis) seed.rows[2 + axis] *= block_side<D>;
    const auto tasks = group(seeds);
    const unsigned level = plan_.rough_level;
    const unsigned fine_level = level + (plan.root_level - plan_.root_level);
    begin(tasks.size());
    in_ranges(tasks.size(), [&](std::size_t first, std::size_t last) {
      const Nearest_scope scope;
      fast::Harvest<D> coarse;
      fast::subdivide_tasks(plan_, level, seeds.data(), tasks.data() + first, last - first, 0, coarse);
      fast::Harvest<D> fine;
      fast::subdivide_tasks(plan, fine_level, fine_seeds.data(), tasks.data() + first, last - first, 0, fine);
      for (const auto& node : std::exchange(fine.hidden, {})) uncover(fine_grid, plan, node, false, fine);
      fine.nodes += coarse.nodes;
      fine.blocks = merged(coarse.blocks, fine.blocks);
      collect(std::move(fine), last - first);
    });
  }

  void collect(fast::Harvest<D>&& harvest, std::size_t tasks)
  {
    std::uint64_t plotted = 0;
    for (const auto& block : harvest.blocks) plotted += static_cast<unsigned>(std::popcount(block.plotted));
    const std::scoped_lock lock(mutex_);
    result_.counters.bounds += harvest.nodes;
    plotted_ += plotted;
    if (plotted_ > options_.cell_budget) fast::throw_over_budget(options_.cell_budget);
    block_count_ += harvest.blocks.size();
    parts_.push_back(std::move(harvest.blocks));
    hidden_.insert(hidden_.end(), harvest.hidden.begin(), harvest.hidden.end());
    std::move(harvest.rough.begin(), harvest.rough.end(), std::back_inserter(rough_));
    done_ += tasks;
    const double part = tasks_ == 0 ? 1 : static_cast<double>(done_) / static_cast<double>(tasks_);
    if (options_.progress && !options_.progress(part)) throw Cancelled("localize_fast: cancelled by the caller");
  }

  const Polynomial<Rational, D>& f_;
  const Grid<D>& grid_;
  const Fast_options& options_;
  unsigned threads_;
  fast::Plan<D> plan_;
  std::vector<fast::Seed<D>> seeds_;
  std::mutex mutex_; // guards what follows
  Localization<D> result_;
  std::vector<std::vector<Cell_block<D>>> parts_;
  std::size_t block_count_ = 0;
  std::uint64_t plotted_ = 0;
  std::vector<fast::Hidden_node<D>> hidden_;
  std::vector<fast::Seed<D>> rough_;
  std::size_t tasks_ = 0;
  std::size_t done_ = 0;
};

template <std::size_t D>
Localization<D> localize_part(const Polynomial<Rational, D>& f, const Grid<D>& grid, const Fast_options& options,
                              bool refines)
{
  return Runner<D>(f, grid, options, refines).run();
}

/// The cells that are plotted in both sets; no verdict carries over but `empty`.
template <std::size_t D>
Cell_set<D> common_cells(const Cell_set<D>& a, const Cell_set<D>& b)
{
  Cell_set<D> result;
  auto other = b.blocks().begin();
  for (const auto& block : a.blocks()) {
    while (other != b.blocks().end() && other->index < block.index) ++other;
    if (other == b.blocks().end()) break;
    if (other->index == block.index && (other->plotted & block.plotted) != 0)
      result.append({block.index, other->plotted & block.plotted, 0});
  }
  return result;
}

} // namespace

template <std::size_t D>
Localization<D> localize_fast(const Polynomial<Rational, D>& f, const Grid<D>& grid, const Fast_options& options)
{
  if (f.is_zero()) throw Invalid_input("localize_fast: the polynomial is zero; expected one that is not");
  const auto start = std::chrono::steady_clock::now();
  auto result = localize_part(f, grid, options, true);
  result.is_guaranteed = true;
  result.counters.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

template <std::size_t D>
Localization<D> localize_fast(const std::vector<Polynomial<Rational, D>>& system, const Grid<D>& grid,
                              const Fast_options& options)
{
  if (system.empty()) throw Invalid_input("localize_fast: the system is empty; expected at least one polynomial");
  auto result = localize_fast(system.front(), grid, options);
  for (std::size_t k = 1; k < system.size(); ++k) {
    const auto other = localize_fast(system[k], grid, options);
    result.cells = common_cells(result.cells, other.cells);
    result.counters.bounds += other.counters.bounds;
    result.counters.seconds += other.counters.seconds;
  }
  return result;
}

template Localization<2> localize_fast<2>(const Polynomial<Rational, 2>&, const Grid<2>&, const Fast_options&);
template Localization<3> localize_fast<3>(const Polynomial<Rational, 3>&, const Grid<3>&, const Fast_options&);
template Localization<2> localize_fast<2>(const std::vector<Polynomial<Rational, 2>>&, const Grid<2>&,
                                          const Fast_options&);
template Localization<3> localize_fast<3>(const std::vector<Polynomial<Rational, 3>>&, const Grid<3>&,
                                          const Fast_options&);

} // namespace corral
