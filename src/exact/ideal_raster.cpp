// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Tiled_form.h"
#include "Zero_set.h"
#include "decide_cells.h"

#include <corral/errors.h>
#include <corral/polynomial/square_free.h>
#include <corral/verification/ideal_raster.h>

#include <utility>

namespace corral {

template <std::size_t D>
struct Cell_decider<D>::State
{
  State(const Polynomial<Rational, D>& f, const Grid<D>& the_grid, const Checkpoint& checkpoint, Witnesses witnesses)
      : grid(the_grid), free(square_free_part(f)),
        form(exact::dense_power_form(exact::in_grid_coordinates(free, the_grid))),
        zeros([g = free] { return g; }, checkpoint, witnesses)
  {}

  Grid<D> grid;
  Polynomial<Integer, D> free;
  exact::Tiled_form<D> form;
  exact::Zero_set<D> zeros;
};

template <std::size_t D>
Cell_decider<D>::Cell_decider(const Polynomial<Rational, D>& f, const Grid<D>& grid, Checkpoint checkpoint,
                              Witnesses witnesses)
{
  if (f.is_zero())
    throw Invalid_input("exact decision: the polynomial is zero; expected one that does not vanish everywhere");
  state_ = std::make_unique<State>(f, grid, checkpoint, witnesses);
}

template <std::size_t D>
Cell_decider<D>::Cell_decider(Cell_decider&&) noexcept = default;
template <std::size_t D>
Cell_decider<D>& Cell_decider<D>::operator=(Cell_decider&&) noexcept = default;
template <std::size_t D>
Cell_decider<D>::~Cell_decider() = default;

template <std::size_t D>
const Polynomial<Integer, D>& Cell_decider<D>::square_free() const
{
  return state_->free;
}

template <std::size_t D>
Cell_decision<D> Cell_decider<D>::decide(const Cell<D>& cell)
{
  if (auto decision = state_->form.decide_by_intervals(state_->grid, cell)) return *decision;
  return state_->zeros.decide(state_->form.on_cell(cell), state_->grid.cell_box(cell));
}

template <std::size_t D>
Ideal_raster<D> ideal_raster(const Polynomial<Rational, D>& f, const Grid<D>& grid, const Cell_set<D>& candidates,
                             const Ideal_raster_options& options)
{
  return exact::decide_cells(candidates, options, [&](const Checkpoint& checkpoint) {
    return Cell_decider<D>(f, grid, checkpoint, Witnesses::simple);
  });
}

template class Cell_decider<1>;
template class Cell_decider<2>;
template class Cell_decider<3>;
template Ideal_raster<1> ideal_raster(const Polynomial<Rational, 1>&, const Grid<1>&, const Cell_set<1>&,
                                      const Ideal_raster_options&);
template Ideal_raster<2> ideal_raster(const Polynomial<Rational, 2>&, const Grid<2>&, const Cell_set<2>&,
                                      const Ideal_raster_options&);
template Ideal_raster<3> ideal_raster(const Polynomial<Rational, 3>&, const Grid<3>&, const Cell_set<3>&,
                                      const Ideal_raster_options&);

} // namespace corral
