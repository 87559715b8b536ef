// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_LOCALIZATION_FAST_FAST_PLAN_H
#define CORRAL_SRC_LOCALIZATION_FAST_FAST_PLAN_H

#include "Block_list.h"
#include "Monomial_shape.h"
#include "Seed.h"

#include <corral/internal/localization/Subdivision.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace corral::fast {

/// \brief The constants of the error analysis; proved in doc/taylor_form.md.
///
/// A test may zero them to see that the remainder is needed.
struct Rounding
{
  double split = 0;     ///< times the sum of absolute coefficients: rounding of one split
  double evaluate = 0;  ///< times the sum of absolute coefficients: rounding of one evaluation in a block
  double dropped = 0;   ///< times the sum of absolute coefficients that are dropped
  double underflow = 0; ///< added at every step
  double sum = 1;       ///< factor that covers a sum of up to 2^20 terms of one sign
  double step = 1;      ///< factor that covers a few operations on numbers of one sign
};

/// The constants that make every verdict a proof, for a shape of this degree.
[[nodiscard]] Rounding proved_rounding(std::size_t dimension, unsigned degree);

/// \brief What follows from a grid and a shape, and so is the same for all forms of that shape.
template <std::size_t D>
struct Plan
{
  /// Weights of a monomial in the bounds of the first and second derivative along one axis.
  struct Weight
  {
    std::uint32_t position;
    double slope; ///< e
    double curve; ///< e (e - 1)
  };

  /// An undecided cell is looked at on lattices of 2, 4, ... up to this number of pieces a side.
  static constexpr unsigned probe_pieces = D == 2 ? 4 : 2;

  /// Blocks in a leaf: in space two of them lie side by side along the last axis, so that all lanes have work.
  static constexpr std::size_t leaf_blocks = D == 2 ? 1 : 2;

  Plan(Monomial_shape<D> monomials, const Grid<D>& grid);

  /// Whether the children of a node of this level halve `axis`.
  [[nodiscard]] bool halves(unsigned level, std::size_t axis) const
  {
    return tree.halves(level, axis) && (leaf_blocks == 1 || axis + 1 != D || level != leaf_level + 1);
  }

  /// The cells of a node of this level along `axis`, padding included.
  [[nodiscard]] std::uint32_t span(unsigned level, std::size_t axis) const
  {
    const bool whole = level == leaf_level && level < root_level && !halves(level + 1, axis);
    return tree.span(whole ? level + 1 : level, axis);
  }

  Monomial_shape<D> shape;
  Subdivision_tree<D> tree;
  Resolution<D> resolution;
  std::array<unsigned, D> cells_log2;
  unsigned root_level;
  unsigned leaf_level;
  unsigned rough_level;     ///< where nodes that a leaf block would judge badly are told apart
  bool tells_hidden = true; ///< whether hidden nodes are handed over instead of being decided badly
  bool tells_rough = true;  ///< the same for rough nodes
  std::uint64_t cell_budget = std::numeric_limits<std::uint64_t>::max(); ///< most plotted cells of one worker
  Rounding rounding;
  std::vector<double> power_of_half;               ///< power_of_half[d] = 2^-d
  std::vector<double> leaf_scale;                  ///< by position: the scale of the split that makes leaves
  std::vector<double> cell_share;                  ///< by level: the width of a cell, relative to the node
  std::array<std::vector<Weight>, D> weights;      ///< by position, without 1 and x_axis
  std::array<std::size_t, D> linear;               ///< position of x_axis
  std::array<std::size_t, D> square;               ///< position of x_axis^2
  std::array<std::uint32_t, D> leaf_cells;         ///< cells of a leaf block along each axis
  std::array<std::array<double, 16>, D> lattice{}; ///< coordinates of the grid lines of a leaf block
  std::array<double, D> sag; ///< 1 / (2 leaf_cells^2): how far a unit second derivative bends away from a chord
};

/// A node in which the remainder hides the polynomial. A root form of its own, rounded anew, can see more.
template <std::size_t D>
struct Hidden_node
{
  unsigned level;
  Cell<D> corner;
};

/// What a worker found.
template <std::size_t D>
struct Harvest
{
  Block_list<D> blocks;
  std::vector<Seed<D>> seeds;         ///< nodes of `stop_level` that may hold a zero, if the worker had to stop there
  std::vector<Hidden_node<D>> hidden; ///< nodes left undecided
  std::vector<Hidden_node<D>> left;   ///< nodes not decided since the run was stopped
  std::vector<Seed<D>> rough;         ///< nodes of `rough_level` left undecided, to be cut into smaller blocks
  std::uint64_t nodes = 0;            ///< nodes bounded
};

/// \throw Budget_exceeded always.
[[noreturn]] void throw_over_budget(std::uint64_t budget);

extern template struct Plan<2>;
extern template struct Plan<3>;

} // namespace corral::fast

#endif
