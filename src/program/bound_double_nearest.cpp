// SPDX-License-Identifier: LGPL-3.0-or-later
#include "bound_over-inl.h"

#include <corral/number/Nearest_interval.h>

namespace corral::program {

template Bound_answer bound_over<Nearest_interval>(const Bound_problem&);

} // namespace corral::program
