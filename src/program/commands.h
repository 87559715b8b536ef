// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_PROGRAM_COMMANDS_H
#define CORRAL_PROGRAM_COMMANDS_H

#include <CLI/CLI.hpp>

/// \file
/// The commands of the program, one file each. Every function adds its command to the program; the work is done while
/// the command line is parsed, and errors are thrown. A command that has done its work and found faults throws
/// CLI::RuntimeError with its exit code.
namespace corral::program {

void add_localize(CLI::App& app);
void add_mesh(CLI::App& app);
void add_solve(CLI::App& app);
void add_certify(CLI::App& app);
void add_bound(CLI::App& app);
void add_reproduce(CLI::App& app);
void add_list(CLI::App& app);
void add_audit(CLI::App& app);

/// The commands under `audit`.
void add_audit_bounders(CLI::App& audit);
void add_audit_raster(CLI::App& audit);

} // namespace corral::program

#endif
