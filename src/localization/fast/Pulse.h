// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_LOCALIZATION_FAST_PULSE_H
#define CORRAL_SRC_LOCALIZATION_FAST_PULSE_H

#include <atomic>
#include <chrono>
#include <functional>
#include <mutex>

namespace corral::fast {

/// \brief Tells the caller of a run how much is done, and asks whether to go on; from any thread, one at a time.
///
/// A computation that may take long calls `ask` in between, which comes to the caller some times a second at most.
class Pulse
{
public:
  /// \param progress  may be empty.
  explicit Pulse(std::function<bool(double)> progress) : progress_(std::move(progress)) {}

  /// Adds a share of the whole work. \throw Cancelled if the caller says so.
  void advance(double share);

  /// \throw Cancelled if the caller says so.
  void ask()
  {
    if (progress_ && std::chrono::steady_clock::now().time_since_epoch().count() > next_) tell(0);
  }

private:
  void tell(double share);

  const std::function<bool(double)> progress_;
  std::atomic<std::chrono::steady_clock::rep> next_ = 0; // when to ask again
  std::mutex mutex_;                                     // guards what follows
  double done_ = 0;
  bool is_stopped_ = false;
};

} // namespace corral::fast

#endif
