// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_LOCALIZATION_FAST_TERM_BOUNDS_H
#define CORRAL_SRC_LOCALIZATION_FAST_TERM_BOUNDS_H

#include "Fast_plan.h"
#include "Term_form.h"

#include <corral/internal/localization/Subdivision.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace corral::fast {

/// The grid as outward-rounded intervals.
template <std::size_t D>
struct Grid_lines
{
  explicit Grid_lines(const Grid<D>& grid)
  {
    for (std::size_t axis = 0; axis < D; ++axis) {
      origin[axis] = enclose<Outward_interval>(grid.box()[axis].lower());
      step[axis] = enclose<Outward_interval>(grid.step(axis));
    }
  }
  std::array<Outward_interval, D> origin;
  std::array<Outward_interval, D> step;
};

/// \brief A node's form of low degree, by Taylor's formula from the centre; its coordinates are those of the node.
template <std::size_t D>
struct Low_form
{
  std::vector<double> coefficients; ///< in the order of the plan's shape
  double remainder = 0;
  double norm = 0;     ///< at least the sum of absolute coefficients
  double spread = 0;   ///< at least what the terms other than the constant one take from its absolute value
  double gradient = 0; ///< the least in the node, about
  double width = 0;    ///< of a cell, relative to the node

  [[nodiscard]] bool excludes_zero() const;

  /// Whether the remainder is small beside the change over a cell, so that the form can decide cells.
  [[nodiscard]] bool is_clear() const;

  /// The node as a seed. \pre is_clear().
  [[nodiscard]] Seed<D> seed(const Cell<D>& corner, const Rounding& rounding) const;
};

/// \brief What the terms of a polynomial show of nodes and cells; proofs in doc/taylor_form.md.
///
/// It remembers the powers of the coordinates of grid lines, which neighbours share. \pre A `Nearest_scope` lives on
/// the thread.
template <std::size_t D>
class Term_bounds
{
public:
  using Node = Subdivision_node<D>;

  /// The arguments outlive this object.
  Term_bounds(const Term_form<D>& form, const Grid_lines<D>& lines, const Subdivision_tree<D>& tree)
      : form_(form), lines_(lines), tree_(tree)
  {}

  /// Whether the sum of the terms over the node has one sign.
  [[nodiscard]] bool excludes_zero(const Node& node);

  /// The same for each of the 2^D pieces of a cell that is halved along every axis.
  [[nodiscard]] bool excludes_zero_in_pieces(const Cell<D>& cell);

  /// Whether two corners of a cell are proved to have values that are not of the same strict sign.
  [[nodiscard]] bool changes_sign(const Cell<D>& cell);

  [[nodiscard]] Low_form<D> low_form(const Node& node);

private:
  using Interval = Outward_interval;
  using Powers = std::vector<Interval>;
  using Terms = std::vector<typename Term_form<D>::Term>;

  using Place = std::array<std::uint64_t, D>; // in half cells from the origin of the grid

  [[nodiscard]] static Place corner_of(const Node& node);
  [[nodiscard]] Interval coordinate(std::size_t axis, std::uint64_t half_cells) const;
  const Powers& on_line(std::size_t axis, std::uint64_t half_cells);
  void enter_box(const Place& corner, const Place& size);
  void enter_box(const Node& node);
  [[nodiscard]] bool box_excludes_zero() const;
  [[nodiscard]] Interval over_box(const Terms& terms) const;
  [[nodiscard]] Interval at(const Terms& terms, const Place& place);
  [[nodiscard]] static Interval sum(const Terms& terms, const std::array<const Powers*, D>& powers);
  [[nodiscard]] Interval half_sides(const Exponents<D>& exponents, const Node& node) const;

  const Term_form<D>& form_;
  const Grid_lines<D>& lines_;
  const Subdivision_tree<D>& tree_;
  std::array<std::unordered_map<std::uint64_t, Powers>, D> known_; // by coordinate in half cells
  std::array<Powers, D> box_;                                      // their ranges over the box entered last
};

extern template struct Low_form<2>;
extern template struct Low_form<3>;
extern template class Term_bounds<2>;
extern template class Term_bounds<3>;

} // namespace corral::fast

#endif
