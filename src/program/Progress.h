// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_PROGRAM_PROGRESS_H
#define CORRAL_PROGRAM_PROGRESS_H

#include <chrono>
#include <string>
#include <utility>

namespace corral::program {

/// Makes Ctrl-C and a polite kill ask the running work to stop, and a full disk an error instead of a crash.
void install_signal_handlers();

/// The signal that asked to stop, or 0.
[[nodiscard]] int interrupted_by();

/// \brief A bar on standard error, if that is a terminal and the work has lasted over a second.
class Progress
{
public:
  /// \param what  the work, which the bar names.
  explicit Progress(std::string what);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Names the part of the work that begins.
  void begins(std::string part) { part_ = std::move(part); }

  /// Shows how much is done (0 to 1); `false` if the user wants to stop.
  bool operator()(double done);

private:
  using Clock = std::chrono::steady_clock;
  std::string what_;
  std::string part_;
  bool is_terminal_;
  bool is_shown_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point next_ = start_ + std::chrono::seconds(1);
};

} // namespace corral::program

#endif
