// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_OUTPUT_TABLES_H
#define CORRAL_OUTPUT_TABLES_H

#include <corral/localization/Raster.h>
#include <corral/output/Output_options.h>

#include <ostream>

/// \file
/// Cells as text: CSV, JSON and a picture made of letters. Explicitly instantiated for 1 to 4 dimensions.
/// The writers look at nothing but the stream to tell whether a write failed: check it afterwards.
namespace corral {

/// \brief One line `i,j[,k],verdict` for each plotted cell after a header, sorted by the index; if cell notes
/// want it, `i,j[,k],verdict,rung`.
/// \par Complexity  n log n for n cells; memory for one layer of blocks.
template <std::size_t D>
void write_csv(std::ostream& out, const Raster<D>& raster, const Output_options& options);

/// \brief One JSON object: box, resolution, variables, the facts of `options`, the numbers of cells (and, if the run
/// was stopped, that of the cells not visited, which are among the unknown ones), and every plotted cell as [i, j, ...,
/// verdict], sorted; with cell notes [i, j, ..., verdict, rung] and a reason after that if unknown.
template <std::size_t D>
void write_json(std::ostream& out, const Raster<D>& raster, const Output_options& options);

/// \brief The same object without the cells, on one line.
template <std::size_t D>
void write_summary(std::ostream& out, const Raster<D>& raster, const Output_options& options);

/// \brief A picture of letters: `#` hit, `?` unknown, `.` empty; y points up. Above two dimensions, one
/// picture a slice. Grids above 128 cells are drawn coarser; a letter then stands for a block of cells and says
/// `hit` if one of them is, else `unknown` if one of them is.
template <std::size_t D>
void write_text(std::ostream& out, const Raster<D>& raster, const Output_options& options);

} // namespace corral

#endif
