// SPDX-License-Identifier: LGPL-3.0-or-later
#include "../commands.h"

namespace corral::program {

void add_audit(CLI::App& app)
{
  CLI::App* const command = app.add_subcommand("audit", "Look for faults in bounders, ours too, and in rasters");
  command->require_subcommand(1);
  command->footer("Examples:\n"
                  "  corral audit bounders --help\n"
                  "  corral audit raster 'x^2 + y^2 - 1' --box -2:2,-2:2 --resolution 256 --cells plot.png");
  add_audit_bounders(*command);
  add_audit_raster(*command);
}

} // namespace corral::program
