// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_CHECKER_CERTIFICATE_H
#define CORRAL_CHECKER_CERTIFICATE_H

#include "contents.h"

#include <string>

namespace corral_check {

/// Reads a certificate. The result must not move: its values point into its text.
void read_contents(std::string bytes, Contents& contents);

} // namespace corral_check

#endif
