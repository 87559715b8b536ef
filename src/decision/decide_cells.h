// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_DECISION_DECIDE_CELLS_H
#define CORRAL_SRC_DECISION_DECIDE_CELLS_H

#include "../algebra/Bernstein_form.h"

#include <corral/decision/ideal_raster.h>
#include <corral/errors.h>
#include <corral/localization/Raster_builder.h>
#include <corral/polynomial/integer_form.h>
#include <corral/polynomial/substitution.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

namespace corral::exact {

/// \brief f in the grid's own coordinates, where each cell is a unit cube with integer corners, times a positive
/// number. \throw Budget_exceeded if that has too many coefficients, or if they might fill half a gigabyte.
template <std::size_t D>
[[nodiscard]] Polynomial<Integer, D> in_grid_coordinates(const Polynomial<Integer, D>& f, const Grid<D>& grid)
{
  constexpr double max_bits = 0x1p32;
  const auto bits = [](const Integer& x) { return static_cast<double>(mpz_sizeinbase(x.get_mpz_t(), 2)); };
  std::array<Rational, D> offset;
  std::array<Rational, D> scale;
  double bits_of_one = 0; // coefficient, by what its powers add
  for (std::size_t axis = 0; axis < D; ++axis) {
    offset[axis] = grid.box()[axis].lower();
    scale[axis] = grid.step(axis);
    bits_of_one +=
        f.degree(axis)
        * (std::max(bits(offset[axis].get_num()), bits(scale[axis].get_num())) + bits(scale[axis].get_den()));
  }
  if (const std::size_t count = dense_size(f); static_cast<double>(count) * bits_of_one > max_bits)
    throw Budget_exceeded("exact decision: a polynomial has " + std::to_string(count)
                          + " coefficients, zeros included, of some " + std::to_string(std::lround(bits_of_one))
                          + " bits on the grid; expected less than half a gigabyte");
  return integer_primitive(
      affine_substitution(transform<Rational>(f, [](const Integer& c) { return Rational(c); }), offset, scale));
}

/// The Bernstein form on one cell. \param form  in grid coordinates.
template <std::size_t D>
[[nodiscard]] Bernstein_form<D> on_cell(Power_form<D> form, const Cell<D>& cell)
{
  for (std::size_t axis = 0; axis < D; ++axis) shift(form, axis, cell[axis]);
  return to_bernstein(std::move(form));
}

/// \brief What the threads of a crew share. It outlives the crew where a thread is left to itself.
template <std::size_t D, class Make_decider>
  requires CellDecider<std::invoke_result_t<Make_decider, Checkpoint>, D>
class Crew_work
{
public:
  using Decider = std::invoke_result_t<Make_decider, Checkpoint>;

  Crew_work(Make_decider make_decider, std::uint64_t done, unsigned threads)
      : make_decider_(std::move(make_decider)), done_(done), deciders_(threads)
  {}
  Crew_work(const Crew_work&) = delete; // the checkpoints point here
  Crew_work& operator=(const Crew_work&) = delete;

  /// New cells, none of them decided. \pre No thread works.
  void begin(const std::vector<Cell<D>>& cells, unsigned threads)
  {
    cells_ = cells;
    decisions_.assign(cells.size(), {});
    is_decided_ = std::make_unique<std::atomic<bool>[]>(cells.size());
    next_ = 0;
    working_ = threads;
  }

  /// Decides cells until none is left or it is stopped. \param ask  called at each checkpoint; `false` stops.
  template <class Ask>
  void work(std::size_t member, const Ask& ask)
  {
    try {
      if (!deciders_[member])
        deciders_[member].emplace(make_decider_([this, ask] {
          if (!ask()) stopped_ = true;
          require_going();
        }));
      for (std::size_t first = next_.fetch_add(chunk); first < cells_.size(); first = next_.fetch_add(chunk)) {
        if (!ask()) stopped_ = true;
        require_going();
        for (std::size_t k = first; k < std::min(first + chunk, cells_.size()); ++k) decide(*deciders_[member], k);
      }
    } catch (const Cancelled&) {
      stopped_ = true;
    } catch (...) {
      const std::lock_guard lock(mutex_);
      failure_ = std::current_exception();
      stopped_ = true;
    }
    const std::lock_guard lock(mutex_);
    --working_;
    is_idle_.notify_all();
  }

