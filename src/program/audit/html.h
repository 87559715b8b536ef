// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_PROGRAM_AUDIT_HTML_H
#define CORRAL_SRC_PROGRAM_AUDIT_HTML_H

#include <string>
#include <string_view>

namespace corral::program {

/// A polynomial as HTML: exponents raised, products without a sign, decimals where a denominator is a power of ten.
[[nodiscard]] std::string polynomial_html(std::string_view polynomial);

} // namespace corral::program

#endif
