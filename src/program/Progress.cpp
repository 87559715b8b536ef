// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Progress.h"

#include <algorithm>
#include <cstdio>
#include <unistd.h>

namespace corral::program {

Progress::Progress(std::string what) : what_(std::move(what)), is_terminal_(::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress()
{
  if (is_shown_) std::fputs("\r\033[K", stderr);
  bar_is_shown(false);
}

void Progress::operator()(double done)
{
  if (interrupted_by() != 0) stop_.request_stop();
  const auto now = Clock::now();
  if (!is_terminal_ || now < next_) return;
  next_ = now + std::chrono::milliseconds(100);
  is_shown_ = true;
  bar_is_shown(true);
  constexpr int width = 40;
  const int full = static_cast<int>(width * std::clamp(done, 0.0, 1.0));
  const std::string bar =
      std::string(static_cast<std::size_t>(full), '#') + std::string(std::size_t(width - full), '.');
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const std::string name = what_ + (part_.empty() ? "" : ": " + part_);
  std::fprintf(stderr, "\r\033[K%s [%s] %3.0f%%  %.0f s", name.c_str(), bar.c_str(), 100 * done, seconds);
  std::fflush(stderr);
}

} // namespace corral::program