  /// Waits until all threads are done, at most for some time; whether they are.
  bool wait_for(std::chrono::milliseconds time)
  {
    std::unique_lock lock(mutex_);
    return is_idle_.wait_for(lock, time, [&] { return working_ == 0; });
  }

  /// What is decided so far. \throw what a thread has thrown.
  [[nodiscard]] std::vector<Cell_decision<D>> decisions()
  {
    const std::lock_guard lock(mutex_);
    if (failure_) std::rethrow_exception(failure_);
    std::vector<Cell_decision<D>> result;
    for (std::size_t k = 0; k < cells_.size(); ++k)
      result.push_back(is_decided_[k] ? std::move(decisions_[k]) : undecided());
    return result;
  }

  [[nodiscard]] static Cell_decision<D> undecided()
  {
    return {Verdict::unknown, Rung::floats, {}, "stopped on request before the cell was decided"};
  }

  void stop() { stopped_ = true; }
  [[nodiscard]] bool is_stopped() const { return stopped_; }
  [[nodiscard]] std::uint64_t done() const { return done_; }

  static constexpr std::size_t chunk = 64; // cells between reports

private:
  void require_going() const
  {
    if (stopped_) throw Cancelled("exact decision: stopped on request");
  }

  void decide(Decider& decider, std::size_t k)
  {
    decisions_[k] = decider.decide(cells_[k]);
    decisions_[k].witness = std::monostate{}; // a raster keeps none
    is_decided_[k] = true;
    ++done_;
  }

  Make_decider make_decider_;
  std::atomic<std::uint64_t> done_;
  std::vector<std::optional<Decider>> deciders_; ///< made by their threads, when first needed
  std::vector<Cell<D>> cells_;
  std::vector<Cell_decision<D>> decisions_;
  std::unique_ptr<std::atomic<bool>[]> is_decided_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> stopped_ = false;
  std::mutex mutex_; ///< of what follows
  std::condition_variable is_idle_;
  unsigned working_ = 0;
  std::exception_ptr failure_;
};

/// \brief Decides cells with one decider for each thread, so that none is shared. The verdicts do not depend on the
/// number of threads.
/// \param make_decider  gives, for a checkpoint, a model of `CellDecider`. It refers to nothing: with
///        `options.patience` a thread may outlive the crew.
template <std::size_t D, class Make_decider>
class Cell_crew
{
public:
  Cell_crew(const Make_decider& make_decider, const Run_options& run, const Ideal_raster_options& options,
            std::uint64_t done, std::uint64_t total)
      : run_(run), options_(options), total_(static_cast<double>(total)),
        threads_(run.threads != 0 ? run.threads : std::max(1U, std::thread::hardware_concurrency())),
        work_(std::make_shared<Work>(make_decider, done, threads_))
  {}

  [[nodiscard]] std::vector<Cell_decision<D>> decide(const std::vector<Cell<D>>& cells)
  {
    if (work_->is_stopped()) return std::vector<Cell_decision<D>>(cells.size(), Work::undecided());
    const unsigned threads = cells.size() <= Work::chunk ? 1 : threads_;
    work_->begin(cells, threads);
    if (threads_ == 1 && !options_.patience)
      work_->work(0, [this] { return report(); });
    else
      work_in_threads(threads);
    return work_->decisions();
  }

  /// Asks the caller whether to go on. Only the caller's own thread does so.
  bool report()
  {
    if (work_->is_stopped()) return false;
    if (run_.progress) run_.progress(total_ == 0 ? 1 : static_cast<double>(work_->done()) / total_);
    if (run_.stop.stop_requested()) work_->stop();
    return !work_->is_stopped();
  }

  [[nodiscard]] bool is_stopped() const { return work_->is_stopped(); }

private:
  using Work = Crew_work<D, Make_decider>;

