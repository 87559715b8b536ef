// SPDX-License-Identifier: LGPL-3.0-or-later
#include "files.h"

#include <corral/errors.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <system_error>

namespace corral::program {

bool has_ending(const std::string& path, const char* ending)
{
  return std::filesystem::path(path).extension() == ending;
}

void require_endings(const std::vector<std::string>& paths, std::initializer_list<const char*> endings)
{
  std::string known;
  for (const char* const ending : endings) known.append(known.empty() ? "" : " ").append(ending);
  for (const auto& path : paths)
    if (std::none_of(endings.begin(), endings.end(), [&](const char* ending) { return has_ending(path, ending); }))
      throw Invalid_input("output: '" + path + "' has no known ending; expected one of " + known);
}

void require_outputs_are_no_inputs(const std::vector<std::string>& outputs, const std::vector<std::string>& arguments,
                                   const std::vector<std::string>& inputs)
{
  auto all = inputs;
  for (const auto& argument : arguments)
    if (argument.starts_with('@') && argument != "@-") all.push_back(argument.substr(1));
  for (const auto& output : outputs)
    for (const auto& input : all) {
      std::error_code none_of_these_exists;
      if (output == input || std::filesystem::equivalent(output, input, none_of_these_exists))
        throw Invalid_input("output: '" + output + "' is the file that '" + input
                            + "' is read from; expected another one");
    }
}

void flush_standard_output()
{
  if (!std::cout.flush())
    throw Output_error(std::string("output: cannot write standard output: ") + std::strerror(errno != 0 ? errno : EIO));
}

} // namespace corral::program
