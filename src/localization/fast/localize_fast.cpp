// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/localization/localize_fast.h>

#include "Fast_plan.h"

#include <corral/errors.h>
#include <corral/number/Environment.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <mutex>
#include <string>
#include <thread>
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

/// The level at which the tree is cut into tasks; 0 if it is too small for that.
template <std::size_t D>
unsigned task_level(const fast::Plan<D>& plan)
{
  constexpr unsigned depth = D == 2 ? 5 : 3;
  constexpr unsigned least = 3; // levels left to a task
  return plan.root_level >= plan.leaf_level + depth + least ? plan.root_level - depth : 0;
}

/// Runs the tasks and reports on them.
template <std::size_t D>
class Runner
{
public:
  Runner(const fast::Plan<D>& plan, const Fast_options& options) : plan_(plan), options_(options) {}

  Fast_localization<D> run()
  {
    const Nearest_scope environment;
    const fast::Seed<D> root = fast::root_seed(plan_);
    const fast::Task whole{0, 1};
    const unsigned level = task_level(plan_);
    fast::Harvest<D> harvest;
    fast::subdivide_tasks(plan_, plan_.root_level, &root, &whole, 1, level, harvest);
    seeds_ = std::move(harvest.seeds);
    std::stable_sort(seeds_.begin(), seeds_.end(), [](const auto& a, const auto& b) { return a.cut < b.cut; });
    tasks_ = group(seeds_);
    collect(std::move(harvest), 0);
    run_tasks(level);
    return std::move(result_);
  }

private:
  void run_tasks(unsigned level)
  {
    const auto some = [&](std::size_t first, std::size_t last) {
      const Nearest_scope environment;
      fast::Harvest<D> harvest;
      fast::subdivide_tasks(plan_, level, seeds_.data(), tasks_.data() + first, last - first, 0, harvest);
      collect(std::move(harvest), last - first);
    };
    if (tasks_.empty()) return;
    unsigned threads = options_.threads;
    if (threads != 1) { // asking for the processors takes as long as a small curve
      const unsigned processors = std::max(1U, std::thread::hardware_concurrency());
      threads = threads == 0 ? processors : std::min(threads, processors);
    }
    if (threads == 1 && !options_.progress) return some(0, tasks_.size());
    if (threads == 1) {
      for (std::size_t t = 0; t < tasks_.size(); ++t) some(t, t + 1);
      return;
    }
    tbb::task_arena arena(static_cast<int>(threads));
    arena.execute([&] {
      tbb::parallel_for(tbb::blocked_range<std::size_t>(0, tasks_.size()),
                        [&](const auto& range) { some(range.begin(), range.end()); });
    });
  }

  void collect(fast::Harvest<D>&& harvest, std::size_t tasks)
  {
    const std::scoped_lock lock(mutex_);
    result_.nodes += harvest.nodes;
    result_.cells.append(std::move(harvest.blocks));
    if (result_.cells.blocks().size() > options_.cell_budget) fast::throw_over_budget(options_.cell_budget);
    done_ += tasks;
    const double part = tasks_.empty() ? 1 : static_cast<double>(done_) / static_cast<double>(tasks_.size());
    if (options_.progress && !options_.progress(part)) throw Cancelled("localize_fast: cancelled by the caller");
  }

  const fast::Plan<D>& plan_;
  const Fast_options& options_;
  std::vector<fast::Seed<D>> seeds_;
  std::vector<fast::Task> tasks_;
  std::mutex mutex_; // guards what follows
  Fast_localization<D> result_;
  std::size_t done_ = 0;
};

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
Fast_localization<D> localize_fast(const Polynomial<Rational, D>& f, const Grid<D>& grid, const Fast_options& options)
{
  if (f.is_zero()) throw Invalid_input("localize_fast: the polynomial is zero; expected one that is not");
  fast::Plan<D> plan(f, grid);
  plan.cell_budget = options.cell_budget;
  auto result = Runner<D>(plan, options).run();
  result.cells.finish();
  if (options.cell_budget < std::numeric_limits<std::uint64_t>::max() && result.cells.plotted() > options.cell_budget)
    fast::throw_over_budget(options.cell_budget);
  return result;
}

template <std::size_t D>
Fast_localization<D> localize_fast(const std::vector<Polynomial<Rational, D>>& system, const Grid<D>& grid,
                                   const Fast_options& options)
{
  if (system.empty()) throw Invalid_input("localize_fast: the system is empty; expected at least one polynomial");
  auto result = localize_fast(system.front(), grid, options);
  for (std::size_t k = 1; k < system.size(); ++k) {
    const auto other = localize_fast(system[k], grid, options);
    result.cells = common_cells(result.cells, other.cells);
    result.nodes += other.nodes;
  }
  return result;
}

template Fast_localization<2> localize_fast<2>(const Polynomial<Rational, 2>&, const Grid<2>&, const Fast_options&);
template Fast_localization<3> localize_fast<3>(const Polynomial<Rational, 3>&, const Grid<3>&, const Fast_options&);
template Fast_localization<2> localize_fast<2>(const std::vector<Polynomial<Rational, 2>>&, const Grid<2>&,
                                               const Fast_options&);
template Fast_localization<3> localize_fast<3>(const std::vector<Polynomial<Rational, 3>>&, const Grid<3>&,
                                               const Fast_options&);

} // namespace corral
