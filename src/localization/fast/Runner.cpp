// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Runner.h"

#include "Fast_plan.h"
#include "Root_seed.h"
#include "Rough_nodes.h"
#include "bands.h"
#include "sorted_blocks.h"

#include <corral/errors.h>
#include <corral/number/Environment.h>

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <mutex>
#include <optional>
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
  Runner(const Search<D>& what, const Grid<D>& grid, double share)
      : what_(what), f_(what.system.front()), grid_(grid), share_(share), plan_(Monomial_shape<D>(f_), grid),
        subdividers_([this] { return make_subdivider(plan_, what_.pulse); })
  {
    plan_.cell_budget = what.cell_budget;
    plan_.tells_rough = what.refines && Rough_nodes<D>::can_decide(f_, grid);
  }

  Found<D> run()
  {
    return in_arena(what_.threads, [&] { return run_here(); });
  }

private:
  Found<D> run_here()
  {
    const Nearest_scope environment;
    const Seed<D> root = root_seed(plan_, f_, grid_, what_.pulse);
    const unsigned level = task_level(plan_);
    Harvest<D> top;
    subdividers_.local()->run(plan_.root_level, {&root, 1}, level, top);
    const Bands<D> bands(std::move(top.seeds));
    const std::size_t tasks = bands.tasks().size();
    lists_.resize(tasks + 1);
    collect(std::move(top), lists_.back(), 0);
    in_parallel(what_.threads, tasks, [&](std::size_t t) {
      auto found = decided_or_left(level, bands.tasks()[t], [&](Task<D> task) {
        Harvest<D> harvest;
        subdividers_.local()->run(level, task, 0, harvest);
        return harvest;
      });
      collect(std::move(found), lists_[t], share_ / (2 * static_cast<double>(tasks)));
    });
    if (is_in_vain()) {
      found_.was_in_vain = true;
      return std::move(found_);
    }
    Block_list<D> others;
    decide_rough(others);
    found_.cells.append(sorted(bands.bands()));
    others.visit([&](const Cell_block<D>& block) { found_.cells.append(block); });
    what_.pulse.advance(share_ - told_);
    return std::move(found_);
  }

  [[nodiscard]] bool is_in_vain() const
  {
    if ((rough_.empty() && found_.hidden.empty()) || what_.pulse.is_stopped()) return false;
    return what_.is_in_vain && what_.is_in_vain();
  }

  /// What `work` finds in a task, or its nodes if the run is stopped meanwhile.
  template <class Work>
  Harvest<D> decided_or_left(unsigned level, Task<D> task, const Work& work)
  {
    try {
      what_.pulse.ask();
      return work(task);
    } catch (const Cancelled&) {
      Harvest<D> nothing;
      for (const auto& seed : task) nothing.left.push_back({level, seed.corner});
      return nothing;
    }
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
    in_parallel(what_.threads, bands.size(), [&](std::size_t b) {
      Block_sorter<D>().sort({lists_.data() + bands[b].first, lists_.data() + bands[b].end}, blocks.data() + begin[b]);
    });
    return blocks;
  }

  void decide_rough(Block_list<D>& blocks)
  {
    if (rough_.empty()) return;
    std::optional<const Rough_nodes<D>> nodes; // made once, before the tasks, unless the run is stopped meanwhile
    auto seeds = std::exchange(rough_, {});
    std::sort(seeds.begin(), seeds.end(),
              [](const auto& a, const auto& b) { return std::tie(a.cut, a.corner) < std::tie(b.cut, b.corner); });
    const auto tasks = grouped<D>(seeds);
    const double share = (share_ - told_) / static_cast<double>(tasks.size());
    (void)decided_or_left(plan_.rough_level, {}, [&](Task<D>) {
      nodes.emplace(f_, grid_, plan_, what_.pulse);
      return Harvest<D>{};
    });
    in_parallel(what_.threads, tasks.size(), [&](std::size_t t) {
      collect(decided_or_left(plan_.rough_level, tasks[t], [&](Task<D> task) { return nodes->decide(task); }), blocks,
              share);
    });
  }

  /// \param share  the part of the whole work that is done by this.
  void collect(Harvest<D>&& harvest, Block_list<D>& blocks, double share)
  {
    {
      const std::scoped_lock lock(mutex_);
      found_.nodes += harvest.nodes;
      plotted_ += harvest.blocks.plotted();
      if (plotted_ > what_.cell_budget) throw_over_budget(what_.cell_budget);
      blocks.append(std::move(harvest.blocks));
      for (const auto& node : harvest.hidden) found_.hidden.push_back(part_of(plan_, node));
      for (const auto& node : harvest.left) found_.left.push_back(part_of(plan_, node));
      std::move(harvest.rough.begin(), harvest.rough.end(), std::back_inserter(rough_));
      told_ += share;
    }
    what_.pulse.advance(share);
  }

  const Search<D>& what_;
  const Polynomial<Rational, D>& f_;
  const Grid<D>& grid_;
  const double share_;
  Plan<D> plan_;
  tbb::enumerable_thread_specific<std::unique_ptr<Subdivider<D>>> subdividers_;
  std::vector<Block_list<D>> lists_; // by task what it found
  std::mutex mutex_;                 // guards what follows
  Found<D> found_;
  std::uint64_t plotted_ = 0;
  std::vector<Seed<D>> rough_;
  double told_ = 0; // of the share, to the pulse
};

} // namespace

template <std::size_t D>
Found<D> run_alone(const Search<D>& what, const Grid<D>& grid, double share)
{
  return Runner<D>(what, grid, share).run();
}

template Found<2> run_alone<2>(const Search<2>&, const Grid<2>&, double);
template Found<3> run_alone<3>(const Search<3>&, const Grid<3>&, double);

} // namespace corral::fast
