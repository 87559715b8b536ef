// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_PROGRAM_BOUND_MAKE_BOUNDER_H
#define CORRAL_SRC_PROGRAM_BOUND_MAKE_BOUNDER_H

#include "../localize/engine.h"

#include <corral/bounders/Any_bounder.h>

namespace corral::program {

/// \brief A bounder by its name. All bounders over one number type, and over its counted kind, are compiled in one
/// source, which the build makes; whoever needs a bounder calls this.
/// \throw Invalid_input for an unknown one.
template <IntervalNumber I, std::size_t D>
[[nodiscard]] Any_bounder<I, D> make_bounder(const Method& method, const Polynomial<I, D>& f);

} // namespace corral::program

#endif
