// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_DECISION_DECIDE_CELLS_H
#define CORRAL_SRC_DECISION_DECIDE_CELLS_H

#include "../algebra/Bernstein_form.h"

#include <corral/decision/ideal_raster.h>
#include <corral/errors.h>
#include <corral/polynomial/integer_form.h>
#include <corral/polynomial/substitution.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

namespace corral::exact {

/// f in the grid's own coordinates, where each cell is a unit cube with integer corners, times a positive number.
template <std::size_t D>
[[nodiscard]] Polynomial<Integer, D> in_grid_coordinates(const Polynomial<Integer, D>& f, const Grid<D>& grid)
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

/// The Bernstein form on one cell. \param form  power coefficients in grid coordinates.
template <std::size_t D>
[[nodiscard]] Bernstein_form<D> on_cell(Bernstein_form<D> form, const Cell<D>& cell)
{
  for (std::size_t axis = 0; axis < D; ++axis) shift_power_form(form, axis, cell[axis]);
  to_bernstein(form);
  return form;
}

/// \brief Decides cells with one decider for each thread, so that none is shared. The verdicts do not depend on the
/// number of threads.
/// \param make_decider  gives, for a checkpoint, an object with `decide(cell)`.
template <std::size_t D, class Make_decider>
class Cell_crew
{
public:
  using Decider = std::invoke_result_t<Make_decider, Checkpoint>;

  Cell_crew(const Make_decider& make_decider, const Ideal_raster_options& options, std::uint64_t done,
            std::uint64_t total)
      : options_(options), done_(done), total_(total),
        threads_(options.threads != 0 ? options.threads : std::max(1U, std::thread::hardware_concurrency()))
  {
    for (unsigned k = 0; k < threads_; ++k) deciders_.push_back(make_decider([this] { require_going(); }));
  }
  Cell_crew(const Cell_crew&) = delete; // the checkpoints point here
  Cell_crew& operator=(const Cell_crew&) = delete;

  [[nodiscard]] std::vector<Cell_decision<D>> decide(const std::vector<Cell<D>>& cells)
  {
    std::vector<Cell_decision<D>> decisions(
        cells.size(), {Verdict::unknown, Rung::floats, {}, "stopped on request before the cell was decided"});
    next_ = 0;
    if (threads_ == 1 || cells.size() <= chunk) {
      work(deciders_.front(), cells, decisions);
    } else {
      std::atomic<unsigned> working = threads_;
      std::vector<std::jthread> crew;
      for (auto& decider : deciders_)
        crew.emplace_back([&] {
          work(decider, cells, decisions);
          --working;
        });
      for (; working != 0; std::this_thread::sleep_for(std::chrono::milliseconds(5))) report();
    }
    if (failure_) std::rethrow_exception(failure_);
    return decisions;
  }

  /// Asks the caller whether to go on. Only the caller's own thread does so.
  void report()
  {
    if (!stopped_ && options_.progress && !options_.progress(done_, total_)) stopped_ = true;
  }

private:
  static constexpr std::size_t chunk = 64; // cells between reports

  void require_going()
  {
    if (threads_ == 1) report();
    if (stopped_) throw Cancelled("exact decision: stopped on request");
  }

  void work(Decider& decider, const std::vector<Cell<D>>& cells, std::vector<Cell_decision<D>>& decisions)
  {
    try {
      for (std::size_t first = next_.fetch_add(chunk); first < cells.size(); first = next_.fetch_add(chunk)) {
        require_going();
        for (std::size_t k = first; k < std::min(first + chunk, cells.size()); ++k) {
          decisions[k] = decider.decide(cells[k]);
          decisions[k].witness = std::monostate{}; // a raster keeps none
          ++done_;
        }
      }
    } catch (const Cancelled&) {
      stopped_ = true;
    } catch (...) {
      const std::lock_guard lock(failure_mutex_);
      failure_ = std::current_exception();
      stopped_ = true;
    }
  }

  const Ideal_raster_options& options_;
  std::atomic<std::uint64_t> done_;
  std::uint64_t total_;
  unsigned threads_;
  std::vector<Decider> deciders_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> stopped_ = false;
  std::mutex failure_mutex_;
  std::exception_ptr failure_;
};

/// \brief Writes down decisions: who decided what, why not, and for each cell if that is asked for.
template <std::size_t D>
void record(Ideal_raster<D>& result, const Cell<D>& cell, const Cell_decision<D>& decision, bool keep)
{
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
  if (keep) result.decided.push_back({cell, decision.rung, decision.reason});
}

/// Decides the unknown cells of `candidates`, a batch at a time so that memory does not grow with their number.
template <std::size_t D, class Make_decider>
[[nodiscard]] Ideal_raster<D> decide_cells(const Cell_set<D>& candidates, const Ideal_raster_options& options,
                                           const Make_decider& make_decider)
{
  constexpr std::size_t batch_size = 1 << 14;
  Ideal_raster<D> result;
  Cell_crew<D, Make_decider> crew(make_decider, options, candidates.hit(), candidates.plotted());
  crew.report();
  std::vector<std::pair<Cell<D>, Verdict>> batch;
  const auto flush = [&] {
    std::vector<Cell<D>> open;
    for (const auto& [cell, known] : batch)
      if (known != Verdict::hit) open.push_back(cell);
    const auto decisions = crew.decide(open);
    auto decision = decisions.begin();
    for (const auto& [cell, known] : batch)
      record(result, cell, known == Verdict::hit ? Cell_decision<D>{Verdict::hit, Rung::floats, {}, {}} : *decision++,
             options.keep_rungs);
    batch.clear();
  };
  candidates.for_each([&](const Cell<D>& cell, Verdict known) {
    batch.emplace_back(cell, known);
    if (batch.size() == batch_size) flush();
  });
  flush();
  result.cells.finish();
  std::sort(result.decided.begin(), result.decided.end(), [](const auto& a, const auto& b) { return a.cell < b.cell; });
  return result;
}

} // namespace corral::exact

#endif
