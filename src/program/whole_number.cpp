// SPDX-License-Identifier: LGPL-3.0-or-later
#include "whole_number.h"

#include <charconv>
#include <string>

namespace corral::program {

CLI::Validator whole_number(std::uint64_t least, std::uint64_t most)
{
  const auto complaint = [least, most](const std::string& argument) -> std::string {
    const std::string text = CLI::detail::trim_copy(argument); // see operands_marked
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc() && end == text.data() + text.size() && least <= value && value <= most) return {};
    return "given '" + text + "'; expected a whole number from " + std::to_string(least) + " to "
           + std::to_string(most);
  };
  return {complaint, ""};
}

} // namespace corral::program
