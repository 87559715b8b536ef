// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_CHECKER_CHECK_H
#define CORRAL_CHECKER_CHECK_H

#include "certificate.h"

namespace corral_check {

/// Checks the bytes of a file against doc/certificate.md and returns its counts.
/// \throw Rejected with the first thing that is wrong.
[[nodiscard]] Counts check(std::string_view bytes);

} // namespace corral_check

#endif
