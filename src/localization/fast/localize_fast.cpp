// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/localization/localize_fast.h>

#include "Fast_plan.h"

#include <corral/errors.h>
#include <corral/number/Environment.h>

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

namespace corral {
namespace {

/// Up to eight nodes of one class: what one task subdivides. It depends on the input alone, and so does the result.
struct Task
{
  std::size_t first;
  std::size_t count;
};

template <std::size_t D>
std::vector<Task> group(const std::vector<fast::Seed<D>>& seeds)
{
  constexpr std::size_t most = 8;
  std::vector<Task> tasks;
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

  std::vector<fast::Harvest<D>> run()
  {
    const Nearest_scope environment;
    const fast::Seed<D> root = fast::root_seed(plan_);
    const unsigned level = task_level(plan_);
    std::vector<fast::Harvest<D>> harvests(1);
    fast::subdivide_seeds(plan_, plan_.root_level, &root, 1, level, harvests[0]);
    auto seeds = std::move(harvests[0].seeds);
    std::stable_sort(seeds.begin(), seeds.end(), [](const auto& a, const auto& b) { return a.cut < b.cut; });
    const auto tasks = group(seeds);
    harvests.resize(tasks.size() + 1);
    for_each_task(tasks.size(), [&](std::size_t t) {
      const Nearest_scope worker_environment;
      fast::subdivide_seeds(plan_, level, seeds.data() + tasks[t].first, tasks[t].count, 0, harvests[t + 1]);
      report(harvests[t + 1], tasks.size());
    });
    return harvests;
  }

private:
  template <class Function>
  void for_each_task(std::size_t count, const Function& function)
  {
    if (options_.threads == 1 || count < 2) {
      for (std::size_t t = 0; t < count; ++t) function(t);
      return;
    }
    const unsigned processors = std::max(1U, std::thread::hardware_concurrency());
    tbb::task_arena arena(
        static_cast<int>(options_.threads == 0 ? processors : std::min(options_.threads, processors)));
    arena.execute([&] { tbb::parallel_for(std::size_t{0}, count, function); });
  }

  void report(const fast::Harvest<D>& harvest, std::size_t tasks)
  {
    const std::scoped_lock lock(mutex_);
    blocks_ += harvest.blocks.size();
    if (blocks_ > options_.cell_budget) fast::throw_over_budget(options_.cell_budget);
    ++done_;
    if (options_.progress && !options_.progress(static_cast<double>(done_) / static_cast<double>(tasks)))
      throw Cancelled("localize_fast: cancelled by the caller");
  }

  const fast::Plan<D>& plan_;
  const Fast_options& options_;
  std::mutex mutex_;
  std::size_t blocks_ = 0;
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
  auto harvests = Runner<D>(plan, options).run();
  Fast_localization<D> result;
  for (auto& harvest : harvests) {
    result.nodes += harvest.nodes;
    result.cells.append(std::move(harvest.blocks));
    harvest.blocks = {};
  }
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
