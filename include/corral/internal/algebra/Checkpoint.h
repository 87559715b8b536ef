// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_INTERNAL_ALGEBRA_CHECKPOINT_H
#define CORRAL_INTERNAL_ALGEBRA_CHECKPOINT_H

#include <corral/Run_options.h>

#include <functional>

namespace corral {

/// \brief Called now and then by exact computations that may run long. It stops them by throwing, `Cancelled` as a
/// rule.
using Checkpoint = std::function<void()>;

/// The checkpoint of a run that cannot tell how much is done: it throws `Cancelled` in the name of `who`.
[[nodiscard]] inline Checkpoint checkpoint_of(const Run_options& run, const char* who)
{
  if (!run.is_watched()) return {};
  return [run, who] { detail::report_or_throw(run, 0, who); };
}

} // namespace corral

#endif
