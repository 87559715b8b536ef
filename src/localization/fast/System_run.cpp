// SPDX-License-Identifier: LGPL-3.0-or-later
#include "System_run.h"

#include "Fast_plan.h"
#include "Member.h"
#include "common_nodes.h"
#include "tasks.h"

#include <corral/errors.h>
#include <corral/number/Environment.h>

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
  System_run(const Search<D>& what, const Grid<D>& grid) : what_(what)
  {
    members_.reserve(what.system.size());
    const Nearest_scope environment;
    for (const auto& f : what.system) members_.push_back(Member<D>::make(f, grid, what.refines, what.pulse));
  }

  /// \param share  of the whole work.
  Found<D> run(double share)
  {
    Open_nodes<D> root;
    for (const auto& member : members_) root.push_back({{{}, Open_node<D>::smooth, member->root()}});
    in_arena(what_.threads, [&] { descend(plan().root_level, std::move(root), share); });
    return std::move(found_);
  }

private:
  using Blocks = std::vector<Cell_block<D>>;

  [[nodiscard]] const Plan<D>& plan() const { return members_.front()->plan(); } // all have the same tree

  /// Decides nodes, or leaves them if the run is stopped before anything is known of them.
  /// \param share  the part of the whole work that these nodes are taken for.
  void descend(unsigned level, Open_nodes<D> nodes, double share)
  {
    std::vector<Hidden_node<D>> all;
    for (const auto& node : nodes[0]) all.push_back({level, node.corner});
    try {
      what_.pulse.ask();
      decide_or_cut(level, std::move(nodes), share);
    } catch (const Cancelled&) {
      const std::scoped_lock lock(mutex_);
      for (const auto& node : all) found_.left.push_back(part_of(plan(), node));
    }
  }

  void decide_or_cut(unsigned level, Open_nodes<D> nodes, double share)
  {
    if (level == plan().rough_level) return decide(level, std::move(nodes), share);
    nodes = children(level, std::move(nodes));
    const auto hidden = take_hidden(nodes, level - 1);
    auto groups = cut(std::move(nodes));
    collect({}, hidden, 0, groups.empty() ? share : 0);
    share /= static_cast<double>(groups.size());
    in_parallel(what_.threads, groups.size(), [&](std::size_t k) { descend(level - 1, std::move(groups[k]), share); });
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
    collect({}, {}, bounds, 0);
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
    collect(common, hidden, bounds, share);
  }

  void collect(const Blocks& blocks, const std::vector<Hidden_node<D>>& hidden, std::uint64_t bounds, double share)
  {
    {
      const std::scoped_lock lock(mutex_);
      found_.nodes += bounds;
      for (const auto& block : blocks) {
        plotted_ += static_cast<unsigned>(std::popcount(block.plotted));
        found_.cells.append(block);
      }
      if (plotted_ > what_.cell_budget) throw_over_budget(what_.cell_budget);
      for (const auto& node : hidden) found_.hidden.push_back(part_of(plan(), node));
    }
    what_.pulse.advance(share);
  }

  const Search<D>& what_;
  std::vector<std::unique_ptr<Member<D>>> members_;
  std::mutex mutex_; // guards what follows
  Found<D> found_;
  std::uint64_t plotted_ = 0;
};

} // namespace

template <std::size_t D>
Found<D> run_system(const Search<D>& what, const Grid<D>& grid, double share)
{
  return System_run<D>(what, grid).run(share);
}

template Found<2> run_system<2>(const Search<2>&, const Grid<2>&, double);
template Found<3> run_system<3>(const Search<3>&, const Grid<3>&, double);

} // namespace corral::fast
