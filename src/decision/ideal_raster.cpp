// SPDX-License-Identifier: LGPL-3.0-or-later
#include "../algebra/require_nonzero.h"
#include "../algebra/restriction.h"
#include "Block_screen.h"
#include "Interval_rung.h"
#include "Term_search.h"
#include "Tiled_form.h"
#include "Zero_set.h"
#include "corners.h"
#include "decide_cells.h"
#include "recheck.h"
#include "within_budget.h"

#include <corral/decision/ideal_raster.h>
#include <corral/number/Mpfr_interval.h>
#include <corral/number/Outward_interval.h>
#include <corral/polynomial/square_free.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace corral {

template <std::size_t D>
struct Cell_decider<D>::State
{
  State(const Polynomial<Rational, D>& f, const Grid<D>& the_grid, const Checkpoint& checkpoint, Witnesses witnesses)
      : grid(the_grid), free(square_free_part(f)), zeros([g = free] { return g; }, checkpoint, witnesses)
  {
    if (free.terms().size() * worth_moving < exact::dense_count(free)) terms.emplace(free);
  }

  /// What the terms say of a cell, if they are few.
  [[nodiscard]] std::optional<Cell_decision<D>> decide_by_terms(const Rational_box<D>& box) const
  {
    if (!terms) return std::nullopt;
    const auto corners = exact::corner_signs_of_terms(free, box);
    if (corners.common() == 0)
      return Cell_decision<D>{Verdict::hit, Rung::integers, exact::corner_witness(corners, box), {}};
    return terms->decide(box, corners.common());
  }

  /// \throw Budget_exceeded if a dense form is too large.
  [[nodiscard]] Cell_decision<D> decide_by_all_coefficients(const Cell<D>& cell, const Rational_box<D>& box)
  {
    if (!form) form.emplace(exact::power_form(exact::in_grid_coordinates(free, grid)));
    if (screen.excludes(*form, cell)) return {Verdict::empty, Rung::intervals, Bounded_away{}, {}};
    const auto& power = form->on_cell(cell);
    const auto corners = exact::corner_signs(power);
    if (corners.common() == 0) return {Verdict::hit, Rung::integers, exact::corner_witness(corners, box), {}};
    if (auto decision = decide_by_intervals(power, corners.common(), box)) return *decision;
    return zeros.decide(exact::to_bernstein(power), box);
  }

  /// What intervals say of a cell. \param sign  that of all corners.
  [[nodiscard]] std::optional<Cell_decision<D>> decide_by_intervals(const exact::Power_form<D>& power, int sign,
                                                                    const Rational_box<D>& box)
  {
    using Kind = typename exact::Finding<D>::Kind;
    auto rung = Rung::intervals;
    exact::Search_limits limits;
    limits.boundary_suffices = zeros.boundary_suffices();
    auto finding = doubles.look_for_zero(power, sign, limits);
    if (finding.kind == Kind::unclear && is_wide(power)) {
      rung = Rung::mpfr;
      finding = mpfr.look_for_zero(power, sign, limits);
    }
    if (finding.kind == Kind::none) return Cell_decision<D>{Verdict::empty, rung, Bounded_away{}, {}};
    if (finding.kind == Kind::crossing) {
      for (std::size_t k = 0; k < D; ++k) finding.point[k] = at(box[k], finding.point[k]);
      return Cell_decision<D>{Verdict::hit, rung, Sign_change<D>{exact::corner_of(box, 0), finding.point}, {}};
    }
    return guess(finding.left, box);
  }

  /// An isolated zero is often a simple rational point. \param parts  where it may be, in units of the box.
  [[nodiscard]] std::optional<Cell_decision<D>> guess(const std::vector<Rational_box<D>>& parts,
                                                      const Rational_box<D>& box) const
  {
    constexpr std::size_t max_guesses = 16;
    if (parts.size() > max_guesses) return std::nullopt;
    for (const auto& part : parts) {
      Rational_point<D> point;
      for (std::size_t k = 0; k < D; ++k)
        point[k] = simplest_rational({at(box[k], part[k].lower()), at(box[k], part[k].upper())});
      if (exact::vanishes_at(free, point))
        return Cell_decision<D>{Verdict::hit, Rung::integers, Sign_change<D>{point, point}, {}};
    }
    return std::nullopt;
  }

