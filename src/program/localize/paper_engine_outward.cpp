// SPDX-License-Identifier: LGPL-3.0-or-later
#include "paper_engine-inl.h"

#include <corral/number/Outward_interval.h>

CORRAL_INSTANTIATE_PAPER_ENGINES(corral::Outward_interval)
