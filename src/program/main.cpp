// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/errors.h>

#include "Formula.h"
#include "Progress.h"
#include "commands.h"
#include "files.h"
#include "one_line.h"

#include <cstdlib>
#include <iostream>
#include <new>
#include <string>
#include <vector>

namespace corral::program {

namespace {

enum Exit : int { done = 0, failed = 1, bad_usage = 2 };

int complain(const std::string& message, Exit code)
{
  std::cerr << "corral: " << one_line(message) << '\n';
  say_no_more();
  return code;
}

// A polynomial or a number may begin with a minus sign. No option of ours has one dash and several letters, so such
// an argument is an operand; the blank keeps CLI11 from reading it as options.
std::vector<std::string> operands_marked(int argc, char** argv)
{
  std::vector<std::string> arguments;
  for (int k = argc; k-- > 1;) {
    const std::string argument = argv[k];
    const bool is_operand = argument.size() > 1 && argument[0] == '-' && argument[1] != '-' && argument != "-h";
    arguments.push_back((is_operand ? " " : "") + argument);
  }
  return arguments; // in reverse, as CLI11 wants them
}

void add_commands(CLI::App& app)
{
  app.footer("Examples:\n"
             "  corral localize 'x^2 + y^2 - 1' --box -2:2,-2:2 --resolution 256 --plus --output circle.png\n"
             "  corral localize 'x^2 + y^2 + z^2 - 1' --box -1:1,-1:1,-1:1 --resolution 32 --output ball.off\n"
             "  corral bound 'x^2 - x*y' --box 0:1,0:1\n"
             "  corral list\n"
             "Exit codes: 0 done, 1 failed, 2 bad usage.");
  app.set_version_flag("--version", "corral " CORRAL_VERSION);
  app.require_subcommand(1);
  add_localize(app);
  add_mesh(app);
  add_solve(app);
  add_bound(app);
  add_certify(app);
  add_audit(app);
  add_reproduce(app);
  add_list(app);
}

void require_command(const CLI::App& app, const std::string& given)
{
  std::string names;
  for (const CLI::App* const known : app.get_subcommands(nullptr)) {
    if (known->get_name() == given) return;
    names += (names.empty() ? "" : ", ") + known->get_name();
  }
  throw Invalid_input("command: given '" + given + "'; expected one of " + names);
}

// The program and the commands named so far, such as "corral audit raster".
std::string path_of_commands(const CLI::App& app)
{
  std::string path = app.get_name();
  for (auto below = app.get_subcommands(); !below.empty(); below = below.front()->get_subcommands())
    path += ' ' + below.front()->get_name();
  return path;
}

// Does what the command line asks for and returns the exit code.
int execute(CLI::App& app, int argc, char** argv)
{
  int code = done;
  try {
    app.parse(operands_marked(argc, argv));
  } catch (const CLI::Success& success) { // --help and --version
    app.exit(success);
  } catch (const CLI::RuntimeError& found) { // the command has said what
    code = found.get_exit_code();
  }
  flush_standard_output();
  if (interrupted_by() == 0) return code;
  complain("interrupted; what was proved by then is kept", failed);
  return 128 + interrupted_by();
}

int run(int argc, char** argv)
{
  CLI::App app("Finds the cells of a pixel or voxel grid through which an algebraic curve or surface passes,\n"
               "and bounds polynomials over boxes. What it says of a cell is proved, rounding included.",
               "corral");
  add_commands(app);
  if (argc == 1) {
    std::cout << app.help();
    return bad_usage;
  }
  const std::string command = argv[1];
  const bool is_question = command == "-h" || command == "--help" || command == "--version";
  try {
    if (!is_question) require_command(app, command);
    return execute(app, argc, argv);
  } catch (const CLI::ParseError& error) {
    return complain(error.what() + ("; see " + path_of_commands(app)) + " --help", bad_usage);
  } catch (const Formula_error& error) {
    const int code = complain(error.what(), bad_usage);
    std::cerr << error.excerpt << '\n';
    return code;
  } catch (const Invalid_input& error) {
    return complain(error.what(), bad_usage);
  } catch (const Cancelled&) {
    complain("interrupted; nothing was written", failed);
    return 128 + interrupted_by();
  } catch (const std::bad_alloc&) {
    return complain("out of memory", failed);
  } catch (const std::exception& error) {
    return complain(error.what(), failed);
  }
}

} // namespace

} // namespace corral::program

int main(int argc, char** argv)
{
  corral::program::install_signal_handlers();
  corral::program::install_memory_functions();
  const int code = corral::program::run(argc, argv);
  if (corral::program::interrupted_by() != 0) std::_Exit(code); // a thread may still be at work on what is dropped
  return code;
}