  [[nodiscard]] static Rational at(const Rational_interval& side, const Rational& offset)
  {
    return side.lower() + (side.upper() - side.lower()) * offset;
  }

  /// Whether MPFR is so much faster than the integers that trying it pays.
  [[nodiscard]] static bool is_wide(const exact::Power_form<D>& power)
  {
    return std::any_of(power.values.begin(), power.values.end(),
                       [](const Integer& c) { return mpz_sizeinbase(c.get_mpz_t(), 2) > 1024; });
  }

  /// The dense coefficients for each term up to which it is cheaper to move all to a cell than to look at the corners
  /// first.
  static constexpr std::size_t worth_moving = 32;
  static constexpr long precision_of_doubles = 60; // bits

  Grid<D> grid;
  Polynomial<Integer, D> free;
  std::optional<exact::Term_search<D>> terms; ///< if they are few
  std::optional<exact::Tiled_form<D>> form;   ///< made when first needed
  exact::Block_screen<Outward_interval, D> screen{precision_of_doubles};
  exact::Interval_rung<Outward_interval, D> doubles{precision_of_doubles};
  exact::Interval_rung<Mpfr_interval, D> mpfr{128};
  exact::Zero_set<D> zeros;
};

template <std::size_t D>
Cell_decider<D>::Cell_decider(const Polynomial<Rational, D>& f, const Grid<D>& grid, Checkpoint checkpoint,
                              Witnesses witnesses)
{
  exact::require_nonzero(f.is_zero(), "exact decision");
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
  state_->grid.require(cell, "exact decision");
  if (state_->zeros.is_known_definite()) return {Verdict::empty, Rung::algebra, std::monostate{}, {}};
  const auto box = state_->grid.cell_box(cell);
  if (auto decision = state_->decide_by_terms(box)) return *decision;
  return exact::within_budget<D>([&] { return state_->decide_by_all_coefficients(cell, box); });
}

namespace {

/// Decides cells by exact integers and algebra alone.
template <std::size_t D>
class Integer_decider
{
public:
  Integer_decider(const Polynomial<Integer, D>& free, const Grid<D>& grid, const Checkpoint& checkpoint)
      : grid_(grid), form_(exact::power_form(exact::in_grid_coordinates(free, grid))),
        zeros_(std::make_unique<exact::Zero_set<D>>([free] { return free; }, checkpoint, Witnesses::simple))
  {}

  [[nodiscard]] Cell_decision<D> decide(const Cell<D>& cell)
  {
    return exact::within_budget<D>([&] { return zeros_->decide(exact::on_cell(form_, cell), grid_.cell_box(cell)); });
  }

private:
  Grid<D> grid_;
  exact::Power_form<D> form_; ///< in grid coordinates
  std::unique_ptr<exact::Zero_set<D>> zeros_;
};

} // namespace

template <std::size_t D>
Ideal_raster<D> ideal_raster(const Polynomial<Rational, D>& f, const Raster<D>& candidates, const Run_options& run,
                             const Ideal_raster_options& options)
{
  exact::require_guaranteed(candidates);
  const auto& grid = candidates.grid();
  auto ideal = exact::decide_cells(candidates, run, options, [f, grid](const Checkpoint& checkpoint) {
    return Cell_decider<D>(f, grid, checkpoint, Witnesses::simple);
  });
  if (options.recheck) {
    const auto free = square_free_part(f);
    exact::recheck(ideal, {free}, run, options,
                   [free, grid](const Checkpoint& checkpoint) { return Integer_decider<D>(free, grid, checkpoint); });
  }
  return ideal;
}

template class Cell_decider<1>;
template class Cell_decider<2>;
template class Cell_decider<3>;
template Ideal_raster<1> ideal_raster(const Polynomial<Rational, 1>&, const Raster<1>&, const Run_options&,
                                      const Ideal_raster_options&);
template Ideal_raster<2> ideal_raster(const Polynomial<Rational, 2>&, const Raster<2>&, const Run_options&,
                                      const Ideal_raster_options&);
template Ideal_raster<3> ideal_raster(const Polynomial<Rational, 3>&, const Raster<3>&, const Run_options&,
                                      const Ideal_raster_options&);

} // namespace corral
