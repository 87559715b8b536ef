// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_OUTPUT_PICTURES_H
#define CORRAL_OUTPUT_PICTURES_H

#include <corral/localization/Raster.h>
#include <corral/output/Output_options.h>

#include <ostream>

/// \file
/// Pictures, drawn by Cairo without a screen. No plotted cell vanishes: where several cells share a pixel, it shows the
/// strongest verdict among them.
namespace corral {

/// \brief A curve in a frame with ticks and axis names, as in Figures 3 to 14 of the paper; PNG.
/// \throw Invalid_input if `options.size` is out of range.
/// \par Complexity  linear in the cells and the pixels; memory for the pixels.
void draw_curve_png(std::ostream& out, const Raster<2>& raster, const Output_options& options);

/// The same picture as SVG.
void draw_curve_svg(std::ostream& out, const Raster<2>& raster, const Output_options& options);

/// \brief Voxels as shaded cubes in a box with ticks and axis names, seen from the lower right in front and above, as
/// in Figures 15 to 24 of the paper; PNG.
/// \throw Invalid_input if `options.size` is out of range.
/// \par Complexity  n log n for n cells; memory for the cells and the pixels.
void draw_voxels_png(std::ostream& out, const Raster<3>& raster, const Output_options& options);

} // namespace corral

#endif
