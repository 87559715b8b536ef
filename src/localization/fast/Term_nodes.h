// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_LOCALIZATION_FAST_TERM_NODES_H
#define CORRAL_SRC_LOCALIZATION_FAST_TERM_NODES_H

#include "Fast_plan.h"
#include "Pulse.h"
#include "Term_bounds.h"
#include "Term_form.h"

#include <corral/localization/Grid.h>
#include <corral/polynomial/Polynomial.h>

#include <cstddef>
#include <vector>

namespace corral::fast {

/// \brief Subdivides and decides nodes by the terms of a polynomial instead of a dense Taylor form.
///
/// A node near the leaves gets a form of low degree if its remainder is small beside what changes over a cell, and goes
/// the way of all other nodes. Else its cells are bounded one by one. \pre A `Nearest_scope` lives on the thread.
template <std::size_t D>
class Term_nodes
{
public:
  /// \param pulse  asked at every node; it outlives this object.
  Term_nodes(const Polynomial<Rational, D>& f, const Grid<D>& grid, Pulse& pulse);

  /// The plan of the forms of low degree; its tree is that of the grid.
  [[nodiscard]] const Plan<D>& plan() const { return plan_; }

  /// The children that may hold a zero, as seeds without coefficients.
  [[nodiscard]] Harvest<D> children(unsigned level, const std::vector<Cell<D>>& corners) const;

  /// The cells of nodes. \pre The level is `rough_level`.
  [[nodiscard]] Harvest<D> decide(unsigned level, const std::vector<Cell<D>>& corners) const;

private:
  Pulse& pulse_;
  Plan<D> plan_;
  Term_form<D> form_;
  Grid_lines<D> lines_;
};

extern template class Term_nodes<2>;
extern template class Term_nodes<3>;

} // namespace corral::fast

#endif
