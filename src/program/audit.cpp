// SPDX-License-Identifier: LGPL-3.0-or-later
#include "commands.h"

namespace corral::program {

void add_audit(CLI::App& app)
{
  CLI::App* const command = app.add_subcommand("audit", "Look for faults in bounders, ours too, and in rasters");
  command->require_subcommand(1);
  add_audit_bounders(*command);
  add_audit_raster(*command);
}

} // namespace corral::program
