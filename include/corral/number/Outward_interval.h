// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_NUMBER_OUTWARD_INTERVAL_H
#define CORRAL_NUMBER_OUTWARD_INTERVAL_H

#include <corral/number/Double_interval.h>
#include <corral/number/Outward_rounding.h>

namespace corral {

/// \brief Model of `IntervalNumber`: doubles rounded outward, without touching the rounding mode.
using Outward_interval = Double_interval<Outward_rounding>;

} // namespace corral

#endif
