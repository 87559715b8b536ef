// SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformance_of_all.h"

#include <corral/number/Rational_interval.h>

namespace {

TEST(Bounder_conformance, rational) { corral::test::check_all_bounders<corral::Rational_interval>(1000); }

} // namespace
