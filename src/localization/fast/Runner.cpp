// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Runner.h"

#include "Fast_plan.h"
#include "Rough_nodes.h"
#include "grid_part.h"
#include "sorted_blocks.h"
#include "tasks.h"

#include <corral/errors.h>
#include <corral/number/Environment.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <iterator>
#include <mutex>
#include <tuple>
#include <utility>
#include <vector>

namespace corral::fast {
namespace {

/// The level at which the tree is cut into tasks; 0 if it is too small for that. Large trees have more tasks, not
/// larger ones, as long as there are not too many nodes to keep.
template <std::size_t D>
unsigned task_level(const Plan<D>& plan)
{
  constexpr unsigned least_depth = D == 2 ? 5 : 3;
  constexpr unsigned most_depth = D == 2 ? 12 : 6;
  constexpr unsigned least_levels = 3; // left to a task
  constexpr unsigned most_levels = D == 2 ? 7 : 6;
  const unsigned levels = plan.root_level - plan.leaf_level;
  if (levels < least_depth + least_levels) return 0;
  return plan.root_level - std::clamp(levels - std::min(levels, most_levels), least_depth, most_depth);
}

/// Runs the tasks and reports on them.
template <std::size_t D>
class Runner
{
public:
  Runner(const Polynomial<Rational, D>& f, const Grid<D>& grid, const Fast_options& options, bool refines)
      : f_(f), grid_(grid), options_(options), threads_(thread_count(options.threads)), plan_(f, grid)
  {
    plan_.cell_budget = options.cell_budget;
    plan_.tells_rough = refines && Rough_nodes<D>::can_decide(grid);
  }

  Localization<D> run()
  {
    return in_arena(threads_, [&] { return run_here(); });
  }

private:
  Localization<D> run_here()
  {
    const Nearest_scope environment;
    const Seed<D> root = root_seed(plan_);
    const Task whole{0, 1};
    const unsigned level = task_level(plan_);
    Harvest<D> harvest;
    subdivide_tasks(plan_, plan_.root_level, &root, &whole, 1, level, harvest);
    seeds_ = std::move(harvest.seeds);
    std::stable_sort(seeds_.begin(), seeds_.end(), [](const auto& a, const auto& b) { return a.cut < b.cut; });
    const auto tasks = grouped(seeds_);
    begin(tasks.size());
    collect(std::move(harvest), 0);
    in_ranges(tasks.size(), [&](std::size_t first, std::size_t last) {
      const Nearest_scope scope;
      Harvest<D> found;
      subdivide_tasks(plan_, level, seeds_.data(), tasks.data() + first, last - first, 0, found);
      collect(std::move(found), last - first);
    });
    begin(hidden_.size());
    in_ranges(hidden_.size(), [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k) collect(uncover(hidden_[k]), 1);
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
    return Block_sorter<D>(std::move(parts_), extent, shares).run();
  }

  void begin(std::size_t tasks)
  {
    tasks_ = tasks;
    done_ = 0;
  }

  /// Localises on the part of the grid that a hidden node covers.
  [[nodiscard]] Harvest<D> uncover(const Hidden_node<D>& node) const
  {
    Fast_options options;
    options.cell_budget = options_.cell_budget;
    const auto found = localize_part(f_, part(grid_, plan_, node), options, true);
    Harvest<D> harvest;
    harvest.nodes = found.counters.bounds;
    append_part(found.cells, node.corner, harvest.blocks);
    return harvest;
  }

  void decide_rough()
  {
    const Rough_nodes<D> nodes(f_, grid_, plan_);
    auto seeds = std::exchange(rough_, {});
    std::sort(seeds.begin(), seeds.end(),
              [](const auto& a, const auto& b) { return std::tie(a.cut, a.rows) < std::tie(b.cut, b.rows); });
    const auto tasks = grouped(seeds);
    begin(tasks.size());
    in_ranges(tasks.size(), [&](std::size_t first, std::size_t last) {
      const Nearest_scope scope;
      collect(nodes.decide(seeds.data(), tasks.data() + first, last - first), last - first);
    });
  }

  void collect(Harvest<D>&& harvest, std::size_t tasks)
  {
    const std::scoped_lock lock(mutex_);
    result_.counters.bounds += harvest.nodes;
    plotted_ += harvest.blocks.plotted();
    if (plotted_ > options_.cell_budget) throw_over_budget(options_.cell_budget);
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
  Plan<D> plan_;
  std::vector<Seed<D>> seeds_;
  std::mutex mutex_; // guards what follows
  Localization<D> result_;
  std::vector<Block_list<D>> parts_;
  std::size_t block_count_ = 0;
  std::uint64_t plotted_ = 0;
  std::vector<Hidden_node<D>> hidden_;
  std::vector<Seed<D>> rough_;
  std::size_t tasks_ = 0;
  std::size_t done_ = 0;
};

} // namespace

template <std::size_t D>
Localization<D> localize_part(const Polynomial<Rational, D>& f, const Grid<D>& grid, const Fast_options& options,
                              bool refines)
{
  return Runner<D>(f, grid, options, refines).run();
}

template Localization<2> localize_part<2>(const Polynomial<Rational, 2>&, const Grid<2>&, const Fast_options&, bool);
template Localization<3> localize_part<3>(const Polynomial<Rational, 3>&, const Grid<3>&, const Fast_options&, bool);

} // namespace corral::fast
