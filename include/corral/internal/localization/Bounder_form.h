// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_INTERNAL_LOCALIZATION_BOUNDER_FORM_H
#define CORRAL_INTERNAL_LOCALIZATION_BOUNDER_FORM_H

#include <corral/Run_options.h>
#include <corral/bounders/Range_bounder.h>
#include <corral/internal/localization/Subdivision.h>
#include <corral/localization/Raster_builder.h>
#include <corral/polynomial/evaluate.h>

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace corral {

/// How cells of grid size are treated.
struct Cell_options
{
  bool sample = false;       ///< look for changes of sign at the corners
  unsigned refine_depth = 0; ///< how often a cell is halved to prove it empty
};

/// \brief Model of `SubdivisionForm`: bounds every box afresh from the polynomials, as the paper does.
///
/// A node is kept while no polynomial excludes it. At grid size, point sampling may accept a cell (a change of sign
/// of the only polynomial between corners, or a corner where every polynomial is exactly zero) and refinement may
/// drop one all of whose subcells are excluded. A cell is a hit by the former only. When it is stopped it keeps every
/// node that it has not bounded and takes it over whole, as one that was not visited.
///
/// \tparam B  model of `RangeBounder`.
/// \tparam F  what tells the values at corners: the polynomial that B bounds, or B itself.
template <RangeBounder B, class F = typename B::Polynomial>
class Bounder_form
{
public:
  using I = typename B::Interval;
  static constexpr std::size_t D = B::dimension;
  using Node = Subdivision_node<D>;
  using System = std::vector<F>;

  /// \throw Invalid_input unless there is one bounder for each polynomial, in the same order.
  /// \pre An `Arithmetic_scope` of I is alive, as the arithmetic of I checks where assertions are on.
  Bounder_form(System system, std::vector<B> bounders, Grid<D> grid, const Run_options& run,
               const Cell_options& options)
      : system_(std::move(system)), bounders_(std::move(bounders)), grid_(std::move(grid)), run_(run),
        options_(options), budget_(run.cell_budget.value_or(50'000'000)), tree_(grid_.resolution()),
        stack_(tree_.root().level + 1), middles_(stack_.size())
  {
    if (system_.size() != bounders_.size())
      throw Invalid_input("localize: given " + detail::quantity(bounders_.size(), "bounder") + " for "
                          + detail::quantity(system_.size(), "polynomial") + "; expected one for each");
  }

  bool begin(const Node& root)
  {
    has_begun_ = true;
    Sides& sides = stack_[root.level];
    for (std::size_t axis = 0; axis < D; ++axis) sides[axis] = {line(axis, 0), line(axis, tree_.end(root, axis))};
    return may_vanish(box_of(sides));
  }

  [[nodiscard]] bool decides(const Node& node) const { return node.level == 0 || stopped_; }

  void decide(const Node& cell)
  {
    if (stopped_) return leave(cell);
    report(cell);
    if (options_.sample && has_sampled_zero(stack_[0])) return emit(cell, Verdict::hit);
    if (options_.refine_depth == 0 || survives(grid_.cell_box(cell.corner), options_.refine_depth))
      emit(cell, Verdict::unknown);
  }

  unsigned split(const Node& node, unsigned children)
  {
    ++counters_.subdivisions;
    middles_[node.level] = middle(node);
    unsigned kept = 0;
    for (unsigned rest = children; rest != 0; rest &= rest - 1) {
      const auto child = static_cast<unsigned>(std::countr_zero(rest));
      if (may_vanish(box_of(child_sides(node, child, middles_[node.level]))))
        kept |= 1U << child;
      else
        report(tree_.child(node, child));
    }
    return kept;
  }

  void descend(const Node& node, unsigned child)
  {
    stack_[node.level - 1] = child_sides(node, child, middles_[node.level]);
  }

  /// What was found. \throw Invalid_input if the loop has not begun.
  [[nodiscard]] Raster_builder<D> take()
  {
    if (!has_begun_) detail::refuse_input("Bounder_form: asked before the subdivision has run; expected it to have");
    return std::move(result_);
  }
  [[nodiscard]] const Work_counters& counters() const { return counters_; }

private:
  using Clock = std::chrono::steady_clock;

  /// The two ends of each side of a box, each an enclosure of a grid line.
  using Sides = std::array<std::pair<I, I>, D>;

  [[nodiscard]] I line(std::size_t axis, std::uint32_t index) const { return enclose<I>(grid_.line(axis, index)); }

  static Box<I, D> box_of(const Sides& sides)
  {
    Box<I, D> box;
    for (std::size_t axis = 0; axis < D; ++axis) box[axis] = hull(sides[axis].first, sides[axis].second);
    return box;
  }

  // Where the children of a node meet; the end of the node where they do not halve the axis.
  [[nodiscard]] std::array<I, D> middle(const Node& node) const
  {
    std::array<I, D> result;
    for (std::size_t axis = 0; axis < D; ++axis)
      result[axis] = line(axis, tree_.end({node.level - 1, node.corner}, axis));
    return result;
  }

  [[nodiscard]] Sides child_sides(const Node& node, unsigned child, const std::array<I, D>& middle) const
  {
    Sides sides = stack_[node.level];
    for (std::size_t axis = 0; axis < D; ++axis)
      ((child >> axis & 1) != 0 ? sides[axis].first : sides[axis].second) = middle[axis];
    return sides;
  }

  bool may_vanish(const Box<I, D>& box)
  {
    return std::all_of(bounders_.begin(), bounders_.end(), [&](const B& bounder) {
      stopped_ = stopped_ || run_.stop.stop_requested();
      if (stopped_) return true; // nothing is known of the box
      ++counters_.bounds;
      if (run_.progress) tell_if_slow();
      return contains_zero(bounder.bound(box));
    });
  }

  [[nodiscard]] bool has_sampled_zero(const Sides& sides) const
  {
    bool has_positive = false;
    bool has_negative = false;
    for (unsigned corner = 0; corner < (1U << D); ++corner) {
      std::array<I, D> point;
      for (std::size_t axis = 0; axis < D; ++axis)
        point[axis] = (corner >> axis & 1) != 0 ? sides[axis].second : sides[axis].first;
      bool is_zero = true;
      for (const auto& f : system_) {
        const I value = value_at(f, point);
        is_zero = is_zero && Interval_traits<I>::lower_sign(value) == 0 && Interval_traits<I>::upper_sign(value) == 0;
        has_positive = has_positive || strict_sign(value) > 0;
        has_negative = has_negative || strict_sign(value) < 0;
      }
      if (is_zero) return true;
    }
    return system_.size() == 1 && has_positive && has_negative;
  }

  static I value_at(const typename B::Polynomial& f, const std::array<I, D>& point) { return evaluate(f, point); }
  static I value_at(const B& bounder, const std::array<I, D>& point) { return bounder.bound(point); }

  // Whether some subcell is not excluded.
  bool survives(const Rational_box<D>& box, unsigned depth)
  {
    ++counters_.subdivisions;
    bool is_kept = false;
    for (unsigned child = 0; child < (1U << D); ++child) {
      Rational_box<D> half = box;
      for (std::size_t axis = 0; axis < D; ++axis) {
        const Rational middle = (box[axis].lower() + box[axis].upper()) / 2;
        half[axis] = (child >> axis & 1) != 0 ? Rational_interval(middle, box[axis].upper())
                                              : Rational_interval(box[axis].lower(), middle);
      }
      if (may_vanish(enclose<I>(half)) && (depth == 1 || survives(half, depth - 1))) is_kept = true;
    }
    return is_kept;
  }

  void emit(const Node& cell, Verdict verdict)
  {
    if (++emitted_ > budget_)
      throw Budget_exceeded("localize: more than " + std::to_string(budget_)
                            + " cells are not empty; expected at most that many");
    result_.append(cell.corner, verdict);
  }

  void leave(const Node& node)
  {
    Cell<D> end;
    for (std::size_t axis = 0; axis < D; ++axis) end[axis] = tree_.end(node, axis);
    result_.leave({node.corner, end});
  }

  // Adds the node's share of the grid to what is done.
  void report(const Node& node)
  {
    double share = 1;
    for (std::size_t axis = 0; axis < D; ++axis)
      share *= (tree_.end(node, axis) - node.corner[axis]) / static_cast<double>(grid_.resolution()[axis]);
    done_ += share;
    if (++reports_ % 256 == 0) tell();
  }

  // Bounds over exact fractions may take long each, so that nodes are not done for many seconds.
  void tell_if_slow()
  {
    const auto now = Clock::now();
    if (now - told_ > std::chrono::milliseconds(100)) tell();
  }

  void tell()
  {
    told_ = Clock::now();
    if (run_.progress) run_.progress(std::min(done_, 1.0));
  }

  System system_;
  std::vector<B> bounders_;
  Grid<D> grid_;
  Run_options run_;
  Cell_options options_;
  std::uint64_t budget_;
  Subdivision_tree<D> tree_;
  std::vector<Sides> stack_;
  std::vector<std::array<I, D>> middles_; // of the last split at each level
  Raster_builder<D> result_;
  Work_counters counters_;
  std::uint64_t emitted_ = 0;
  std::uint64_t reports_ = 0;
  Clock::time_point told_ = Clock::now();
  double done_ = 0;
  bool has_begun_ = false;
  bool stopped_ = false;
};

} // namespace corral

#endif
