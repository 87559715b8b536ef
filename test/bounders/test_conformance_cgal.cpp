// SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformance_of_all.h"

#include <corral/number/Cgal_interval.h>

namespace {

TEST(Bounder_conformance, cgal) { corral::test::check_all_bounders<corral::Cgal_interval>(1000); }

} // namespace
