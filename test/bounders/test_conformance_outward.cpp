// SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformance_of_all.h"

#include <corral/number/Outward_interval.h>

namespace {

TEST(Bounder_conformance, outward) { corral::test::check_all_bounders<corral::Outward_interval>(1000); }

} // namespace
