// SPDX-License-Identifier: LGPL-3.0-or-later
#include "paper_engine-inl.h"

#include <corral/number/Cgal_interval.h>

CORRAL_INSTANTIATE_PAPER_ENGINES(corral::Cgal_interval)
