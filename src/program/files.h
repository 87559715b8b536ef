// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_PROGRAM_FILES_H
#define CORRAL_PROGRAM_FILES_H

#include <functional>
#include <initializer_list>
#include <ostream>
#include <string>
#include <vector>

namespace corral::program {

/// Whether the name of a file has this ending, dot included.
[[nodiscard]] bool has_ending(const std::string& path, const char* ending);

/// \throw Invalid_input that lists the endings if one of the names has none of them.
void require_endings(const std::vector<std::string>& paths, std::initializer_list<const char*> endings);

/// Sends off what was printed. \throw Output_error if any of it could not be written.
void flush_standard_output();

/// \brief Calls `print` on standard output.
/// \throw Output_error if not everything could be written.
void print_whole(const std::function<void(std::ostream&)>& print);

} // namespace corral::program

#endif
