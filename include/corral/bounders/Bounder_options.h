// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_BOUNDERS_BOUNDER_OPTIONS_H
#define CORRAL_BOUNDERS_BOUNDER_OPTIONS_H

namespace corral {

/// \brief What a bounder that is chosen at run time may be told. A bounder that has a use for it has a constructor
/// from a polynomial and these; the others ignore them.
struct Bounder_options
{
  unsigned order = 2; ///< of a Taylor method, at least 1
};

} // namespace corral

#endif
