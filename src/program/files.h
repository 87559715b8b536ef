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

/// \throw Invalid_input if one of the files to write is also read: FILE of an argument `@FILE`, or a file of `inputs`.
void require_outputs_are_no_inputs(const std::vector<std::string>& outputs, const std::vector<std::string>& arguments,
                                   const std::vector<std::string>& inputs = {});

/// Sends off what was printed. \throw Output_error if any of it could not be written.
void flush_standard_output();

} // namespace corral::program

#endif
