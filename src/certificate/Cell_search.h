// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_CERTIFICATE_CELL_SEARCH_H
#define CORRAL_SRC_CERTIFICATE_CELL_SEARCH_H

#include "Counted_form.h"

#include <corral/decision/Witness.h>
#include <corral/internal/algebra/Checkpoint.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace corral::certificate {

/// What is known of one box: each polynomial there, and the words of the branch that a checker holds.
template <std::size_t D>
struct Box_forms
{
  std::vector<Counted_form<D>> forms;
  double held = 0;
  std::size_t depth = 1; ///< nodes from the root

  /// Whether the coefficients of one polynomial keep away from zero.
  [[nodiscard]] bool excludes_zero() const
  {
    return std::any_of(forms.begin(), forms.end(),
                       [](const Counted_form<D>& form) { return exact::sign_pattern(form.form).closed() != 0; });
  }
  /// The work of reading the box.
  [[nodiscard]] double size() const
  {
    double sum = 0;
    for (const auto& form : forms) sum += form.size();
    return sum;
  }
  /// Makes the lower halves; the upper ones are left. \param work  grows by what a checker counts.
  [[nodiscard]] Box_forms halve(std::size_t axis, double& work)
  {
    Box_forms lower{{}, held, depth};
    for (auto& form : forms) lower.forms.push_back(certificate::halve(form, axis, work));
    return lower;
  }
  /// Adds to `held` and `depth` what the children of the box have. \param halved  whether an axis is halved.
  template <class Halved>
  void enter_children(const Halved& halved)
  {
    ++depth;
    for (const auto& form : forms) {
      double bit_bound = form.bit_bound;
      for (std::size_t axis = 0; axis < D; ++axis)
        if (halved(axis)) bit_bound += static_cast<double>(form.form.size[axis] - 1);
      held += (D + 1) * form.size() * (words(bit_bound) + 5);
    }
  }
};

/// \brief Cuts a cell into boxes, depth first, until all are proved empty, or a corner shows a zero, or the boxes run
/// out.
template <std::size_t D>
class Cell_search
{
public:
  enum class Outcome { proved, zero, gave_up };

  Cell_search(std::size_t boxes, int sign, const Checkpoint& checkpoint)
      : boxes_left_(boxes), sign_(sign), checkpoint_(checkpoint)
  {}

  [[nodiscard]] Outcome run(Box_forms<D> forms) { return search({std::move(forms), {}, 0}); }

  [[nodiscard]] const std::string& tree() const { return tree_; }
  [[nodiscard]] double work() const { return work_; }
  /// In the cell's own coordinates: a common zero, or a point where the one polynomial has another sign than at the
  /// first corner.
  [[nodiscard]] const Rational_point<D>& zero() const { return zero_; }
  [[nodiscard]] bool changes() const { return changes_; }

private:
  /// A box inside a cell: [index, index + 1] / 2^depth along each axis of the cell.
  struct Piece
  {
    Box_forms<D> box;
    std::array<Integer, D> index{};
    unsigned depth = 0;
  };

  Outcome search(Piece piece)
  {
    constexpr unsigned max_depth = 900;
    work_ += piece.box.size();
    if (piece.box.excludes_zero()) {
      tree_ += 'e';
      return Outcome::proved;
    }
    for (unsigned corner = 0; corner < 1U << D; ++corner)
      if (const auto changes = shows_zero(piece.box.forms, corner)) {
        for (std::size_t axis = 0; axis < D; ++axis) {
          zero_[axis] = Rational(piece.index[axis] + (corner >> axis & 1), Integer(Integer(1) << piece.depth));
          zero_[axis].canonicalize();
        }
        changes_ = *changes;
        return Outcome::zero;
      }
    if (boxes_left_ < (1U << D) || piece.depth == max_depth || work_ > max_work) return Outcome::gave_up;
    boxes_left_ -= 1U << D;
    tree_ += 's';
    ++piece.depth;
    piece.box.enter_children([](std::size_t) { return true; });
    if (piece.box.held > max_branch_words) return Outcome::gave_up;
    for (Integer& i : piece.index) i *= 2;
    return search_children(std::move(piece), D);
  }

  Outcome search_children(Piece piece, std::size_t axes)
  {
    if (axes == 0) {
      if (checkpoint_) checkpoint_();
      return search(std::move(piece));
    }
    const std::size_t axis = axes - 1;
    Piece lower{piece.box.halve(axis, work_), piece.index, piece.depth};
    ++piece.index[axis];
    const Outcome first = search_children(std::move(lower), axis);
    return first == Outcome::proved ? search_children(std::move(piece), axis) : first;
  }

  /// Whether a corner shows a zero: by a change of sign (then `true`), or since it is one itself (`false`).
  [[nodiscard]] std::optional<bool> shows_zero(const std::vector<Counted_form<D>>& forms, unsigned corner) const
  {
    const auto vanishes = [&](const Counted_form<D>& form) { return form.form.corner(corner) == 0; };
    if (std::all_of(forms.begin(), forms.end(), vanishes)) return false;
    if (sign_ != 0 && sgn(forms.front().form.corner(corner)) != sign_) return true;
    return std::nullopt;
  }

  std::size_t boxes_left_;
  int sign_; ///< that of one polynomial at all corners of the cell; 0 for a system
  const Checkpoint& checkpoint_;
  std::string tree_;
  double work_ = 0;
  Rational_point<D> zero_{};
  bool changes_ = false;
};

} // namespace corral::certificate

#endif
