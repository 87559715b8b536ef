// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/number/Rational.h>

namespace corral {

std::string to_string(const Rational& value) { return value.get_str(); }

} // namespace corral
