// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_DECISION_IDEAL_SYSTEM_H
#define CORRAL_DECISION_IDEAL_SYSTEM_H

#include <corral/decision/ideal_raster.h>

#include <cstddef>
#include <memory>
#include <vector>

/// \file
/// The exact decision of closed cells for two equations f = g = 0: points of the plane, curves in space.
namespace corral {

/// \brief Decides closed cells of one grid for the common zeros of two polynomials.
///
/// In the plane the verdict is never `unknown`: a common factor is decided as a curve, the rest are finitely many
/// points. In space a cell is a hit if a common zero lies on one of its facets, which is decided exactly in their
/// planes, or if a closed piece lies strictly inside, which is decided by its extreme point. It can be unknown for high
/// degrees, and the decision then says why. An object must not be used by two threads at once.
template <std::size_t D>
class System_decider
{
  static_assert(D == 2 || D == 3,
                "systems of two polynomials are decided exactly in two and three dimensions: points of "
                "the plane and curves in space");

public:
  /// \param system  one or two polynomials, none of them zero.
  /// \param checkpoint  called now and then during long decisions; it stops them by throwing.
  /// \throw Invalid_input if a polynomial is zero, or there are none or more than two.
  System_decider(const std::vector<Polynomial<Rational, D>>& system, const Grid<D>& grid, Checkpoint checkpoint = {},
                 Witnesses witnesses = Witnesses::all);
  System_decider(System_decider&&) noexcept;
  System_decider& operator=(System_decider&&) noexcept;
  ~System_decider();

  /// \brief The verdict on one closed cell. A witness, where there is one, holds for every polynomial of the system.
  /// \throw Invalid_input unless the cell lies in the grid.
  [[nodiscard]] Cell_decision<D> decide(const Cell<D>& cell);

private:
  struct State;
  std::unique_ptr<State> state_;
};

/// \brief Decides every unknown cell of `candidates` for the common zeros of a system of one or two polynomials.
/// One is decided as `ideal_raster` of it does.
/// \pre and \throw as for `System_decider` and `ideal_raster`.
template <std::size_t D>
[[nodiscard]] Ideal_raster<D> ideal_raster(const std::vector<Polynomial<Rational, D>>& system,
                                           const Raster<D>& candidates, const Run_options& run = {},
                                           const Ideal_raster_options& options = {});

/// Other dimensions do not compile, and `System_decider` says why.
template <std::size_t D>
  requires(D != 2 && D != 3)
[[nodiscard]] Ideal_raster<D> ideal_raster(const std::vector<Polynomial<Rational, D>>& system,
                                           const Raster<D>& candidates, const Run_options& = {},
                                           const Ideal_raster_options& = {})
{
  (void)System_decider<D>(system, candidates.grid());
  return {candidates};
}

} // namespace corral

#endif
