// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_INTERNAL_NUMBER_WRONG_ANSWER_H
#define CORRAL_INTERNAL_NUMBER_WRONG_ANSWER_H

#include <stdexcept>

namespace corral {

/// \brief What a library for algebra has answered is not true. Quotients, greatest common divisors, factors and
/// resultants are verified before anything is concluded from them: doc/exact.md, section 8.
struct Wrong_answer : std::logic_error
{
  using std::logic_error::logic_error;
};

} // namespace corral

#endif
