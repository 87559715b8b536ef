// SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformance_of_all.h"

#include <corral/number/Mpfr_interval.h>

namespace {

TEST(Bounder_conformance, mpfr) { corral::test::check_all_bounders<corral::Mpfr_interval>(1000); }

} // namespace
