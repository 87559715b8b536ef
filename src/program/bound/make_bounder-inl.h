// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_PROGRAM_BOUND_MAKE_BOUNDER_INL_H
#define CORRAL_SRC_PROGRAM_BOUND_MAKE_BOUNDER_INL_H

#include "make_bounder.h"

#include <corral/number/Counted.h>

#define CORRAL_INSTANTIATE_MAKE_BOUNDER(I)                                                                             \
  template Any_bounder<I, 1> make_bounder(const Method&, const Polynomial<I, 1>&);                                     \
  template Any_bounder<I, 2> make_bounder(const Method&, const Polynomial<I, 2>&);                                     \
  template Any_bounder<I, 3> make_bounder(const Method&, const Polynomial<I, 3>&);                                     \
  template Any_bounder<I, 4> make_bounder(const Method&, const Polynomial<I, 4>&);

#define CORRAL_INSTANTIATE_MAKE_BOUNDERS(I)                                                                            \
  CORRAL_INSTANTIATE_MAKE_BOUNDER(I)                                                                                   \
  CORRAL_INSTANTIATE_MAKE_BOUNDER(Counted<I>)

namespace corral::program {

template <IntervalNumber I, std::size_t D>
Any_bounder<I, D> make_bounder(const Method& method, const Polynomial<I, D>& f)
{
  return Any_bounder<I, D>(method.bounder, f, Bounder_options{.order = method.order});
}

} // namespace corral::program

#endif
