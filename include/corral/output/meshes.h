// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_OUTPUT_MESHES_H
#define CORRAL_OUTPUT_MESHES_H

#include <corral/localization/Raster.h>
#include <corral/output/Output_options.h>

#include <ostream>

/// \file
/// Voxels as meshes of squares: the faces between a plotted cell and an empty one, or the outside of the grid, each
/// oriented outwards, with shared vertices and the verdict of the cell it belongs to. For each: n log n time and linear
/// memory for n cells.
namespace corral {

/// Object File Format, with the verdict as the colour of the face (MeshLab, Geomview, CGAL).
void write_off(std::ostream& out, const Raster<3>& raster, const Output_options& options);

/// Stanford PLY in ASCII, with the verdict as the colour of the face (MeshLab, Blender, ParaView).
void write_ply(std::ostream& out, const Raster<3>& raster, const Output_options& options);

/// Legacy VTK polygons in ASCII, with the cell data `verdict` (1 unknown, 2 hit) (ParaView, VisIt).
void write_vtk(std::ostream& out, const Raster<3>& raster, const Output_options& options);

} // namespace corral

#endif
