// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_PROGRAM_AUDIT_CLAIM_H
#define CORRAL_SRC_PROGRAM_AUDIT_CLAIM_H

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace corral::program {

/// What a raster says of a cell that it plots, the strongest last.
enum class Claim : std::uint8_t {
  plotted, ///< nothing but that
  unknown, ///< that it does not know
  hit      ///< that the curve or surface is proved to pass through
};

[[nodiscard]] constexpr std::string_view name_of(Claim claim)
{
  switch (claim) {
  case Claim::hit:
    return "hit";
  case Claim::unknown:
    return "unknown";
  case Claim::plotted:
    break;
  }
  return "plotted";
}

/// How rasters of other programs are read.
struct Raster_options
{
  std::vector<std::string> variables;    ///< names of the axes that a header may use
  bool invert = false;                   ///< pictures are light on dark
  std::uint64_t max_rows = 50'000'000;   ///< of a table
  std::uint64_t max_pixels = 1ULL << 26; ///< of a picture
};

} // namespace corral::program

#endif
