// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Progress.h"
#include "commands.h"
#include "gallery.h"

#include <iostream>

namespace corral::program {

namespace {

struct Reproduce_arguments
{
  std::string what;
  std::string number = "cgal_interval";
  std::string output = "gallery";
};

void reproduce_command(const Reproduce_arguments& arguments)
{
  draw_gallery(arguments.output, arguments.number, [](const std::string& line) {
    std::cout << line << std::endl;
    return interrupted_by() == 0;
  });
}

} // namespace

void add_reproduce(CLI::App& app)
{
  const auto arguments = std::make_shared<Reproduce_arguments>();
  CLI::App* const command = app.add_subcommand("reproduce", "Recompute the figures of the paper");
  command->add_option("WHAT", arguments->what, "what to recompute")->required()->check(CLI::IsMember({"figures"}));
  command->add_option("--number", arguments->number, "number type; see corral list")->capture_default_str();
  command->add_option("--output", arguments->output, "folder of the figures")->capture_default_str();
  command->footer("Examples:\n"
                  "  corral reproduce figures --output gallery");
  command->callback([arguments] { reproduce_command(*arguments); });
}

} // namespace corral::program
