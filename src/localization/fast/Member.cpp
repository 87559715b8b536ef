// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Member.h"

#include "Root_seed.h"
#include "Rough_nodes.h"
#include "Term_form.h"
#include "Term_nodes.h"
#include "tasks.h"

#include <algorithm>
#include <iterator>
#include <mutex>
#include <utility>

namespace corral::fast {
namespace {

/// The seeds of the nodes of one kind, by class.
template <std::size_t D>
std::vector<Seed<D>> seeds_of(std::vector<Open_node<D>>& nodes, typename Open_node<D>::Kind kind)
{
  std::vector<Seed<D>> seeds;
  for (auto& node : nodes)
    if (node.kind == kind) seeds.push_back(std::move(node.seed));
  std::stable_sort(seeds.begin(), seeds.end(), [](const auto& a, const auto& b) { return a.cut < b.cut; });
  return seeds;
}

/// A polynomial as a Taylor form.
template <std::size_t D>
class Dense_member final : public Member<D>
{
public:
  Dense_member(const Polynomial<Rational, D>& f, const Grid<D>& grid, bool refines, Pulse& pulse)
      : f_(f), grid_(grid), pulse_(pulse), plan_(Monomial_shape<D>(f), grid)
  {
    plan_.tells_rough = refines && Rough_nodes<D>::can_decide(f, grid);
  }

  [[nodiscard]] const Plan<D>& plan() const override { return plan_; }
  [[nodiscard]] Seed<D> root() const override { return root_seed(plan_, f_, grid_, pulse_); }

  [[nodiscard]] Harvest<D> children(unsigned level, std::vector<Open_node<D>>&& nodes) override
  {
    Harvest<D> found;
    subdivide<D>(plan_, pulse_, level, seeds_of(nodes, Open_node<D>::smooth), level - 1, found);
    return found;
  }

  [[nodiscard]] Harvest<D> leaves(unsigned level, std::vector<Open_node<D>>&& nodes) override
  {
    auto rough = seeds_of(nodes, Open_node<D>::rough);
    Harvest<D> found;
    subdivide<D>(plan_, pulse_, level, seeds_of(nodes, Open_node<D>::smooth), 0, found);
    std::move(found.rough.begin(), found.rough.end(), std::back_inserter(rough)); // the root, if it is near the leaves
    if (rough.empty()) return found;
    Harvest<D> more = rough_nodes().decide(rough);
    found.blocks.append(std::move(more.blocks));
    found.nodes += more.nodes;
    return found;
  }

private:
  const Rough_nodes<D>& rough_nodes()
  {
    std::call_once(once_, [&] { rough_ = std::make_unique<Rough_nodes<D>>(f_, grid_, plan_, pulse_); });
    return *rough_;
  }

  const Polynomial<Rational, D>& f_;
  const Grid<D>& grid_;
  Pulse& pulse_;
  Plan<D> plan_;
  std::once_flag once_;
  std::unique_ptr<Rough_nodes<D>> rough_; // since few polynomials have rough nodes
};

/// A polynomial by its terms.
template <std::size_t D>
class Sparse_member final : public Member<D>
{
public:
  Sparse_member(const Polynomial<Rational, D>& f, const Grid<D>& grid, Pulse& pulse) : nodes_(f, grid, pulse) {}

  [[nodiscard]] const Plan<D>& plan() const override { return nodes_.plan(); }
  [[nodiscard]] Seed<D> root() const override { return {}; }

  [[nodiscard]] Harvest<D> children(unsigned level, std::vector<Open_node<D>>&& nodes) override
  {
    return nodes_.children(level, corners_of(nodes));
  }
  [[nodiscard]] Harvest<D> leaves(unsigned level, std::vector<Open_node<D>>&& nodes) override
  {
    return nodes_.decide(level, corners_of(nodes));
  }

private:
  static std::vector<Cell<D>> corners_of(const std::vector<Open_node<D>>& nodes)
  {
    std::vector<Cell<D>> corners;
    for (const auto& node : nodes) corners.push_back(node.corner);
    return corners;
  }

  Term_nodes<D> nodes_;
};

} // namespace

template <std::size_t D>
std::unique_ptr<Member<D>> Member<D>::make(const Polynomial<Rational, D>& f, const Grid<D>& grid, bool refines,
                                           Pulse& pulse)
{
  if (Term_form<D>::suits(f, grid)) return std::make_unique<Sparse_member<D>>(f, grid, pulse);
  return std::make_unique<Dense_member<D>>(f, grid, refines, pulse);
}

template class Member<2>;
template class Member<3>;

} // namespace corral::fast
