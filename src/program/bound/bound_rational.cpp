// SPDX-License-Identifier: LGPL-3.0-or-later
#include "bound_over-inl.h"

#include <corral/number/Rational_interval.h>

namespace corral::program {

CORRAL_INSTANTIATE_BOUNDERS(Rational_interval)

} // namespace corral::program
