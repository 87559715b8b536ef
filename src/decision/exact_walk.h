// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_DECISION_EXACT_WALK_H
#define CORRAL_SRC_DECISION_EXACT_WALK_H

#include "../algebra/on_box.h"

#include <corral/algebra/Checkpoint.h>
#include <corral/errors.h>
#include <corral/localization/Cell_set.h>
#include <corral/localization/Grid.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

/// \file
/// Localisation by exact integers alone. It shares nothing with the engines over floats, the tree included, since it
/// is there to judge them.
namespace corral::exact {

/// Cells [first, end) of each axis.
template <std::size_t D>
struct Cell_range
{
  Cell<D> first{};
  Cell<D> end{};

  [[nodiscard]] bool contains(const Cell<D>& cell) const
  {
    for (std::size_t k = 0; k < D; ++k)
      if (cell[k] < first[k] || cell[k] >= end[k]) return false;
    return true;
  }
  [[nodiscard]] double count() const
  {
    double product = 1;
    for (std::size_t k = 0; k < D; ++k) product *= end[k] - first[k];
    return product;
  }
};

/// What a walk has found.
template <std::size_t D>
struct Walked
{
  Cell_set<D> cells; ///< all that may hold a common zero; `hit` where corners of the one polynomial show it
  std::vector<Cell_range<D>> left; ///< what was not looked at when it was stopped
};

/// \brief Halves the grid, padded to powers of two, and drops the parts on which the Bernstein coefficients of one
/// polynomial have one strict sign.
template <std::size_t D>
class Exact_walk
{
public:
  /// \param system  none of the polynomials is zero.
  /// \param proceed  called at each node with the number of cells settled; `false` stops.
  Exact_walk(const std::vector<Polynomial<Integer, D>>& system, const Grid<D>& grid,
             std::function<bool(double)> proceed)
      : resolution_(grid.resolution()), proceed_(std::move(proceed))
  {
    Node root;
    Rational_box<D> box;
    for (std::size_t k = 0; k < D; ++k) {
      exponent_[k] = static_cast<unsigned>(std::bit_width(resolution_[k] - 1));
      const Rational width = grid.step(k) * span(exponent_[k], k);
      box[k] = Rational_interval(grid.box()[k].lower(), Rational(grid.box()[k].lower() + width));
    }
    root.level = *std::max_element(exponent_.begin(), exponent_.end());
    for (const auto& f : system) drop_twos(root.forms.emplace_back(bernstein_form(f, box)));
    open_.push_back(std::move(root));
  }

  [[nodiscard]] Walked<D> run() &&
  {
    Walked<D> result;
    double settled = 0;
    while (!open_.empty() && proceed_(settled)) {
      Node node = std::move(open_.back());
      open_.pop_back();
      if (excludes_zero(node.forms))
        settled += range(node).count();
      else if (node.level == 0) {
        const bool is_hit = node.forms.size() == 1 && sign_pattern(node.forms.front()).crosses;
        result.cells.append(node.first, is_hit ? Verdict::hit : Verdict::unknown);
        ++settled;
      } else
        split(std::move(node));
    }
    for (const Node& node : open_) result.left.push_back(range(node));
    result.cells.finish();
    return result;
  }

private:
  /// Spans min(2^level, 2^exponent) cells along each axis.
  struct Node
  {
    std::vector<Bernstein_form<D>> forms{};
    Cell<D> first{};
    unsigned level = 0;
  };

  [[nodiscard]] std::uint32_t span(unsigned level, std::size_t axis) const
  {
    return std::uint32_t{1} << std::min(level, exponent_[axis]);
  }

  [[nodiscard]] Cell_range<D> range(const Node& node) const
  {
    Cell_range<D> result{node.first, {}};
    for (std::size_t k = 0; k < D; ++k) result.end[k] = std::min(node.first[k] + span(node.level, k), resolution_[k]);
    return result;
  }

  static bool excludes_zero(const std::vector<Bernstein_form<D>>& forms)
  {
    return std::any_of(forms.begin(), forms.end(),
                       [](const Bernstein_form<D>& form) { return sign_pattern(form).closed() != 0; });
  }

  /// Halves the node along its longest axes. The lowest child comes last, so that it is the next.
  void split(Node node)
  {
    const unsigned level = node.level--;
    const std::size_t begin = open_.size();
    open_.push_back(std::move(node));
    for (std::size_t axis = 0; axis < D; ++axis) {
      if (level > exponent_[axis]) continue;
      for (std::size_t k = begin, end = open_.size(); k < end; ++k) {
        Node lower{{}, open_[k].first, open_[k].level};
        for (auto& form : open_[k].forms) lower.forms.push_back(halve(form, axis));
        open_[k].first[axis] += span(open_[k].level, axis);
        open_.push_back(std::move(lower));
      }
    }
    const auto outside = [&](const Node& child) {
      for (std::size_t k = 0; k < D; ++k)
        if (child.first[k] >= resolution_[k]) return true;
      return false;
    };
    open_.erase(std::remove_if(open_.begin() + static_cast<std::ptrdiff_t>(begin), open_.end(), outside), open_.end());
  }

  Resolution<D> resolution_;
  std::array<unsigned, D> exponent_{}; ///< of the padded grid
  std::function<bool(double)> proceed_;
  std::vector<Node> open_; ///< a stack
};

} // namespace corral::exact

#endif
