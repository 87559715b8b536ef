// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/output/meshes.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

namespace corral {

namespace {

using Vertex = std::array<std::uint32_t, 3>; // index of a grid point
using Square = std::array<Vertex, 4>;

// The face of the cell towards +axis or -axis, counterclockwise seen from outside.
Square face(const Cell<3>& cell, std::size_t axis, bool upper)
{
  const std::size_t second = (axis + 1) % 3;
  const std::size_t third = (axis + 2) % 3;
  Vertex base = cell;
  base[axis] += upper ? 1 : 0;
  Square square{base, base, base, base};
  ++square[upper ? 1 : 3][second];
  ++square[2][second];
  ++square[2][third];
  ++square[upper ? 3 : 1][third];
  return square;
}

// Calls visit(square, verdict) for every face of a plotted cell that no plotted cell covers.
template <class Visitor>
void for_each_exposed_face(const Raster<3>& raster, Visitor&& visit)
{
  for (const auto& [cell, verdict] : raster)
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const bool upper : {false, true}) {
        const bool outermost = upper ? cell[axis] + 1 == raster.grid().resolution()[axis] : cell[axis] == 0;
        Cell<3> neighbour = cell;
        neighbour[axis] += upper ? 1U : ~0U;
        if (outermost || raster.verdict(neighbour) == Verdict::empty) visit(face(cell, axis, upper), verdict);
      }
}

// The exposed faces of a set with shared vertices, numbered in lexicographic order.
class Mesh
{
public:
  explicit Mesh(const Raster<3>& raster) : raster_(raster)
  {
    for_each_exposed_face(raster, [&](const Square& square, Verdict) {
      vertices_.insert(vertices_.end(), square.begin(), square.end());
      ++faces_;
    });
    std::sort(vertices_.begin(), vertices_.end());
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
  }

  [[nodiscard]] std::size_t vertices() const { return vertices_.size(); }
  [[nodiscard]] std::size_t faces() const { return faces_; }

  void write_vertices(std::ostream& out) const
  {
    std::array<std::array<double, 2>, 3> side;
    for (std::size_t axis = 0; axis < 3; ++axis)
      side[axis] = {raster_.grid().box()[axis].lower().get_d(), raster_.grid().box()[axis].upper().get_d()};
    for (const Vertex& vertex : vertices_)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double at =
            std::lerp(side[axis][0], side[axis][1], double(vertex[axis]) / raster_.grid().resolution()[axis]);
        char text[32];
        const char* const end = std::to_chars(text, text + sizeof text, at).ptr;
        out << std::string_view(text, static_cast<std::size_t>(end - text)) << (axis < 2 ? ' ' : '\n');
      }
  }

  // One line a face: "4 a b c d", then what `suffix` gives for its verdict.
  template <class Suffix>
  void write_faces(std::ostream& out, const Suffix& suffix) const
  {
    for_each_exposed_face(raster_, [&](const Square& square, Verdict verdict) {
      out << '4';
      for (const Vertex& vertex : square)
        out << ' ' << std::lower_bound(vertices_.begin(), vertices_.end(), vertex) - vertices_.begin();
      out << suffix(verdict) << '\n';
    });
  }

  void write_verdicts(std::ostream& out) const
  {
    for_each_exposed_face(raster_, [&](const Square&, Verdict verdict) { out << static_cast<int>(verdict) << '\n'; });
  }

private:
  const Raster<3>& raster_;
  std::vector<Vertex> vertices_;
  std::size_t faces_ = 0;
};

// The colours of the pictures, from 0 to 255.
std::string_view colour(Verdict verdict) { return verdict == Verdict::hit ? " 191 212 235" : " 204 84 13"; }

} // namespace

void write_off(std::ostream& out, const Raster<3>& raster, const Output_options&)
{
  const Mesh mesh(raster);
  out << "OFF\n" << mesh.vertices() << ' ' << mesh.faces() << " 0\n";
  mesh.write_vertices(out);
  mesh.write_faces(out, colour);
}

void write_ply(std::ostream& out, const Raster<3>& raster, const Output_options&)
{
  const Mesh mesh(raster);
  out << "ply\nformat ascii 1.0\ncomment cells that are not empty; colour: hit light blue, unknown orange\n"
      << "element vertex " << mesh.vertices() << "\nproperty double x\nproperty double y\nproperty double z\n"
      << "element face " << mesh.faces() << "\nproperty list uchar int vertex_indices\n"
      << "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n";
  mesh.write_vertices(out);
  mesh.write_faces(out, colour);
}

void write_vtk(std::ostream& out, const Raster<3>& raster, const Output_options&)
{
  const Mesh mesh(raster);
  out << "# vtk DataFile Version 3.0\ncells that are not empty; verdict: 1 unknown, 2 hit\nASCII\nDATASET POLYDATA\n"
      << "POINTS " << mesh.vertices() << " double\n";
  mesh.write_vertices(out);
  out << "POLYGONS " << mesh.faces() << ' ' << 5 * mesh.faces() << '\n';
  mesh.write_faces(out, [](Verdict) { return ""; });
  out << "CELL_DATA " << mesh.faces() << "\nSCALARS verdict unsigned_char 1\nLOOKUP_TABLE default\n";
  mesh.write_verdicts(out);
}

} // namespace corral
