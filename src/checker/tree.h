// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_CHECKER_TREE_H
#define CORRAL_CHECKER_TREE_H

#include "certificate.h"

#include <functional>

namespace corral_check {

/// \brief Goes through the tree of section 3, checks every proof and returns the number of cells of each verdict.
/// \throw Rejected, Stopped.
[[nodiscard]] Counts check_tree(const Contents& contents, const std::function<void(const Region&)>& visit);

} // namespace corral_check

#endif
