// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_PROGRAM_PROGRESS_H
#define CORRAL_PROGRAM_PROGRESS_H

#include "stopping.h"

#include <chrono>
#include <string>
#include <utility>

namespace corral::program {

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
