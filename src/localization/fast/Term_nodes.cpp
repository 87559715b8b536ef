// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Term_nodes.h"

#include "tasks.h"

#include <utility>

namespace corral::fast {
namespace {

/// Walks down the tree below some nodes by the terms of a polynomial.
template <std::size_t D>
class Term_walk
{
public:
  using Node = Subdivision_node<D>;

  Term_walk(const Plan<D>& plan, const Term_form<D>& form, const Grid_lines<D>& lines, Pulse& pulse)
      : plan_(plan), pulse_(pulse), bounds_(form, lines, plan.tree)
  {}

  /// The children that are not dropped.
  void children(const Node& node)
  {
    for_each_open_child(node, [&](const Node& child) {
      found_.seeds.emplace_back().corner = child.corner; // without coefficients
    });
  }

  /// Adds a node to the seeds, or decides its cells one by one.
  void leaf(const Node& node)
  {
    ++found_.nodes;
    pulse_.ask();
    const auto form = bounds_.low_form(node);
    if (form.excludes_zero()) return;
    if (form.is_clear())
      found_.seeds.push_back(form.seed(node.corner, plan_.rounding));
    else
      decide(node);
  }

  [[nodiscard]] Harvest<D> harvest() && { return std::move(found_); }

private:
  template <class Function>
  void for_each_open_child(const Node& node, const Function& function)
  {
    const unsigned existing = plan_.tree.children(node);
    for (unsigned k = 0; k < 1U << D; ++k) {
      if ((existing >> k & 1) == 0) continue;
      const Node child = plan_.tree.child(node, k);
      ++found_.nodes;
      pulse_.ask();
      if (!bounds_.excludes_zero(child)) function(child);
    }
  }

  void decide(const Node& node)
  {
    if (node.level > plan_.leaf_level) return for_each_open_child(node, [&](const Node& child) { decide(child); });
    Cell_block<D> block;
    for (std::size_t axis = 0; axis < D; ++axis) block.index[axis] = node.corner[axis] / block_side<D>;
    decide_in(node, block);
    if (block.plotted != 0) found_.blocks.add(block);
  }

  void decide_in(const Node& node, Cell_block<D>& block)
  {
    if (node.level > 0) return for_each_open_child(node, [&](const Node& child) { decide_in(child, block); });
    const std::uint64_t cell = std::uint64_t{1} << bit_of<D>(node.corner);
    const bool is_hit = bounds_.changes_sign(node.corner);
    if (!is_hit && (bounds_.excludes_zero_in_pieces(node.corner) || bounds_.low_form(node).excludes_zero())) return;
    block.plotted |= cell;
    if (is_hit) block.hit |= cell;
  }

  const Plan<D>& plan_;
  Pulse& pulse_;
  Term_bounds<D> bounds_;
  Harvest<D> found_;
};

} // namespace

template <std::size_t D>
Term_nodes<D>::Term_nodes(const Polynomial<Rational, D>& f, const Grid<D>& grid, Pulse& pulse)
    : pulse_(pulse), plan_(Monomial_shape<D>(Term_form<D>::model_monomials()), grid), form_(f, plan_.shape.exponents()),
      lines_(grid)
{
  plan_.tells_rough = plan_.tells_hidden = false;
}

template <std::size_t D>
Harvest<D> Term_nodes<D>::children(unsigned level, const std::vector<Cell<D>>& corners) const
{
  Term_walk<D> walk(plan_, form_, lines_, pulse_);
  for (const auto& corner : corners) walk.children({level, corner});
  return std::move(walk).harvest();
}

template <std::size_t D>
Harvest<D> Term_nodes<D>::decide(unsigned level, const std::vector<Cell<D>>& corners) const
{
  Term_walk<D> walk(plan_, form_, lines_, pulse_);
  for (const auto& corner : corners) walk.leaf({level, corner});
  Harvest<D> found = std::move(walk).harvest();
  const auto models = std::exchange(found.seeds, {});
  subdivide<D>(plan_, pulse_, level, models, 0, found);
  return found;
}

template class Term_nodes<2>;
template class Term_nodes<3>;

} // namespace corral::fast
