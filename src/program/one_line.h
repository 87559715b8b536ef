// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_PROGRAM_ONE_LINE_H
#define CORRAL_SRC_PROGRAM_ONE_LINE_H

#include <string>
#include <string_view>

namespace corral::program {

/// \brief One line of printable characters, however strange or long the input that it quotes.
///
/// Line ends and tabs become blanks. Bytes that are neither printable ASCII nor part of a printable character in UTF-8
/// are written as \\xNN, so that a terminal does not obey them. What is longer than 600 bytes is cut.
[[nodiscard]] std::string one_line(std::string_view text);

} // namespace corral::program

#endif
