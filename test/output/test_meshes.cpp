// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/output/meshes.h>

#include "shapes.h"

#include <gtest/gtest.h>

#include <map>
#include <sstream>

namespace {

using namespace corral;

struct Off_mesh
{
  std::vector<std::array<double, 3>> vertices;
  std::vector<std::array<std::size_t, 4>> faces;
};

Off_mesh read_off(const std::string& text)
{
  std::istringstream in(text);
  std::string magic;
  std::size_t vertices = 0;
  std::size_t faces = 0;
  std::size_t unused = 0;
  in >> magic >> vertices >> faces >> unused;
  EXPECT_EQ(magic, "OFF");
  Off_mesh mesh{std::vector<std::array<double, 3>>(vertices), std::vector<std::array<std::size_t, 4>>(faces)};
  for (auto& vertex : mesh.vertices) in >> vertex[0] >> vertex[1] >> vertex[2];
  for (auto& face : mesh.faces) in >> unused >> face[0] >> face[1] >> face[2] >> face[3] >> unused >> unused >> unused;
  EXPECT_TRUE(in) << "fewer numbers than announced";
  return mesh;
}

std::string off(const Raster<3>& cells)
{
  std::ostringstream out;
  write_off(out, cells, {});
  return out.str();
}

// Volume by the divergence theorem: right only if the mesh is closed and every face points outwards.
double volume(const Off_mesh& mesh)
{
  double sum = 0;
  for (const auto& face : mesh.faces)
    for (const std::size_t third : {2U, 3U}) {
      const auto& a = mesh.vertices.at(face[0]);
      const auto& b = mesh.vertices.at(face[third - 1]);
      const auto& c = mesh.vertices.at(face[third]);
      sum +=
          a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
  return sum / 6;
}

TEST(Mesh, of_one_voxel_is_a_cube)
{
  const Off_mesh mesh = read_off(off(test::raster(test::grid<3>(2, -1, 1), {{{1, 0, 1}, Verdict::hit}})));
  EXPECT_EQ(mesh.vertices.size(), 8U);
  EXPECT_EQ(mesh.faces.size(), 6U);
  EXPECT_NEAR(volume(mesh), 1, 1e-12);
}

TEST(Mesh, has_no_inner_faces_and_shares_vertices)
{
  const auto grid = test::grid<3>(6);
  const auto all = test::select<3>(grid, [](const Cell<3>&) { return Verdict::hit; });
  const Off_mesh mesh = read_off(off(all));
  EXPECT_EQ(mesh.faces.size(), 6U * 36U);
  EXPECT_EQ(mesh.vertices.size(), 7U * 7U * 7U - 5U * 5U * 5U);
  EXPECT_NEAR(volume(mesh), 1, 1e-12);
}

TEST(Mesh, is_closed_for_any_cells)
{
  const auto grid = test::grid<3>(9, -1, 2);
  const auto cells = test::select<3>(grid, [](const Cell<3>& c) {
    return (c[0] * 31 + c[1] * 17 + c[2] * 7 + c[0] * c[2]) % 5 < 2 ? Verdict::unknown : Verdict::empty;
  });
  const Off_mesh mesh = read_off(off(cells));
  EXPECT_NEAR(volume(mesh), static_cast<double>(cells.plotted()) / 27, 1e-9);
  std::map<std::pair<std::size_t, std::size_t>, int> balance;
  for (const auto& face : mesh.faces)
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t a = face[k];
      const std::size_t b = face[(k + 1) % 4];
      balance[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  for (const auto& [edge, sum] : balance) EXPECT_EQ(sum, 0);
}

TEST(Mesh, formats_agree)
{
  const auto grid = test::grid<3>(2);
  const auto cells = test::raster(grid, {{{0, 0, 0}, Verdict::hit}, {{1, 1, 1}, Verdict::unknown}});
  std::ostringstream ply;
  std::ostringstream vtk;
  write_ply(ply, cells, {});
  write_vtk(vtk, cells, {});
  EXPECT_NE(ply.str().find("element vertex 15\n"), std::string::npos);
  EXPECT_NE(ply.str().find("element face 12\n"), std::string::npos);
  EXPECT_NE(vtk.str().find("POINTS 15 double\n0 0 0\n0 0 0.5\n"), std::string::npos);
  EXPECT_NE(vtk.str().find("POLYGONS 12 60\n"), std::string::npos);
  EXPECT_NE(vtk.str().find("LOOKUP_TABLE default\n2\n2\n2\n2\n2\n2\n1\n1\n1\n1\n1\n1\n"), std::string::npos);
}

} // namespace
