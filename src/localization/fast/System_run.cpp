// SPDX-License-Identifier: LGPL-3.0-or-later
#include "System_run.h"

#include "Fast_plan.h"
#include "Member.h"
#include "common_nodes.h"
#include "grid_part.h"
#include "tasks.h"

#include <corral/errors.h>
#include <corral/number/Environment.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <iterator>
#include <memory>
#include <mutex>
#include <utility>

namespace corral::fast {
namespace {

/// Walks down the tree with all polynomials.
template <std::size_t D>
class System_run
{
public:
  System_run(const std::vector<Polynomial<Rational, D>>& system, const Grid<D>& grid, const Fast_options& options,
             bool refines)
      : system_(system), grid_(grid), options_(options), threads_(thread_count(options.threads)), refines_(refines)
  {
    members_.reserve(system.size());
    const Nearest_scope environment;
    for (const auto& f : system) members_.push_back(Member<D>::make(f, grid, refines));
  }

  Localization<D> run()
  {
    Open_nodes<D> root;
    for (const auto& member : members_) root.push_back({{{}, Open_node<D>::smooth, member->root()}});
    in_arena(threads_, [&] { descend(plan().root_level, std::move(root), 1); });
    result_.cells.finish();
    return std::move(result_);
  }

private:
  using Blocks = std::vector<Cell_block<D>>;

  [[nodiscard]] const Plan<D>& plan() const { return members_.front()->plan(); } // all have the same tree

  /// \param share  the part of the whole work that these nodes are taken for.
  void descend(unsigned level, Open_nodes<D> nodes, double share)
  {
    if (level == plan().rough_level) return decide(level, std::move(nodes), share);
    nodes = children(level, std::move(nodes));
    const auto hidden = take_hidden(nodes, level - 1);
    auto groups = cut(std::move(nodes));
    const std::size_t count = groups.size() + hidden.size();
    if (count == 0) return collect({}, 0, share);
    share /= static_cast<double>(count);
    in_parallel(count, [&](std::size_t k) {
      if (k < groups.size())
        descend(level - 1, std::move(groups[k]), share);
      else
        uncover(hidden[k - groups.size()], share);
    });
  }

  [[nodiscard]] Open_nodes<D> children(unsigned level, Open_nodes<D> nodes)
  {
    const Nearest_scope environment;
    std::uint64_t bounds = 0;
    for (std::size_t p = 0; p < members_.size(); ++p) {
      Harvest<D> found = members_[p]->children(level, std::move(nodes[p]));
      bounds += found.nodes;
      nodes[p] = open_nodes(std::move(found));
    }
    collect({}, bounds, 0);
    keep_common(nodes);
    return nodes;
  }

  /// Nodes in groups of at most so many that work on them is neither long nor needs much memory.
  [[nodiscard]] static std::vector<Open_nodes<D>> cut(Open_nodes<D> nodes)
  {
    constexpr std::size_t most = 64;
    const std::size_t count = nodes[0].size();
    std::vector<Open_nodes<D>> groups((count + most - 1) / most);
    for (std::size_t g = 0; g < groups.size(); ++g)
      for (auto& list : nodes) {
        const auto at = [&](std::size_t n) {
          return std::move_iterator(list.begin() + static_cast<std::ptrdiff_t>(std::min(n, count)));
        };
        groups[g].emplace_back(at(g * most), at((g + 1) * most));
      }
    return groups;
  }

  template <class Function>
  void in_parallel(std::size_t count, const Function& function) const
  {
    if (threads_ > 1 && count > 1)
      tbb::parallel_for(std::size_t{0}, count, function);
    else
      for (std::size_t k = 0; k < count; ++k) function(k);
  }

  /// Decides the cells of some nodes.
  void decide(unsigned level, Open_nodes<D> nodes, double share)
  {
    const Nearest_scope environment;
    std::uint64_t bounds = 0;
    std::vector<Hidden_node<D>> hidden;
    Blocks common;
    for (std::size_t p = 0; p < members_.size(); ++p) {
      Harvest<D> found = members_[p]->leaves(level, std::move(nodes[p]));
      bounds += found.nodes;
      hidden.insert(hidden.end(), found.hidden.begin(), found.hidden.end());
      auto blocks = found.blocks.sorted();
      common = p == 0 ? std::move(blocks) : common_cells(common, blocks);
    }
    std::sort(hidden.begin(), hidden.end(), [](const auto& a, const auto& b) { return a.corner < b.corner; });
    const auto same = [](const auto& a, const auto& b) { return a.corner == b.corner; };
    hidden.erase(std::unique(hidden.begin(), hidden.end(), same), hidden.end());
    share /= static_cast<double>(1 + hidden.size());
    collect(common, bounds, share);
    for (const auto& node : hidden) uncover(node, share);
  }

  /// Localises on the part of the grid that is covered by a node which is hidden from some polynomial.
  void uncover(const Hidden_node<D>& node, double share)
  {
    Fast_options options{.threads = threads_, .cell_budget = options_.cell_budget, .progress = {}};
    options.progress = [&, before = 0.0](double now) mutable {
      collect({}, 0, share * (now - std::exchange(before, now)));
      return true;
    };
    const auto found = localize_system(system_, part(grid_, plan(), node), options, refines_);
    Block_list<D> blocks;
    append_part(found.cells, node.corner, blocks);
    collect(blocks.sorted(), found.counters.bounds, 0);
  }

  void collect(const Blocks& blocks, std::uint64_t bounds, double share)
  {
    const std::scoped_lock lock(mutex_);
    result_.counters.bounds += bounds;
    for (const auto& block : blocks) {
      plotted_ += static_cast<unsigned>(std::popcount(block.plotted));
      result_.cells.append(block);
    }
    if (plotted_ > options_.cell_budget) throw_over_budget(options_.cell_budget);
    done_ += share;
    if (options_.progress && !options_.progress(std::min(done_, 1.0)))
      throw Cancelled("localize_fast: cancelled by the caller");
  }

  const std::vector<Polynomial<Rational, D>>& system_;
  const Grid<D>& grid_;
  const Fast_options& options_;
  unsigned threads_;
  bool refines_;
  std::vector<std::unique_ptr<Member<D>>> members_;
  std::mutex mutex_; // guards what follows
  Localization<D> result_;
  std::uint64_t plotted_ = 0;
  double done_ = 0;
};

} // namespace

template <std::size_t D>
Localization<D> localize_system(const std::vector<Polynomial<Rational, D>>& system, const Grid<D>& grid,
                                const Fast_options& options, bool refines)
{
  return System_run<D>(system, grid, options, refines).run();
}

template Localization<2> localize_system<2>(const std::vector<Polynomial<Rational, 2>>&, const Grid<2>&,
                                            const Fast_options&, bool);
template Localization<3> localize_system<3>(const std::vector<Polynomial<Rational, 3>>&, const Grid<3>&,
                                            const Fast_options&, bool);

} // namespace corral::fast
