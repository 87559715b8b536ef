// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_LOCALIZATION_FAST_PULSE_H
#define CORRAL_SRC_LOCALIZATION_FAST_PULSE_H

#include <corral/Run_options.h>

#include <atomic>
#include <chrono>
#include <mutex>

namespace corral::fast {

/// \brief Tells the caller of a run how much is done, and asks whether to go on; from any thread, one at a time.
///
/// A computation that may take long calls `ask` in between, of which the caller is told some times a second at most.
class Pulse
{
public:
  explicit Pulse(const Run_options& run) : run_(run), is_watched_(run.is_watched()) {}

  /// Adds a share of the whole work, which is done.
  void advance(double share)
  {
    if (run_.progress) tell(share);
  }

  /// \throw Cancelled if a stop is asked for.
  void ask()
  {
    if (!is_watched_) return;
    if (run_.progress && std::chrono::steady_clock::now().time_since_epoch().count() > next_) tell(0);
    if (is_stopped()) refuse();
  }

  [[nodiscard]] bool is_stopped() const { return run_.stop.stop_requested(); }

private:
  void tell(double share);
  [[noreturn]] static void refuse();

  const Run_options run_;
  const bool is_watched_;
  std::atomic<std::chrono::steady_clock::rep> next_ = 0; // when to ask again
  std::mutex mutex_;                                     // guards what follows
  double done_ = 0;
};

} // namespace corral::fast

#endif
