// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_ALGEBRA_CHECKPOINT_H
#define CORRAL_ALGEBRA_CHECKPOINT_H

#include <functional>

namespace corral {

/// \brief Called now and then by exact computations that may run long. It stops them by throwing, `Cancelled` as a
/// rule.
using Checkpoint = std::function<void()>;

} // namespace corral

#endif
