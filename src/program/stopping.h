// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_PROGRAM_STOPPING_H
#define CORRAL_SRC_PROGRAM_STOPPING_H

/// \file
/// How the program ends before its work is done: on request, or for want of memory. Whatever it is doing, it ends with
/// one line, and no part of a file is left.
namespace corral::program {

/// \brief Makes Ctrl-C, a polite kill and a lost terminal ask the running work to stop, and a full disk an error
/// instead of a crash.
///
/// Work that has not obeyed within 0.8 seconds is ended, and so is any at a second request.
void install_signal_handlers();

/// Makes GMP and FLINT end the program with "out of memory" where they would abort it.
void install_memory_functions();

/// The signal that asked to stop, or 0.
[[nodiscard]] int interrupted_by();

/// The work has obeyed: what it has proved may be written however long that takes, until a second request.
void keep_what_is_proved();

/// Files have their names, so that it would not be true to say that nothing was written.
void files_are_written();

/// The last line has been said; whatever ends the program now says nothing.
void say_no_more();

/// Whether a bar stands on the line where the last words would go.
void bar_is_shown(bool shown);

} // namespace corral::program

#endif
