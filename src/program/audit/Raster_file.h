// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_PROGRAM_AUDIT_RASTER_FILE_H
#define CORRAL_SRC_PROGRAM_AUDIT_RASTER_FILE_H

#include "Claim.h"

#include <corral/localization/Grid.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// \file
/// Rasters that some other program made: which cells it plots, and what it claims of them.
namespace corral::program {

template <std::size_t D>
struct Claimed_cell
{
  Cell<D> cell{};
  Claim claim = Claim::plotted;
};

template <std::size_t D>
struct Foreign_raster
{
  std::vector<Claimed_cell<D>> cells; ///< sorted by their index, each once
  std::uint64_t repeated = 0;         ///< rows that named a cell again
};

/// \brief Reads a table (CSV) or, in two dimensions, a PNG picture, told apart by their first bytes.
///
/// A table has one row for each cell: its D indices from 0 and perhaps a verdict. Separators are a comma, a semicolon,
/// a tab or blanks; blank lines and lines that begin with `#` are skipped. A header may name the columns, in any order:
/// i, j, k, l or x, y, z or the variables, and `verdict`. Verdicts are `hit`, `unknown`, `plotted` (also `1`, `true`)
/// and `empty` (also `0`, `false`), whose rows count for nothing.
///
/// A picture has one pixel for each cell, its top row being the cells of largest y. A pixel is plotted if it is darker
/// than middle grey when laid over white; inverted, if it is not when laid over black. Its grey is
/// 0.2126 R + 0.7152 G + 0.0722 B of the 8-bit sRGB values.
///
/// \throw Invalid_input that names the line for what is not such a file or lies outside the grid; Budget_exceeded
///        above the limits of `options`.
/// \par Complexity  n log n for n rows, linear in the pixels; memory for the rows or the pixels.
template <std::size_t D>
[[nodiscard]] Foreign_raster<D> read_raster(const std::string& path, const Resolution<D>& resolution,
                                            const Raster_options& options = {});

} // namespace corral::program

#endif
