// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_PROGRAM_METHOD_OPTIONS_H
#define CORRAL_PROGRAM_METHOD_OPTIONS_H

#include "localize/engine.h"

#include <CLI/CLI.hpp>

namespace corral::program {

/// Adds the options that say how a polynomial is bounded. `method` must outlive the command.
void add_method_options(CLI::App& command, Method& method);

} // namespace corral::program

#endif
