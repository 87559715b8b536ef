// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_POLYNOMIAL_SQUARE_FREE_H
#define CORRAL_SRC_POLYNOMIAL_SQUARE_FREE_H

#include "verification.h"

#include <corral/polynomial/square_free.h>

namespace corral::detail {

/// The same by somebody else's functions. \throw Wrong_answer if what they answer is not true.
[[nodiscard]] Flat_terms square_free_part(const Flat_terms& f, const Flint_functions& flint);

} // namespace corral::detail

#endif
