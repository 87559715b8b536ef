// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_CHECKER_WITNESS_H
#define CORRAL_CHECKER_WITNESS_H

#include "certificate.h"

namespace corral_check {

/// Checks that one entry of `witnesses` proves a common zero in the cell (section 5). \throw Rejected otherwise.
void check_witness(const Value& witness, const Contents& contents, const Box& cell, const std::string& where,
                   Budget& budget);

} // namespace corral_check

#endif
