// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Bernstein_form.h"
#include "Zero_set.h"

#include <corral/errors.h>
#include <corral/polynomial/square_free.h>
#include <corral/polynomial/substitution.h>
#include <corral/verification/ideal_raster.h>

#include <utility>

namespace corral {

namespace {

/// f in the grid's own coordinates, where each cell is a unit cube with integer corners, times a positive number.
template <std::size_t D>
Polynomial<Integer, D> in_grid_coordinates(const Polynomial<Integer, D>& f, const Grid<D>& grid)
{
  std::array<Rational, D> offset;
  std::array<Rational, D> scale;
  for (std::size_t axis = 0; axis < D; ++axis) {
    offset[axis] = grid.box()[axis].lower();
    scale[axis] = grid.step(axis);
  }
  return integer_primitive(
      affine_substitution(transform<Rational>(f, [](const Integer& c) { return Rational(c); }), offset, scale));
}

} // namespace

template <std::size_t D>
struct Cell_decider<D>::State
{
  State(const Polynomial<Rational, D>& f, const Grid<D>& the_grid, const Checkpoint& checkpoint, Witnesses witnesses)
      : grid(the_grid), free(square_free_part(f)), form(exact::dense_power_form(in_grid_coordinates(free, the_grid))),
        zeros([g = free] { return g; }, checkpoint, witnesses)
  {}

  Grid<D> grid;
  Polynomial<Integer, D> free;
  exact::Bernstein_form<D> form; ///< power coefficients in grid coordinates
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
  auto form = state_->form;
  for (std::size_t axis = 0; axis < D; ++axis) exact::shift_power_form(form, axis, cell[axis]);
  exact::to_bernstein(form);
  return state_->zeros.decide(form, state_->grid.cell_box(cell));
}

template <std::size_t D>
Ideal_raster<D> ideal_raster(const Polynomial<Rational, D>& f, const Grid<D>& grid, const Cell_set<D>& candidates,
                             const Ideal_raster_options& options)
{
  Ideal_raster<D> result;
  std::uint64_t done = candidates.hit();
  const std::uint64_t total = candidates.plotted();
  const Checkpoint checkpoint = [&] {
    if (options.progress && !options.progress(done, total)) throw Cancelled("exact decision: stopped on request");
  };
  Cell_decider<D> decider(f, grid, checkpoint, Witnesses::simple);
  bool stopped = false;
  const auto decide = [&](const Cell<D>& cell, Verdict known) -> Cell_decision<D> {
    if (known == Verdict::hit) return {Verdict::hit, Rung::floats, {}, {}};
    if (!stopped) try {
        if (done % 64 == 0) checkpoint();
        return decider.decide(cell);
      } catch (const Cancelled&) {
        stopped = true;
      }
    return {Verdict::unknown, Rung::floats, {}, "stopped on request before the cell was decided"};
  };
  candidates.for_each([&](const Cell<D>& cell, Verdict known) {
    const auto decision = decide(cell, known);
    if (known != Verdict::hit) ++done;
    const auto rung = static_cast<std::size_t>(decision.rung);
    if (decision.verdict == Verdict::empty) {
      ++result.rungs.empty[rung];
      return;
    }
    if (decision.verdict == Verdict::hit)
      ++result.rungs.hit[rung];
    else
      ++result.reasons[decision.reason];
    result.cells.append(cell, decision.verdict);
  });
  result.cells.finish();
  return result;
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
