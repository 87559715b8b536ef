// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Raster_judgement.h"

#include <corral/bounders/Bernstein_bounder.h>
#include <corral/decision/ideal_system.h>
#include <corral/polynomial/Box.h>

#include <algorithm>

namespace corral::program {

template <std::size_t D>
Raster_judgement<D> judge(const Raster<D>& truth, const Foreign_raster<D>& raster)
{
  Raster_judgement<D> result;
  auto next = raster.cells.begin();
  const auto wrong_before = [&](const Cell<D>* end) {
    for (; next != raster.cells.end() && (end == nullptr || next->cell < *end); ++next) {
      result.wrong.push_back(*next);
      if (next->claim == Claim::hit) ++result.wrong_hits;
    }
  };
  truth.for_each_sorted([&](const Cell<D>& cell, Verdict verdict) {
    wrong_before(&cell);
    const bool is_plotted = next != raster.cells.end() && next->cell == cell;
    if (is_plotted) ++next;
    (verdict != Verdict::hit ? result.undecided : is_plotted ? result.right : result.lost).push_back(cell);
  });
  wrong_before(nullptr);
  return result;
}

template <std::size_t D>
struct Evidence_finder<D>::State
{
  Grid<D> grid;
  std::vector<Polynomial<Rational, D>> subjects;
  std::vector<Bernstein_bounder<Rational_interval, D>> bounders; ///< of the polynomials as given
  Checkpoint checkpoint;
  bool is_of_square_free_part = false;
  std::function<Cell_decision<D>(const Cell<D>&)> decide;
};

template <std::size_t D>
Evidence_finder<D>::Evidence_finder(const std::vector<Polynomial<Rational, D>>& system, const Grid<D>& grid,
                                    const Checkpoint& checkpoint)
    : state_(std::make_unique<State>(State{grid, system, {}, checkpoint, false, {}}))
{
  for (const auto& f : system)
    state_->bounders.emplace_back(
        transform<Rational_interval>(f, [](const Rational& c) { return Rational_interval(c); }));
  if (system.size() == 1) {
    const auto decider = std::make_shared<Cell_decider<D>>(system[0], grid, checkpoint);
    state_->is_of_square_free_part = decider->square_free().total_degree() < system[0].total_degree();
    if (state_->is_of_square_free_part) // else it is f times a number
      state_->subjects = {transform<Rational>(decider->square_free(), [](const Integer& c) { return Rational(c); })};
    state_->decide = [decider](const Cell<D>& cell) { return decider->decide(cell); };
  } else if constexpr (D > 1) {
    const auto decider = std::make_shared<System_decider<D>>(system, grid, checkpoint);
    state_->decide = [decider](const Cell<D>& cell) { return decider->decide(cell); };
  }
}

template <std::size_t D>
Evidence_finder<D>::~Evidence_finder() = default;

template <std::size_t D>
bool Evidence_finder<D>::is_of_square_free_part() const
{
  return state_->is_of_square_free_part;
}

template <std::size_t D>
const std::vector<Polynomial<Rational, D>>& Evidence_finder<D>::subjects() const
{
  return state_->subjects;
}

template <std::size_t D>
Evidence<D> Evidence_finder<D>::find(const Cell<D>& cell)
{
  if (state_->checkpoint) state_->checkpoint();
  Evidence<D> evidence;
  evidence.decision = state_->decide(cell);
  if (evidence.decision.verdict != Verdict::empty) return evidence;
  const auto box = state_->grid.cell_box(cell);
  for (std::size_t k = 0; k < state_->bounders.size() && !evidence.bounded; ++k) {
    evidence.bound = state_->bounders[k].bound(box);
    if (sgn(evidence.bound.lower()) * sgn(evidence.bound.upper()) > 0) evidence.bounded = k;
  }
  return evidence;
}

#define CORRAL_INSTANTIATE(D)                                                                                          \
  template Raster_judgement<D> judge(const Raster<D>&, const Foreign_raster<D>&);                                      \
  template class Evidence_finder<D>;
CORRAL_INSTANTIATE(1)
CORRAL_INSTANTIATE(2)
CORRAL_INSTANTIATE(3)

} // namespace corral::program
