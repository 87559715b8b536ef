// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_ALGEBRA_REQUIRE_NONZERO_H
#define CORRAL_SRC_ALGEBRA_REQUIRE_NONZERO_H

#include <corral/errors.h>

#include <string>
#include <string_view>

namespace corral::exact {

/// \throw Invalid_input if a polynomial is zero: it has no zero set to speak of.
inline void require_nonzero(bool is_zero, std::string_view who)
{
  if (is_zero) throw Invalid_input(std::string(who) + ": the polynomial is zero; expected one that is not");
}

} // namespace corral::exact

#endif
