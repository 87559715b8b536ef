// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Pulse.h"

#include <corral/errors.h>

#include <algorithm>

namespace corral::fast {

void Pulse::advance(double share)
{
  if (progress_) tell(share);
}

void Pulse::tell(double share)
{
  constexpr std::chrono::milliseconds interval(50);
  const std::scoped_lock lock(mutex_);
  done_ += share;
  next_ = (std::chrono::steady_clock::now() + interval).time_since_epoch().count();
  is_stopped_ = is_stopped_ || !progress_(std::min(done_, 1.0));
  if (is_stopped_) throw Cancelled("localize_fast: cancelled by the caller");
}

} // namespace corral::fast
