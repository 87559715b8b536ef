// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/geometry/mesh_curve.h>
#include <corral/output/curve_meshes.h>
#include <corral/polynomial/parse.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <sstream>
#include <string>
#include <vector>

namespace corral {
namespace {

const std::string text = "(x^2 + y^2 - 1)*((x - 3)^2 + y^2)*(x - 2)";

std::vector<Named_mesh> sample()
{
  const Rational_box<2> box{Rational_interval(-2, 4), Rational_interval(-2, 2)};
  return {{text, mesh_curve(parse_polynomial<2>(text, {"x", "y"}), box, {Rational(1, 50)})}};
}

template <class Writer>
std::string written(Writer writer, const std::vector<Named_mesh>& meshes)
{
  std::ostringstream out;
  writer(out, meshes, Output_options());
  return out.str();
}

std::vector<std::string> lines_of(const std::string& content)
{
  std::vector<std::string> lines;
  std::istringstream in(content);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

TEST(polylines, have_each_edge_once)
{
  const auto mesh = sample().front().mesh;
  std::vector<std::array<std::size_t, 2>> steps;
  std::size_t points = 0;
  for (const auto& line : polylines(mesh)) {
    points += line.size() == 1 ? 1 : 0;
    for (std::size_t k = 0; k + 1 < line.size(); ++k)
      steps.push_back({std::min(line[k], line[k + 1]), std::max(line[k], line[k + 1])});
  }
  std::vector<std::array<std::size_t, 2>> edges;
  for (const auto& [a, b] : mesh.edges) edges.push_back({std::min(a, b), std::max(a, b)});
  for (auto* list : {&steps, &edges}) std::sort(list->begin(), list->end());
  EXPECT_EQ(steps, edges);
  EXPECT_EQ(points, mesh.isolated_points());
  edges.pop_back(); // control
  EXPECT_NE(steps, edges);
}

TEST(mesh_json, says_what_the_mesh_is)
{
  const auto meshes = sample();
  const auto& mesh = meshes.front().mesh;
  const auto json = nlohmann::json::parse(written(write_meshes_json, meshes));
  EXPECT_EQ(json["components"], 3);
  EXPECT_EQ(json["closed_components"], 2);
  EXPECT_EQ(json["isolated_points"], 1);
  EXPECT_EQ(json["certified"], true);
  EXPECT_EQ(json["box"][0][1], "4");
  ASSERT_EQ(json["mesh"]["vertices"].size(), mesh.vertices.size());
  ASSERT_EQ(json["mesh"]["edges"].size(), mesh.edges.size());
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const auto& vertex = json["mesh"]["vertices"][v];
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_LE(parse_rational(vertex["box"][k][0].get<std::string>()), mesh.vertices[v].point[k]);
      EXPECT_GE(parse_rational(vertex["box"][k][1].get<std::string>()), mesh.vertices[v].point[k]);
    }
    EXPECT_EQ(vertex["branches"], mesh.vertices[v].branches);
  }
  for (const auto& component : json["mesh"]["components"]) EXPECT_TRUE(component["parent"].is_null());
}

TEST(mesh_summary, is_one_line_without_the_mesh)
{
  const auto summary = written(write_meshes_summary, sample());
  EXPECT_EQ(lines_of(summary).size(), 1U);
  const auto json = nlohmann::json::parse(summary);
  EXPECT_FALSE(json.contains("mesh"));
  for (const char* key : {"components", "closed_components", "isolated_points", "singular_points", "boundary_points",
                          "vertices", "edges", "euler_characteristic", "certified"})
    EXPECT_TRUE(json.contains(key)) << key;
}

TEST(mesh_csv, has_a_line_for_each_vertex_of_each_polyline)
{
  const auto meshes = sample();
  std::size_t expected = 1;
  for (const auto& line : polylines(meshes.front().mesh)) expected += line.size();
  const auto lines = lines_of(written(write_meshes_csv, meshes));
  EXPECT_EQ(lines.size(), expected);
  EXPECT_EQ(lines.front(), "curve,line,x,y,kind");
  EXPECT_EQ(std::count_if(lines.begin(), lines.end(), [](const auto& l) { return l.ends_with(",boundary"); }), 2);
  EXPECT_EQ(std::count_if(lines.begin(), lines.end(), [](const auto& l) { return l.ends_with("isolated singular"); }),
            1);
}

TEST(mesh_wkt, has_lines_and_points)
{
  const auto wkt = written(write_meshes_wkt, sample());
  EXPECT_EQ(wkt.rfind("GEOMETRYCOLLECTION (MULTILINESTRING ((", 0), 0U);
  EXPECT_NE(wkt.find("MULTIPOINT ((3 0))"), std::string::npos);
  EXPECT_EQ(std::count(wkt.begin(), wkt.end(), '('), std::count(wkt.begin(), wkt.end(), ')'));
}

TEST(mesh_dxf, has_a_polyline_for_each_line)
{
  const auto meshes = sample();
  const auto lines = lines_of(written(write_meshes_dxf, meshes));
  EXPECT_EQ(lines.size() % 2, 0U); // a code and a value each
  std::size_t polyline = 0;
  std::size_t point = 0;
  std::size_t vertex = 0;
  for (std::size_t k = 0; k + 1 < lines.size(); k += 2) {
    if (lines[k] != "0") continue;
    polyline += lines[k + 1] == "POLYLINE" ? 1 : 0;
    point += lines[k + 1] == "POINT" ? 1 : 0;
    vertex += lines[k + 1] == "VERTEX" ? 1 : 0;
  }
  EXPECT_EQ(polyline, 2U);
  EXPECT_EQ(point, 1U);
  EXPECT_EQ(vertex, meshes.front().mesh.vertices.size() - 1);
  EXPECT_EQ(lines.back(), "EOF");
}

TEST(mesh_pictures, hold_the_legend_of_every_curve)
{
  auto meshes = sample();
  for (int k = 0; k < 5; ++k)
    meshes.push_back({"a long name of curve number " + std::to_string(k) + std::string(200, 'x'), meshes.front().mesh});
  const auto height = [](const std::string& svg) {
    const auto start = svg.find("height=\"") + 8;
    return std::stod(svg.substr(start));
  };
  const auto one = written(draw_meshes_svg, sample());
  const auto six = written(draw_meshes_svg, meshes);
  EXPECT_GT(height(six), height(one)); // a row for each
  EXPECT_EQ(written(draw_meshes_png, meshes).rfind("\x89PNG", 0), 0U);
}

TEST(mesh_writers, are_found_by_the_ending)
{
  EXPECT_EQ(mesh_writer_for("a.wkt").ending, ".wkt");
  EXPECT_THROW((void)mesh_writer_for("a.stl"), std::invalid_argument);
}

} // namespace
} // namespace corral
