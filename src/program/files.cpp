// SPDX-License-Identifier: LGPL-3.0-or-later
#include "files.h"

#include <corral/errors.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <iostream>

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

void flush_standard_output()
{
  if (!std::cout.flush())
    throw Output_error(std::string("output: cannot write standard output: ") + std::strerror(errno != 0 ? errno : EIO));
}

} // namespace corral::program
