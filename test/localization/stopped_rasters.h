// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_TEST_LOCALIZATION_STOPPED_RASTERS_H
#define CORRAL_TEST_LOCALIZATION_STOPPED_RASTERS_H

#include <corral/localization/Raster.h>

#include <sstream>
#include <string>

namespace corral::test {

/// What is wrong with the raster of a run that was stopped, beside that of the run that was not; else "".
template <std::size_t D>
std::string doubts_of_stopped(const Raster<D>& stopped, const Raster<D>& whole)
{
  if (!stopped.was_stopped()) return "it does not say that it was stopped";
  const auto text = [](const Cell<D>& cell) {
    std::ostringstream out;
    for (const auto index : cell) out << index << ' ';
    return out.str();
  };
  for (const auto& [cell, verdict] : whole)
    if (stopped.verdict(cell) == Verdict::empty) return text(cell) + "is silently empty";
  std::string doubt;
  stopped.for_each_visited([&](const Cell<D>& cell, Verdict verdict) {
    if (verdict != whole.verdict(cell)) doubt = text(cell) + "was visited and has another verdict";
    for (const auto& range : stopped.unvisited())
      if (range.contains(cell)) doubt = text(cell) + "was visited and left";
  });
  for (const auto& range : stopped.unvisited())
    for (const auto& other : stopped.unvisited())
      if (&range != &other && range.meets(other)) doubt = text(range.first) + "begins a range that meets another";
  return doubt;
}

} // namespace corral::test

#endif
