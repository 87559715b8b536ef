// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_OUTPUT_ALL_H
#define CORRAL_OUTPUT_ALL_H

#include <corral/output/Output_file.h>
#include <corral/output/meshes.h>
#include <corral/output/pictures.h>
#include <corral/output/tables.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// \file
/// The list of all writers. A new one is one line here.
namespace corral {

/// One kind of file that cells of a D-dimensional grid can be written to.
template <std::size_t D>
struct Writer
{
  std::string_view ending; ///< of the file name, with the dot
  std::string_view what;   ///< for people
  void (*write)(std::ostream&, const Raster<D>&, const Output_options&);
};

/// Every writer for D dimensions.
template <std::size_t D>
[[nodiscard]] std::vector<Writer<D>> writers()
{
  std::vector<Writer<D>> list;
  if constexpr (D == 2) {
    list.push_back({".png", "picture of the curve with axes", draw_curve_png});
    list.push_back({".svg", "vector drawing of the curve with axes", draw_curve_svg});
  }
  if constexpr (D == 3) {
    list.push_back({".png", "shaded picture of the voxels with axes", draw_voxels_png});
    list.push_back({".off", "voxel mesh, Object File Format", write_off});
    list.push_back({".ply", "voxel mesh, Stanford PLY", write_ply});
    list.push_back({".vtk", "voxel mesh with verdicts as cell data, legacy VTK", write_vtk});
  }
  list.push_back({".csv", "one line a plotted cell", write_csv<D>});
  list.push_back({".json", "summary and plotted cells", write_json<D>});
  list.push_back({".txt", "picture made of letters", write_text<D>});
  return list;
}

/// \brief The writer that the ending of `path` names.
/// \throw Invalid_input that lists the known endings if there is none.
template <std::size_t D>
[[nodiscard]] Writer<D> writer_for(const std::filesystem::path& path)
{
  std::string known;
  for (const auto& writer : writers<D>()) {
    if (path.extension() == writer.ending) return writer;
    if (!known.empty()) known += ' ';
    known += writer.ending;
  }
  throw Invalid_input("output: '" + path.string() + "' has no known ending for " + detail::quantity(D, "dimension")
                      + "; expected one of " + known);
}

/// \brief Writes the cells to a file whose ending chooses the writer, whole or not at all.
/// \throw Invalid_input for an unknown ending; Output_error if the file could not be written.
template <std::size_t D>
void write_file(const std::filesystem::path& path, const Raster<D>& raster, const Output_options& options = {})
{
  const Writer<D> writer = writer_for<D>(path);
  write_whole_file(path, [&](std::ostream& out) { writer.write(out, raster, options); });
}

} // namespace corral

#endif
