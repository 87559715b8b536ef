// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_DECISION_EXACT_WALK_H
#define CORRAL_SRC_DECISION_EXACT_WALK_H

#include "../algebra/on_box.h"

#include <corral/Run_options.h>
#include <corral/errors.h>
#include <corral/localization/Raster_builder.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <utility>
#include <vector>

/// \file
/// Localisation by exact integers alone. It shares nothing with the engines over floats, the tree included, since it
/// is there to judge them.
namespace corral::exact {

/// \brief Halves the grid, padded to powers of two, and drops the parts on which the Bernstein coefficients of one
/// polynomial have one strict sign.
template <std::size_t D>
class Exact_walk
{
public:
  /// \param system  none of the polynomials is zero.
  Exact_walk(const std::vector<Polynomial<Integer, D>>& system, Grid<D> the_grid, Run_options run)
      : grid_(std::move(the_grid)), resolution_(grid_.resolution()), run_(std::move(run))
  {
    Node root;
    Rational_box<D> box;
    for (std::size_t k = 0; k < D; ++k) {
      exponent_[k] = static_cast<unsigned>(std::bit_width(resolution_[k] - 1));
      const Rational width = grid_.step(k) * span(exponent_[k], k);
      box[k] = Rational_interval(grid_.box()[k].lower(), Rational(grid_.box()[k].lower() + width));
    }
    root.level = *std::max_element(exponent_.begin(), exponent_.end());
    for (const auto& f : system) drop_twos(root.forms.emplace_back(bernstein_form(f, box)));
    open_.push_back(std::move(root));
  }

  /// All cells that may hold a common zero; `hit` where corners of the one polynomial show it.
  [[nodiscard]] Raster<D> run() &&
  {
    Raster_builder<D> result;
    double settled = 0;
    while (!open_.empty() && goes_on(settled / grid_.cell_count())) {
      Node node = std::move(open_.back());
      open_.pop_back();
      if (excludes_zero(node.forms))
        settled += range(node).count();
      else if (node.level == 0) {
        const bool is_hit = node.forms.size() == 1 && sign_pattern(node.forms.front()).crosses;
        result.append(node.first, is_hit ? Verdict::hit : Verdict::unknown);
        ++settled;
      } else
        split(std::move(node));
    }
    for (const Node& node : open_) result.leave(range(node));
    return std::move(result).finish(grid_, true);
  }

private:
  /// Spans min(2^level, 2^exponent) cells along each axis.
  struct Node
  {
    std::vector<Bernstein_form<D>> forms{};
    Cell<D> first{};
    unsigned level = 0;
  };

  [[nodiscard]] bool goes_on(double done) const
  {
    if (run_.progress) run_.progress(done);
    return !run_.stop.stop_requested();
  }

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

  Grid<D> grid_;
  Resolution<D> resolution_;
  std::array<unsigned, D> exponent_{}; ///< of the padded grid
  Run_options run_;
  std::vector<Node> open_; ///< a stack
};

} // namespace corral::exact

#endif
