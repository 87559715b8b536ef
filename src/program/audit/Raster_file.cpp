// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Raster_file.h"

#include "Cell_table.h"
#include "Pixel_picture.h"

#include <algorithm>

namespace corral::program {

namespace {

template <std::size_t D>
void sort_and_merge(Foreign_raster<D>& raster)
{
  auto& cells = raster.cells;
  std::sort(cells.begin(), cells.end(), [](const auto& a, const auto& b) {
    return a.cell != b.cell ? a.cell < b.cell : a.claim > b.claim; // the strongest claim first, which is kept
  });
  const auto end =
      std::unique(cells.begin(), cells.end(), [](const auto& a, const auto& b) { return a.cell == b.cell; });
  raster.repeated = static_cast<std::uint64_t>(cells.end() - end);
  cells.erase(end, cells.end());
}

} // namespace

template <std::size_t D>
Foreign_raster<D> read_raster(const std::string& path, const Resolution<D>& resolution, const Raster_options& options)
{
  Input_file file(path);
  Foreign_raster<D> raster;
  if (is_png(file)) {
    if constexpr (D == 2) {
      read_png(file, resolution, options, [&](const Cell<2>& cell) { raster.cells.push_back({cell, Claim::plotted}); });
    } else
      file.fail("a PNG picture, but the grid has " + std::to_string(D) + " axes; expected a table");
  } else {
    read_table(file, resolution, options, [&](const std::vector<std::uint32_t>& index, Claim claim) {
      Claimed_cell<D> cell{{}, claim};
      std::copy_n(index.begin(), D, cell.cell.begin());
      raster.cells.push_back(cell);
    });
  }
  sort_and_merge(raster);
  return raster;
}

template Foreign_raster<1> read_raster(const std::string&, const Resolution<1>&, const Raster_options&);
template Foreign_raster<2> read_raster(const std::string&, const Resolution<2>&, const Raster_options&);
template Foreign_raster<3> read_raster(const std::string&, const Resolution<3>&, const Raster_options&);

} // namespace corral::program
