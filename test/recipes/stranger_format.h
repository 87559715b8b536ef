// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_OUTPUT_STRANGER_FORMAT_H
#define CORRAL_OUTPUT_STRANGER_FORMAT_H

#include <corral/localization/Raster.h>
#include <corral/output/Output_options.h>

#include <cstddef>
#include <ostream>

namespace corral {

/// The sum of the indices of each plotted cell, one a line.
template <std::size_t D>
void write_stranger(std::ostream& out, const Raster<D>& cells, const Output_options&)
{
  cells.for_each_sorted([&](const Cell<D>& cell, Verdict) {
    std::size_t sum = 0;
    for (const auto index : cell) sum += index;
    out << sum << '\n';
  });
}

} // namespace corral

#endif
