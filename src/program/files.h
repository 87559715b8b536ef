// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_PROGRAM_FILES_H
#define CORRAL_PROGRAM_FILES_H

#include <initializer_list>
#include <string>
#include <vector>

namespace corral::program {

/// Whether the name of a file has this ending, dot included.
[[nodiscard]] bool has_ending(const std::string& path, const char* ending);

/// \throw Invalid_input that lists the endings if one of the names has none of them.
void require_endings(const std::vector<std::string>& paths, std::initializer_list<const char*> endings);

/// Sends off what was printed. \throw Output_error if any of it could not be written.
void flush_standard_output();

} // namespace corral::program

#endif
