// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/output/curve_meshes.h>

#include <corral/errors.h>
#include <corral/number/Double_bracket.h>

#include <nlohmann/json.hpp>

#include <array>
#include <charconv>

namespace corral {

namespace {

using Json = nlohmann::ordered_json;

double nearest(const Rational& value) { return bracket(value).nearest; }

/// The shortest decimal that names the double next to the value.
std::string number(const Rational& value)
{
  std::array<char, 32> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), nearest(value)).ptr};
}

std::string kind(const Curve_vertex& vertex)
{
  std::string result = vertex.is_singular ? "singular" : vertex.branches == 0 ? "isolated" : "";
  if (vertex.is_singular && vertex.branches == 0) result = "isolated singular";
  if (vertex.is_on_boundary) result += result.empty() ? "boundary" : " boundary";
  return result.empty() ? "regular" : result;
}

Json sides(const Rational_box<2>& box)
{
  Json result = Json::array();
  for (const auto& side : box) result.push_back(Json::array({to_string(side.lower()), to_string(side.upper())}));
  return result;
}

Json counts(const Named_mesh& named)
{
  const Curve_mesh& mesh = named.mesh;
  return {{"polynomial", named.name},
          {"components", mesh.components.size()},
          {"closed_components", mesh.closed_components()},
          {"isolated_points", mesh.isolated_points()},
          {"singular_points", mesh.singular_points()},
          {"boundary_points", mesh.boundary_points()},
          {"vertices", mesh.vertices.size()},
          {"edges", mesh.edges.size()},
          {"euler_characteristic", mesh.euler_characteristic()},
          {"certified", mesh.is_certified()}};
}

Json regions(const Curve_mesh& mesh)
{
  Json list = Json::array();
  for (const auto& region : mesh.uncertified) list.push_back({{"box", sides(region.box)}, {"reason", region.reason}});
  return list;
}

Json graph(const Curve_mesh& mesh)
{
  Json vertices = Json::array();
  for (const auto& vertex : mesh.vertices)
    vertices.push_back({{"point", {nearest(vertex.point[0]), nearest(vertex.point[1])}},
                        {"kind", kind(vertex)},
                        {"branches", vertex.branches},
                        {"component", vertex.component},
                        {"box", sides(vertex.box)}});
  Json components = Json::array();
  for (const auto& component : mesh.components) {
    components.push_back({{"closed", component.is_closed},
                          {"vertices", component.vertices},
                          {"edges", component.edges},
                          {"parent", component.parent ? Json(*component.parent) : Json()}});
  }
  return {{"vertices", std::move(vertices)}, {"edges", mesh.edges}, {"components", std::move(components)}};
}

/// One curve: its own entries at the top. Several: a list.
Json document(const std::vector<Named_mesh>& meshes, const Output_options& options, bool whole)
{
  Json result = meshes.size() == 1 ? counts(meshes[0]) : Json::object();
  if (!meshes.empty()) result["box"] = sides(meshes[0].mesh.box);
  result["variables"] = {axis_name(options, 0), axis_name(options, 1)};
  bool certified = true;
  Json curves = Json::array();
  for (const auto& named : meshes) {
    certified = certified && named.mesh.is_certified();
    Json curve = meshes.size() == 1 ? Json::object() : counts(named);
    if (!named.mesh.is_certified()) curve["uncertified_regions"] = regions(named.mesh);
    if (whole) curve["mesh"] = graph(named.mesh);
    if (meshes.size() == 1)
      result.update(curve);
    else
      curves.push_back(std::move(curve));
  }
  if (meshes.size() > 1) {
    result["curves"] = std::move(curves);
    result["certified"] = certified;
  }
  for (const auto& [name, fact] : options.facts)
    std::visit([&, key = name](const auto& value) { result[key] = value; }, fact);
  return result;
}

void print(std::ostream& out, const Json& value)
{
  out << value.dump(-1, ' ', false, Json::error_handler_t::replace) << '\n';
}

} // namespace

