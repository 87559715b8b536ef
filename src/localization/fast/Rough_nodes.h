// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_LOCALIZATION_FAST_ROUGH_NODES_H
#define CORRAL_SRC_LOCALIZATION_FAST_ROUGH_NODES_H

#include "Term_nodes.h"
#include "tasks.h"

#include <corral/localization/Grid.h>
#include <corral/polynomial/Polynomial.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace corral::fast {

/// \brief Decides rough nodes by terms if these are few. Else twice: as all others, and on a grid in which a leaf block
/// is as large as a cell here.
template <std::size_t D>
class Rough_nodes
{
public:
  /// Whether the terms are few or there is a grid that is fine enough.
  [[nodiscard]] static bool can_decide(const Polynomial<Rational, D>& f, const Grid<D>& grid);

  /// \param plan  of f on the grid. \pre can_decide(f, grid); the pulse outlives this object.
  Rough_nodes(const Polynomial<Rational, D>& f, const Grid<D>& grid, const Plan<D>& plan, Pulse& pulse);

  /// What is found in some nodes. \pre Those of one class stand side by side.
  [[nodiscard]] Harvest<D> decide(Task<D> seeds) const;

private:
  /// What it takes to decide them twice.
  struct Twice
  {
    Twice(const Polynomial<Rational, D>& f, const Grid<D>& grid, const Plan<D>& given, Pulse& for_all);
    [[nodiscard]] Harvest<D> decide(Task<D> seeds) const;

    Pulse& pulse;
    std::vector<Polynomial<Rational, D>> system; ///< f alone
    Plan<D> plan;
    Grid<D> fine_grid;
    Plan<D> fine_plan;
  };

  unsigned level_;
  std::optional<Term_nodes<D>> by_terms_;
  std::optional<Twice> twice_;
};

extern template class Rough_nodes<2>;
extern template class Rough_nodes<3>;

} // namespace corral::fast

#endif