  void work_in_threads(unsigned number)
  {
    constexpr auto moment = std::chrono::milliseconds(5);
    std::vector<std::jthread> threads; // joined if anything throws
    for (unsigned k = 0; k < number; ++k)
      threads.emplace_back([work = work_, k] { work->work(k, [] { return true; }); });
    try {
      bool is_done = false;
      do is_done = work_->wait_for(moment);
      while (!is_done && report());
      if (!is_done && options_.patience && !work_->wait_for(*options_.patience))
        for (auto& thread : threads) thread.detach();
    } catch (...) { // thrown by the callback
      work_->stop();
      throw;
    }
  }

  const Run_options& run_;
  const Ideal_raster_options& options_;
  double total_;
  unsigned threads_;
  std::shared_ptr<Work> work_;
};

/// \brief Writes down decisions: who decided what, why not, and for each cell if that is asked for.
template <std::size_t D>
void record(Ideal_raster<D>& result, Raster_builder<D>& cells, const Cell<D>& cell, const Cell_decision<D>& decision,
            bool keep)
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
  cells.append(cell, decision.verdict);
  if (keep) result.decided.push_back({cell, decision.rung, decision.reason});
}

/// \throw Invalid_input if the cells that the raster calls empty may hold zeros.
template <std::size_t D>
void require_guaranteed(const Raster<D>& candidates)
{
  if (!candidates.is_guaranteed())
    throw Invalid_input(
        "ideal raster: given a raster that is not guaranteed; expected one over a guaranteed number type");
}

/// Writes down the cells that were not visited, so that they are not decided.
template <std::size_t D>
void record_unvisited(Ideal_raster<D>& result, Raster_builder<D>& cells, const Raster<D>& candidates, bool keep)
{
  const std::string reason = "stopped on request before the cell was visited";
  for (const auto& range : candidates.unvisited()) {
    cells.leave(range);
    Cell<D> cell = range.first;
    if (keep) do
        result.decided.push_back({cell, Rung::floats, reason});
      while (range.advance(cell));
  }
  if (const auto count = candidates.unvisited_cells(); count > 0) result.reasons[reason] = count;
}

/// Decides the unknown cells of `candidates`, a batch at a time so that memory does not grow with their number.
template <std::size_t D, class Make_decider>
[[nodiscard]] Ideal_raster<D> decide_cells(const Raster<D>& candidates, const Run_options& run,
                                           const Ideal_raster_options& options, const Make_decider& make_decider)
{
  constexpr std::size_t batch_size = 1 << 14;
  Ideal_raster<D> result{candidates};
  Raster_builder<D> cells;
  Cell_crew<D, Make_decider> crew(make_decider, run, options, candidates.hit(),
                                  candidates.plotted() - candidates.unvisited_cells());
  crew.report();
  std::vector<Plotted_cell<D>> batch;
  const auto flush = [&] {
    std::vector<Cell<D>> open;
    for (const auto& [cell, known] : batch)
      if (known != Verdict::hit) open.push_back(cell);
    const auto decisions = crew.decide(open);
    auto decision = decisions.begin();
    for (const auto& [cell, known] : batch)
      record(result, cells, cell,
             known == Verdict::hit ? Cell_decision<D>{Verdict::hit, Rung::floats, {}, {}} : *decision++,
             options.keep_rungs);
    batch.clear();
  };
  const auto decide_or_wait = [&](const Cell<D>& cell, Verdict known) {
    batch.push_back({cell, known});
    if (batch.size() == batch_size) flush();
  };
  candidates.for_each_visited(decide_or_wait);
  flush();
  record_unvisited(result, cells, candidates, options.keep_rungs);
  if (crew.is_stopped()) cells.stop();
  result.raster = std::move(cells).finish(candidates.grid(), true, candidates.counters());
  std::sort(result.decided.begin(), result.decided.end(), [](const auto& a, const auto& b) { return a.cell < b.cell; });
  return result;
}

} // namespace corral::exact

#endif
