// SPDX-License-Identifier: LGPL-3.0-or-later
#include "../Progress.h"
#include "../commands.h"
#include "../files.h"
#include "gallery.h"
#include "tables.h"

#include <corral/number/all.h>
#include <corral/output/Output_file.h>

#include <filesystem>
#include <iostream>
#include <sstream>
#include <system_error>

namespace corral::program {

namespace {

struct Reproduce_arguments
{
  std::string what;
  std::string number;
  std::string output;
  std::string format = "text";
};

void make_folder(const std::string& folder)
{
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw Output_error("reproduce: cannot make folder '" + folder + "': " + error.message());
}

// Computes first and prints then: a table is printed whole or not at all.
void reproduce_table(const Paper_table& table, const Reproduce_arguments& arguments)
{
  std::ostringstream text;
  {
    Progress progress{std::string(table.name)};
    Table_options options;
    if (!arguments.number.empty()) options.number = arguments.number;
    options.csv = arguments.format == "csv";
    options.run = progress.run();
    print_table(text, table, options);
  }
  std::cout << text.str() << (arguments.format == "text" ? "\n" : "");
  flush_standard_output();
  if (arguments.output.empty()) return;
  write_whole_file(std::filesystem::path(arguments.output)
                       / (std::string(table.name) + (arguments.format == "csv" ? ".csv" : ".txt")),
                   [&](std::ostream& out) { out << text.str(); });
}

void reproduce_figures(const Reproduce_arguments& arguments)
{
  draw_gallery(arguments.output, arguments.number.empty() ? "cgal_interval" : arguments.number,
               [](const std::string& line) {
                 std::cout << line << std::endl;
                 return interrupted_by() == 0;
               });
}

// Fails before the work, not after.
void reproduce_command(Reproduce_arguments arguments)
{
  if (!arguments.number.empty()) Number_types::visit(arguments.number, [](auto) {});
  const bool draws = arguments.what == "figures" || arguments.what == "all";
  if (arguments.output.empty() && draws) arguments.output = "gallery";
  if (!arguments.output.empty()) make_folder(arguments.output);
  for (const Paper_table& table : paper_tables())
    if (arguments.what == table.name || arguments.what == "all") reproduce_table(table, arguments);
  if (draws) reproduce_figures(arguments);
}

} // namespace

void add_reproduce(CLI::App& app)
{
  const auto arguments = std::make_shared<Reproduce_arguments>();
  CLI::App* const command = app.add_subcommand("reproduce", "Recompute the tables and figures of the paper");
  command->add_option("WHAT", arguments->what, "what to recompute")
      ->required()
      ->check(CLI::IsMember({"table1", "table2", "table3", "table4", "figures", "all"}));
  command->add_option("--number", arguments->number,
                      "number type; see corral list (else double_nearest for tables, as in the paper, and\n"
                      "cgal_interval for figures)");
  command->add_option("--output", arguments->output, "folder for copies of the tables and for the figures (gallery)");
  command->add_option("--format", arguments->format, "of tables: text or csv")
      ->check(CLI::IsMember({"text", "csv"}))
      ->capture_default_str();
  command->footer("Nothing is needed but what is built in. Examples:\n"
                  "  corral reproduce table1\n"
                  "  corral reproduce table2 --number rational --format csv\n"
                  "  corral reproduce all --output gallery");
  command->callback([arguments] { reproduce_command(*arguments); });
}

} // namespace corral::program
