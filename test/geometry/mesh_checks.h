// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_TEST_GEOMETRY_MESH_CHECKS_H
#define CORRAL_TEST_GEOMETRY_MESH_CHECKS_H

#include <corral/algebra/real_roots.h>
#include <corral/decision/ideal_raster.h>
#include <corral/geometry/mesh_curve.h>
#include <corral/polynomial/parse.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace corral::test {

inline Polynomial<Rational, 2> curve(const std::string& text) { return parse_polynomial<2>(text, {"x", "y"}); }

inline Rational_box<2> box(const Rational& x0, const Rational& x1, const Rational& y0, const Rational& y1)
{
  return {Rational_interval(x0, x1), Rational_interval(y0, y1)};
}

/// f on the line where one coordinate has a value.
inline Integer_polynomial on_line(const Polynomial<Rational, 2>& f, std::size_t axis, const Rational& value)
{
  std::vector<Polynomial<Rational, 1>::Term> terms;
  for (const auto& term : f.terms()) {
    Rational c = term.coefficient;
    for (unsigned k = 0; k < term.exponents[axis]; ++k) c *= value;
    terms.push_back({{term.exponents[1 - axis]}, c});
  }
  return integer_polynomial(collect<Rational, 1>(std::move(terms)));
}

/// Twice the signed area of a triangle.
inline int orientation(const Rational_point<2>& a, const Rational_point<2>& b, const Rational_point<2>& c)
{
  return sgn(Rational((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])));
}

inline bool is_between(const Rational_point<2>& p, const Rational_point<2>& a, const Rational_point<2>& b)
{
  for (std::size_t k = 0; k < 2; ++k)
    if (p[k] < std::min(a[k], b[k]) || p[k] > std::max(a[k], b[k])) return false;
  return true;
}

/// Whether two edges meet elsewhere than in a common vertex.
inline bool cross(const Curve_mesh& mesh, const std::array<std::size_t, 2>& e, const std::array<std::size_t, 2>& f)
{
  const auto point = [&](std::size_t v) -> const Rational_point<2>& { return mesh.vertices[v].point; };
  const auto on = [&](std::size_t v, const std::array<std::size_t, 2>& edge) {
    return v != edge[0] && v != edge[1] && orientation(point(edge[0]), point(edge[1]), point(v)) == 0
           && is_between(point(v), point(edge[0]), point(edge[1]));
  };
  if (on(e[0], f) || on(e[1], f) || on(f[0], e) || on(f[1], e)) return true;
  return orientation(point(e[0]), point(e[1]), point(f[0])) * orientation(point(e[0]), point(e[1]), point(f[1])) < 0
         && orientation(point(f[0]), point(f[1]), point(e[0])) * orientation(point(f[0]), point(f[1]), point(e[1])) < 0;
}

/// The first pair of edges that cross, "" if none do.
inline std::string find_crossing(const Curve_mesh& mesh)
{
  for (std::size_t i = 0; i < mesh.edges.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (cross(mesh, mesh.edges[i], mesh.edges[j]))
        return "edges " + std::to_string(j) + " and " + std::to_string(i) + " cross";
  return "";
}

/// A vertex inside the box that is not singular and from which not two edges run; "" if there is none.
inline std::string find_loose_end(const Curve_mesh& mesh)
{
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const auto& vertex = mesh.vertices[v];
    if (!vertex.is_singular && !vertex.is_on_boundary && vertex.branches != 2)
      return "vertex " + std::to_string(v) + " has " + std::to_string(vertex.branches) + " branches";
  }
  return "";
}

/// Whether f has a zero in a closed box, which may be flat. Exact.
inline bool holds_zero(const Polynomial<Rational, 2>& f, const Rational_box<2>& box)
{
  for (const std::size_t axis : {0U, 1U})
    if (box[axis].lower() == box[axis].upper()) {
      const auto p = on_line(f, axis, box[axis].lower());
      return p.is_zero() || count_real_roots(p, box[1 - axis]) > 0;
    }
  return Cell_decider<2>(f, Grid<2>(box, {1, 1})).decide({0, 0}).verdict == Verdict::hit;
}

/// A vertex whose box holds no zero, or an edge with its middle further than the tolerance from the curve; "" if there
/// is none.
inline std::string find_stray(const Curve_mesh& mesh, const Polynomial<Rational, 2>& f, const Rational& tolerance)
{
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    if (!holds_zero(f, mesh.vertices[v].box)) return "vertex " + std::to_string(v);
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const auto& a = mesh.vertices[mesh.edges[e][0]].point;
    const auto& b = mesh.vertices[mesh.edges[e][1]].point;
    Rational_box<2> near;
    for (std::size_t k = 0; k < 2; ++k) near[k] = {(a[k] + b[k]) / 2 - tolerance, (a[k] + b[k]) / 2 + tolerance};
    if (!holds_zero(f, near)) return "edge " + std::to_string(e);
  }
  return "";
}

} // namespace corral::test

#endif
