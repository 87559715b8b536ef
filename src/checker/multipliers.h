// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_CHECKER_MULTIPLIERS_H
#define CORRAL_CHECKER_MULTIPLIERS_H

#include "contents.h"

namespace corral_check {

/// \brief Reads one entry of `multipliers`, checks its factors (section 6) and appends them to `contents.proved`.
/// \throw Rejected.
void read_multipliers(const Value& value, Contents& contents, const std::string& where, Budget& budget);

} // namespace corral_check

#endif
