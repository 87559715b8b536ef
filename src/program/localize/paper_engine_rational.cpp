// SPDX-License-Identifier: LGPL-3.0-or-later
#include "paper_engine-inl.h"

#include <corral/number/Rational_interval.h>

CORRAL_INSTANTIATE_PAPER_ENGINES(corral::Rational_interval)
