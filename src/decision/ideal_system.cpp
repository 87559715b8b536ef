// SPDX-License-Identifier: LGPL-3.0-or-later
#include "../algebra/require_nonzero.h"
#include "Common_zeros.h"
#include "decide_cells.h"
#include "recheck.h"
#include "within_budget.h"

#include <corral/decision/ideal_system.h>
#include <corral/errors.h>
#include <corral/internal/polynomial/integer_form.h>

#include <string>
#include <utility>

namespace corral {

template <std::size_t D>
struct System_decider<D>::State
{
  Grid<D> grid;
  std::vector<exact::Power_form<D>> forms; ///< in grid coordinates
  exact::Common_zeros<D> zeros;
};

template <std::size_t D>
System_decider<D>::System_decider(const std::vector<Polynomial<Rational, D>>& system, const Grid<D>& grid,
                                  Checkpoint checkpoint, Witnesses witnesses)
{
  if (system.empty() || system.size() > 2)
    throw Invalid_input("exact decision: a system of " + detail::quantity(system.size(), "polynomial")
                        + "; expected one or two");
  for (const auto& f : system) exact::require_nonzero(f.is_zero(), "exact decision");
  std::vector<exact::Power_form<D>> forms;
  forms.reserve(system.size());
  for (const auto& f : system)
    forms.push_back(exact::power_form(exact::in_grid_coordinates(integer_primitive(f), grid)));
  state_ = std::make_unique<State>(
      State{grid, std::move(forms),
            exact::Common_zeros<D>(integer_primitive(system.front()), integer_primitive(system.back()),
                                   std::move(checkpoint), witnesses)});
}

template <std::size_t D>
System_decider<D>::System_decider(System_decider&&) noexcept = default;
template <std::size_t D>
System_decider<D>& System_decider<D>::operator=(System_decider&&) noexcept = default;
template <std::size_t D>
System_decider<D>::~System_decider() = default;

template <std::size_t D>
Cell_decision<D> System_decider<D>::decide(const Cell<D>& cell)
{
  state_->grid.require(cell, "exact decision");
  for (const auto& form : state_->forms)
    if (exact::sign_pattern(exact::on_cell(form, cell)).closed() != 0)
      return {Verdict::empty, Rung::integers, Bounded_away{}, {}};
  return exact::within_budget<D>([&] { return state_->zeros.decide(state_->grid.cell_box(cell)); });
}

template <std::size_t D>
Ideal_raster<D> ideal_raster(const std::vector<Polynomial<Rational, D>>& system, const Raster<D>& candidates,
                             const Run_options& run, const Ideal_raster_options& options)
{
  if (system.size() == 1) return ideal_raster(system.front(), candidates, run, options); // intervals help there
  exact::require_guaranteed(candidates);
  const auto make_decider = [system, grid = candidates.grid()](const Checkpoint& checkpoint) {
    return System_decider<D>(system, grid, checkpoint, Witnesses::simple);
  };
  auto ideal = exact::decide_cells(candidates, run, options, make_decider);
  if (options.recheck) { // a system's decider uses no floats
    std::vector<Polynomial<Integer, D>> integers;
    for (const auto& f : system) integers.push_back(integer_primitive(f));
    exact::recheck(ideal, integers, run, options, make_decider);
  }
  return ideal;
}

template class System_decider<2>;
template class System_decider<3>;
template Ideal_raster<2> ideal_raster(const std::vector<Polynomial<Rational, 2>>&, const Raster<2>&, const Run_options&,
                                      const Ideal_raster_options&);
template Ideal_raster<3> ideal_raster(const std::vector<Polynomial<Rational, 3>>&, const Raster<3>&, const Run_options&,
                                      const Ideal_raster_options&);

} // namespace corral
