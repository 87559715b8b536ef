// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_DECISION_IDEAL_RASTER_H
#define CORRAL_DECISION_IDEAL_RASTER_H

#include <corral/algebra/real_roots.h>
#include <corral/decision/Cell_decision.h>
#include <corral/decision/Ideal_result.h>
#include <corral/localization/Raster.h>
#include <corral/polynomial/Polynomial.h>

#include <cstddef>
#include <memory>

/// \file
/// The exact decision of closed cells: `hit` or `empty`, proved. Method and proof: doc/exact.md.
namespace corral {

/// \brief Decides closed cells of one grid exactly, for one polynomial.
///
/// In one and two dimensions the verdict is never `unknown`. In three dimensions it can be for high degrees, where a
/// closed piece may lie strictly inside a cell; the decision then says why.
/// What is costly (square-free part, resultants) is computed when first needed and kept, so that one object should
/// decide many cells. An object must not be used by two threads at once.
template <std::size_t D>
class Cell_decider
{
  static_assert(D >= 1 && D <= 3, "cells are decided exactly in one, two and three dimensions: in more, no method is "
                                  "known here for pieces of the zero set inside a cell");

public:
  /// \param checkpoint  called now and then during long decisions; it stops them by throwing.
  /// \throw Invalid_input if `f` is zero.
  Cell_decider(const Polynomial<Rational, D>& f, const Grid<D>& grid, Checkpoint checkpoint = {},
               Witnesses witnesses = Witnesses::all);
  Cell_decider(Cell_decider&&) noexcept;
  Cell_decider& operator=(Cell_decider&&) noexcept;
  ~Cell_decider();

  /// \brief The square-free part of the polynomial. Witnesses speak of it; it has the same zeros.
  [[nodiscard]] const Polynomial<Integer, D>& square_free() const;

  /// \brief The verdict on one closed cell.
  /// \throw Invalid_input unless the cell lies in the grid.
  /// \par Complexity  With n coefficients in a dense polynomial of degree d: n*d operations on integers where their
  /// signs decide (nearly always), more near tangencies and singular points, where at worst a resultant of degree d^2
  /// is needed.
  [[nodiscard]] Cell_decision<D> decide(const Cell<D>& cell);

private:
  struct State;
  std::unique_ptr<State> state_;
};

/// \brief Decides every unknown cell of `candidates` exactly.
/// Only the calling thread calls back. When it is stopped the remaining cells stay unknown.
/// \param candidates  a raster of f: every cell with a zero is plotted, and what is called hit is proved. Cells that it
///        calls empty or hit are taken over, and so are those that it has not visited, as unknown.
/// \throw Invalid_input if `f` is zero, or `candidates` is not guaranteed. Contradiction if `recheck` is asked for and
///        finds one.
/// \par Complexity  See `Cell_decider::decide`; memory for the cells and for one polynomial's resultants.
template <std::size_t D>
[[nodiscard]] Ideal_raster<D> ideal_raster(const Polynomial<Rational, D>& f, const Raster<D>& candidates,
                                           const Run_options& run = {}, const Ideal_raster_options& options = {});

/// Higher dimensions do not compile, and `Cell_decider` says why.
template <std::size_t D>
  requires(D > 3)
[[nodiscard]] Ideal_raster<D> ideal_raster(const Polynomial<Rational, D>& f, const Raster<D>& candidates,
                                           const Run_options& = {}, const Ideal_raster_options& = {})
{
  (void)Cell_decider<D>(f, candidates.grid());
  return {candidates};
}

} // namespace corral

#endif