void write_meshes_json(std::ostream& out, const std::vector<Named_mesh>& meshes, const Output_options& options)
{
  print(out, document(meshes, options, true));
}

void write_meshes_summary(std::ostream& out, const std::vector<Named_mesh>& meshes, const Output_options& options)
{
  print(out, document(meshes, options, false));
}

void write_meshes_csv(std::ostream& out, const std::vector<Named_mesh>& meshes, const Output_options& options)
{
  out << "curve,line," << axis_name(options, 0) << ',' << axis_name(options, 1) << ",kind\n";
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    const auto lines = polylines(meshes[m].mesh);
    for (std::size_t l = 0; l < lines.size(); ++l)
      for (const std::size_t v : lines[l]) {
        const auto& vertex = meshes[m].mesh.vertices[v];
        out << m << ',' << l << ',' << number(vertex.point[0]) << ',' << number(vertex.point[1]) << ',' << kind(vertex)
            << '\n';
      }
  }
}

void write_meshes_wkt(std::ostream& out, const std::vector<Named_mesh>& meshes, const Output_options&)
{
  for (const auto& [name, mesh] : meshes) {
    std::string lines;
    std::string points;
    for (const auto& line : polylines(mesh)) {
      std::string text;
      for (const std::size_t v : line)
        text +=
            (text.empty() ? "" : ", ") + number(mesh.vertices[v].point[0]) + ' ' + number(mesh.vertices[v].point[1]);
      std::string& list = line.size() == 1 ? points : lines;
      list += (list.empty() ? "(" : ", (") + text + ')';
    }
    const std::string first = lines.empty() ? "MULTILINESTRING EMPTY" : "MULTILINESTRING (" + lines + ')';
    if (points.empty())
      out << first << '\n';
    else
      out << "GEOMETRYCOLLECTION (" << first << ", MULTIPOINT (" << points << "))\n";
  }
}

void write_meshes_dxf(std::ostream& out, const std::vector<Named_mesh>& meshes, const Output_options&)
{
  const auto place = [&](const Curve_vertex& v) {
    out << "10\n" << number(v.point[0]) << "\n20\n" << number(v.point[1]) << "\n30\n0.0\n";
  };
  out << "0\nSECTION\n2\nENTITIES\n";
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    const std::string layer = "8\nCURVE" + std::to_string(m + 1) + '\n';
    const Curve_mesh& mesh = meshes[m].mesh;
    for (const auto& line : polylines(mesh)) {
      if (line.size() == 1) {
        out << "0\nPOINT\n" << layer;
        place(mesh.vertices[line[0]]);
        continue;
      }
      const bool closed = line.front() == line.back();
      out << "0\nPOLYLINE\n" << layer << "66\n1\n70\n" << (closed ? 1 : 0) << "\n10\n0.0\n20\n0.0\n30\n0.0\n";
      for (std::size_t k = 0; k + (closed ? 1 : 0) < line.size(); ++k) {
        out << "0\nVERTEX\n" << layer;
        place(mesh.vertices[line[k]]);
      }
      out << "0\nSEQEND\n" << layer;
    }
  }
  out << "0\nENDSEC\n0\nEOF\n";
}

Mesh_writer mesh_writer_for(const std::filesystem::path& path)
{
  static constexpr std::array<Mesh_writer, 6> writers{{{".svg", draw_meshes_svg},
                                                       {".png", draw_meshes_png},
                                                       {".json", write_meshes_json},
                                                       {".csv", write_meshes_csv},
                                                       {".dxf", write_meshes_dxf},
                                                       {".wkt", write_meshes_wkt}}};
  std::string known;
  for (const auto& writer : writers) {
    if (path.extension() == writer.ending) return writer;
    known += (known.empty() ? "" : " ") + std::string(writer.ending);
  }
  throw Invalid_input("output: '" + path.string() + "' has no known ending for a mesh; expected one of " + known);
}

} // namespace corral
