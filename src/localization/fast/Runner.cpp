// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Runner.h"

#include "Fast_plan.h"
#include "Root_seed.h"
#include "Rough_nodes.h"
#include "System_run.h"
#include "Term_form.h"
#include "bands.h"
#include "grid_part.h"
#include "sorted_blocks.h"

#include <corral/errors.h>
#include <corral/number/Environment.h>

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <iterator>
#include <memory>
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
  constexpr unsigned least_levels = D == 2 ? 5 : 3; // left to a task
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
      : f_(f), grid_(grid), options_(options), threads_(thread_count(options.threads)),
        plan_(Monomial_shape<D>(f), grid), subdividers_([this] { return make_subdivider(plan_); })
  {
    plan_.cell_budget = options.cell_budget;
    plan_.tells_rough = refines && Rough_nodes<D>::can_decide(f, grid);
  }

  Localization<D> run()
  {
    return in_arena(threads_, [&] { return run_here(); });
  }

private:
  Localization<D> run_here()
  {
    const Nearest_scope environment;
    const Seed<D> root = root_seed(plan_, f_, grid_);
    const unsigned level = task_level(plan_);
    Harvest<D> top;
    subdividers_.local()->run(plan_.root_level, {&root, 1}, level, top);
    const Bands<D> bands(std::move(top.seeds));
    lists_.resize(bands.tasks().size() + 1);
    begin(bands.tasks().size());
    collect(std::move(top), lists_.back(), 0);
    in_parallel(bands.tasks().size(), [&](std::size_t t) {
      Harvest<D> found;
      subdividers_.local()->run(level, bands.tasks()[t], 0, found);
      collect(std::move(found), lists_[t], 1);
    });
    Block_list<D> others = hidden_blocks();
    decide_rough(others);
    result_.cells.append(sorted(bands.bands()));
    if (others.size() > 0) {
      others.visit([&](const Cell_block<D>& block) { result_.cells.append(block); });
      result_.cells.finish();
    }
    return std::move(result_);
  }

  /// Calls `some(k)` for k from 0 to `count`.
  template <class Some>
  void in_parallel(std::size_t count, const Some& some) const
  {
    if (threads_ == 1 || count < 2) {
      for (std::size_t k = 0; k < count; ++k) some(k);
      return;
    }
    const tbb::blocked_range<std::size_t> range(0, count);
    tbb::parallel_for(
        range,
        [&](const auto& part) {
          const Nearest_scope environment;
          for (std::size_t k = part.begin(); k != part.end(); ++k) some(k);
        },
        tbb::simple_partitioner());
  }

  /// What the tasks found. The last list is that of the top of the tree, which is empty if there are tasks.
  [[nodiscard]] std::vector<Cell_block<D>> sorted(std::vector<Band> bands) const
  {
    if (bands.empty()) bands.push_back({0, lists_.size()});
    std::vector<std::size_t> begin{0};
    for (const Band& band : bands) {
      begin.push_back(begin.back());
      for (std::size_t t = band.first; t < band.end; ++t) begin.back() += lists_[t].size();
    }
    std::vector<Cell_block<D>> blocks(begin.back());
    in_parallel(bands.size(), [&](std::size_t b) {
      Block_sorter<D>().sort({lists_.data() + bands[b].first, lists_.data() + bands[b].end}, blocks.data() + begin[b]);
    });
    return blocks;
  }

  void begin(std::size_t tasks)
  {
    tasks_ = tasks;
    done_ = 0;
  }

  /// Localises on the parts of the grid that hidden nodes cover.
  [[nodiscard]] Block_list<D> hidden_blocks()
  {
    Block_list<D> blocks;
    const auto nodes = std::exchange(hidden_, {});
    begin(nodes.size());
    in_parallel(nodes.size(), [&](std::size_t k) {
      Fast_options options;
      options.cell_budget = options_.cell_budget;
      const auto found = localize_part(f_, part(grid_, plan_, nodes[k]), options, true);
      Harvest<D> harvest;
      harvest.nodes = found.counters.bounds;
      append_part(found.cells, nodes[k].corner, harvest.blocks);
      collect(std::move(harvest), blocks, 1);
    });
    return blocks;
  }

  void decide_rough(Block_list<D>& blocks)
  {
    if (rough_.empty()) return;
    const Rough_nodes<D> nodes(f_, grid_, plan_);
    auto seeds = std::exchange(rough_, {});
    std::sort(seeds.begin(), seeds.end(),
              [](const auto& a, const auto& b) { return std::tie(a.cut, a.corner) < std::tie(b.cut, b.corner); });
    const auto tasks = grouped<D>(seeds);
    begin(tasks.size());
    in_parallel(tasks.size(), [&](std::size_t t) { collect(nodes.decide(tasks[t]), blocks, 1); });
  }

  void collect(Harvest<D>&& harvest, Block_list<D>& blocks, std::size_t tasks)
  {
    const std::scoped_lock lock(mutex_);
    result_.counters.bounds += harvest.nodes;
    plotted_ += harvest.blocks.plotted();
    if (plotted_ > options_.cell_budget) throw_over_budget(options_.cell_budget);
    blocks.append(std::move(harvest.blocks));
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
  tbb::enumerable_thread_specific<std::unique_ptr<Subdivider<D>>> subdividers_;
  std::vector<Block_list<D>> lists_; // by task what it found
  std::mutex mutex_;                 // guards what follows
  Localization<D> result_;
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
  if (Term_form<D>::suits(f, grid)) return localize_system({f}, grid, options, refines);
  return Runner<D>(f, grid, options, refines).run();
}

template Localization<2> localize_part<2>(const Polynomial<Rational, 2>&, const Grid<2>&, const Fast_options&, bool);
template Localization<3> localize_part<3>(const Polynomial<Rational, 3>&, const Grid<3>&, const Fast_options&, bool);

} // namespace corral::fast
