// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_CHECKER_JSON_SYNTAX_H
#define CORRAL_CHECKER_JSON_SYNTAX_H

#include <cstddef>
#include <string>
#include <string_view>

namespace corral_check {

/// \brief The end of the JSON value that begins at `at`, after checking all of it.
/// \throw Rejected, with the byte, if it is not well formed or breaks a rule of sections 1 and 7 on JSON texts.
[[nodiscard]] std::size_t end_of_checked_value(std::string_view text, std::size_t at);

/// The end of the value that begins at `at`, of a text that has been checked.
[[nodiscard]] std::size_t end_of_value(std::string_view text, std::size_t at);

[[nodiscard]] std::size_t skip_space(std::string_view text, std::size_t at);

/// What a string means, given with its quotes. \pre it has been checked.
[[nodiscard]] std::string unescaped(std::string_view quoted);

} // namespace corral_check

#endif
