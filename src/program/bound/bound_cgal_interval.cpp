// SPDX-License-Identifier: LGPL-3.0-or-later
#include "bound_over-inl.h"

#include <corral/number/Cgal_interval.h>

namespace corral::program {

CORRAL_INSTANTIATE_BOUNDERS(Cgal_interval)

} // namespace corral::program
