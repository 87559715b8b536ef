// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Pulse.h"

#include <corral/errors.h>

#include <algorithm>

namespace corral::fast {

void Pulse::tell(double share)
{
  constexpr std::chrono::milliseconds interval(50);
  const std::scoped_lock lock(mutex_);
  done_ += share;
  next_ = (std::chrono::steady_clock::now() + interval).time_since_epoch().count();
  run_.progress(std::min(done_, 1.0));
}

void Pulse::refuse() { throw Cancelled("localize: stopped on request"); }

} // namespace corral::fast
