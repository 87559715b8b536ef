// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_OUTPUT_CURVE_MESHES_H
#define CORRAL_OUTPUT_CURVE_MESHES_H

#include <corral/geometry/polylines.h>
#include <corral/output/Output_options.h>

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

/// \file
/// Meshes of plane curves as pictures, tables and drawings. Several curves share a file.
namespace corral {

/// A mesh and what to call it.
struct Named_mesh
{
  std::string name;
  Curve_mesh mesh;
};

/// \brief Thin curves in a frame with ticks; singular points are rings, isolated points dots, uncertified regions
/// orange. With several curves, a legend.
/// \pre All meshes are of the same box. \throw Invalid_input if `options.size` is out of range.
void draw_meshes_png(std::ostream& out, const std::vector<Named_mesh>& meshes, const Output_options& options);
void draw_meshes_svg(std::ostream& out, const std::vector<Named_mesh>& meshes, const Output_options& options);

/// \brief One JSON object: the facts of `options`, and for each curve its counts, vertices, edges, components and
/// uncertified regions. Points are doubles, boxes exact.
void write_meshes_json(std::ostream& out, const std::vector<Named_mesh>& meshes, const Output_options& options);
/// The same object without vertices, edges and the list of components, on one line.
void write_meshes_summary(std::ostream& out, const std::vector<Named_mesh>& meshes, const Output_options& options);
/// One line `curve,line,x,y,kind` for each vertex of each polyline after a header.
void write_meshes_csv(std::ostream& out, const std::vector<Named_mesh>& meshes, const Output_options& options);
/// One MULTILINESTRING or MULTIPOINT on a line for each curve (Well-known text).
void write_meshes_wkt(std::ostream& out, const std::vector<Named_mesh>& meshes, const Output_options& options);
/// Polylines and points as DXF (R12), a layer for each curve.
void write_meshes_dxf(std::ostream& out, const std::vector<Named_mesh>& meshes, const Output_options& options);

/// One kind of file that meshes of curves can be written to.
struct Mesh_writer
{
  std::string_view ending; ///< of the file name, with the dot
  void (*write)(std::ostream&, const std::vector<Named_mesh>&, const Output_options&);
};

/// \brief The writer that the ending of `path` names. \throw Invalid_input that lists the known endings.
[[nodiscard]] Mesh_writer mesh_writer_for(const std::filesystem::path& path);

} // namespace corral

#endif
