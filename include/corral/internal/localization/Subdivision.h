// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_INTERNAL_LOCALIZATION_SUBDIVISION_H
#define CORRAL_INTERNAL_LOCALIZATION_SUBDIVISION_H

#include <corral/localization/Grid.h>

#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>

namespace corral {

/// \brief A node of the 2^D-tree over a grid: the cells [corner, corner + span) of each axis.
///
/// The grid is padded to a power of two 2^K_i along each axis. A node of level l spans
/// min(2^l, 2^K_i) cells along axis i, so that level 0 is one cell and only the longest axes
/// are cut near the root.
template <std::size_t D>
struct Subdivision_node
{
  unsigned level = 0;
  Cell<D> corner{};
};

/// The shape of the 2^D-tree over a grid.
template <std::size_t D>
class Subdivision_tree
{
public:
  using Node = Subdivision_node<D>;

  explicit Subdivision_tree(const Resolution<D>& resolution) : resolution_(resolution)
  {
    for (std::size_t axis = 0; axis < D; ++axis)
      exponent_[axis] = static_cast<unsigned>(std::bit_width(resolution[axis] - 1));
  }

  [[nodiscard]] Node root() const { return {*std::max_element(exponent_.begin(), exponent_.end()), {}}; }

  /// The number of cells that a node of this level spans along `axis`, padding included.
  [[nodiscard]] std::uint32_t span(unsigned level, std::size_t axis) const
  {
    return std::uint32_t{1} << std::min(level, exponent_[axis]);
  }

  /// Whether the children of a node of this level halve `axis`.
  [[nodiscard]] bool halves(unsigned level, std::size_t axis) const { return level <= exponent_[axis]; }

  /// \brief One bit for each child that exists and holds cells of the grid. Child c lies in the upper half
  /// of axis i where bit i of c is set.
  /// \pre node.level > 0.
  [[nodiscard]] unsigned children(const Node& node) const
  {
    CORRAL_PRECONDITION(node.level > 0, "Subdivision_tree: asked for the children of a cell; expected a larger node");
    unsigned result = 0;
    for (unsigned child = 0; child < (1U << D); ++child) {
      bool exists = true;
      for (std::size_t axis = 0; axis < D; ++axis)
        if ((child >> axis & 1) != 0)
          exists =
              exists && halves(node.level, axis) && node.corner[axis] + span(node.level - 1, axis) < resolution_[axis];
      if (exists) result |= 1U << child;
    }
    return result;
  }

  [[nodiscard]] Node child(const Node& node, unsigned child) const
  {
    Node result{node.level - 1, node.corner};
    for (std::size_t axis = 0; axis < D; ++axis)
      if ((child >> axis & 1) != 0) result.corner[axis] += span(node.level - 1, axis);
    return result;
  }

  /// The first cell after the node along `axis`, clipped to the grid.
  [[nodiscard]] std::uint32_t end(const Node& node, std::size_t axis) const
  {
    return std::min(node.corner[axis] + span(node.level, axis), resolution_[axis]);
  }

private:
  Resolution<D> resolution_;
  std::array<unsigned, D> exponent_{};
};

/// \brief What the subdivision loop subdivides: something that knows where it may vanish.
///
/// A form is a stack with one entry for each level, so that children can be made together and
/// in place. `begin` enters the root and says whether it may hold a zero; `decides(node)` says that
/// the form takes the node over whole (`decide`, which emits its cells); `split` makes the
/// children named by a mask and returns those that may hold a zero; `descend` makes one child of
/// the last split at that level the current node.
// clang-format off
template <class F, std::size_t D>
concept SubdivisionForm =
  requires(F form, const Subdivision_node<D>& node, unsigned mask) {
    { form.begin(node) } -> std::same_as<bool>;
    { form.decides(node) } -> std::same_as<bool>;
    form.decide(node);
    { form.split(node, mask) } -> std::same_as<unsigned>;
    form.descend(node, mask);
  };
// clang-format on

/// The recursive part of `subdivide`. \pre `node` is the current node of `form`.
template <std::size_t D, SubdivisionForm<D> Form>
void subdivide_node(const Subdivision_tree<D>& tree, Form& form, const Subdivision_node<D>& node)
{
  if (form.decides(node)) {
    form.decide(node);
    return;
  }
  const unsigned kept = form.split(node, tree.children(node));
  for (unsigned rest = kept; rest != 0; rest &= rest - 1) {
    const auto child = static_cast<unsigned>(std::countr_zero(rest));
    form.descend(node, child);
    subdivide_node(tree, form, tree.child(node, child));
  }
}

/// \brief The subdivision loop: visits the tree depth first, in the order of the child numbers, and drops every
/// node on which the form has no zero.
/// \throw whatever the form throws.
template <std::size_t D, SubdivisionForm<D> Form>
void subdivide(const Subdivision_tree<D>& tree, Form& form)
{
  const auto root = tree.root();
  if (form.begin(root)) subdivide_node(tree, form, root);
}

} // namespace corral

#endif
