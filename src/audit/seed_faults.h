// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_AUDIT_SEED_FAULTS_H
#define CORRAL_AUDIT_SEED_FAULTS_H

#include "Fault_finding.h"

#include <corral/audit/Audit_options.h>

#include <vector>

/// \file
/// The audit of the audit: copies of number types and bounders with one planted fault each. The library itself carries
/// no switch for any of them.
namespace corral::audit {

/// \brief Plants every fault in turn and lets the audits of numbers and of bounders look for it.
/// \param options  `seed`, and how many `cases` to try before a fault counts as not found.
[[nodiscard]] std::vector<Fault_finding> seed_faults(const Audit_options& options = {});

/// The same harness over the types and bounders from which the faulty copies were made: nothing may be caught.
[[nodiscard]] std::vector<Fault_finding> seed_no_faults(const Audit_options& options = {});

} // namespace corral::audit

#endif
