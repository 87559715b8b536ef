// SPDX-License-Identifier: LGPL-3.0-or-later
#include "bound_over-inl.h"

#include <corral/number/Outward_interval.h>

namespace corral::program {

CORRAL_INSTANTIATE_BOUNDERS(Outward_interval)

} // namespace corral::program
