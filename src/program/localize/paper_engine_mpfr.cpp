// SPDX-License-Identifier: LGPL-3.0-or-later
#include "paper_engine-inl.h"

#include <corral/number/Mpfr_interval.h>

CORRAL_INSTANTIATE_PAPER_ENGINES(corral::Mpfr_interval)
