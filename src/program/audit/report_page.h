// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_PROGRAM_AUDIT_REPORT_PAGE_H
#define CORRAL_SRC_PROGRAM_AUDIT_REPORT_PAGE_H

#include <string>
#include <string_view>

namespace corral::program {

/// Text from outside as HTML.
[[nodiscard]] std::string escaped(std::string_view text);

/// A whole page in one file, in the style of all reports. \param title  as text. \param body  as HTML.
[[nodiscard]] std::string report_page(std::string_view title, std::string_view body);

} // namespace corral::program

#endif
