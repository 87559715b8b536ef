// SPDX-License-Identifier: LGPL-3.0-or-later
#include "audit_over-inl.h"

#include <corral/number/Rational_interval.h>

namespace corral::program {

template std::vector<Method_audit> audit_over<Rational_interval>(const Audit_settings&,
                                                                 const std::function<bool(double)>&);

} // namespace corral::program
