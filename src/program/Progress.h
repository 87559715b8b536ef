// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_PROGRAM_PROGRESS_H
#define CORRAL_PROGRAM_PROGRESS_H

#include "stopping.h"

#include <corral/Run_options.h>

#include <chrono>
#include <stop_token>
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

  /// Shows how much is done (0 to 1), and passes it on if the user wants to stop.
  void operator()(double done);

  /// A run that this bar shows and the user can stop, as long as the bar lives.
  [[nodiscard]] Run_options run(unsigned threads = 1)
  {
    return {threads, {}, [this](double done) { (*this)(done); }, stop_.get_token()};
  }

private:
  using Clock = std::chrono::steady_clock;
  std::string what_;
  std::string part_;
  std::stop_source stop_;
  bool is_terminal_;
  bool is_shown_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point next_ = start_ + std::chrono::seconds(1);
};

/// The run of a part of some work: from `begin` on and so large a share of it.
[[nodiscard]] inline Run_options part_of(Run_options whole, double begin, double share)
{
  if (whole.progress)
    whole.progress = [tell = std::move(whole.progress), begin, share](double done) { tell(begin + share * done); };
  return whole;
}

} // namespace corral::program

#endif
