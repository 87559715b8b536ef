// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_DECISION_CELL_CREW_H
#define CORRAL_SRC_DECISION_CELL_CREW_H

#include <corral/decision/Ideal_result.h>
#include <corral/errors.h>
#include <corral/internal/algebra/Checkpoint.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

namespace corral::exact {

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

} // namespace corral::exact

#endif
