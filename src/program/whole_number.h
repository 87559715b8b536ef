// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_PROGRAM_WHOLE_NUMBER_H
#define CORRAL_PROGRAM_WHOLE_NUMBER_H

#include <CLI/CLI.hpp>

#include <cstdint>
#include <limits>

namespace corral::program {

/// A check of an option: refuses all but a whole number in decimal digits, `least` to `most`.
[[nodiscard]] CLI::Validator whole_number(std::uint64_t least,
                                          std::uint64_t most = std::numeric_limits<std::uint32_t>::max());

} // namespace corral::program

#endif
