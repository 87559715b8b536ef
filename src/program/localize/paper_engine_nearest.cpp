// SPDX-License-Identifier: LGPL-3.0-or-later
#include "paper_engine-inl.h"

#include <corral/number/Nearest_interval.h>

CORRAL_INSTANTIATE_PAPER_ENGINES(corral::Nearest_interval)
