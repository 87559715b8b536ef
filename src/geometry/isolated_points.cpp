// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/errors.h>
#include <corral/geometry/mesh_curve.h>
#include <corral/geometry/solve.h>

#include <algorithm>

namespace corral {

namespace {

bool meet(const Rational_box<2>& a, const Rational_box<2>& b)
{
  for (std::size_t k = 0; k < 2; ++k)
    if (a[k].upper() < b[k].lower() || b[k].upper() < a[k].lower()) return false;
  return true;
}

/// The vertex of a mesh that is a singular point. \pre There is one.
const Curve_vertex& vertex_at(const Curve_mesh& mesh, Algebraic_point& point)
{
  for (;;) {
    std::vector<const Curve_vertex*> found;
    for (const auto& vertex : mesh.vertices)
      if (vertex.is_singular && meet(vertex.box, point.box())) found.push_back(&vertex);
    if (found.size() == 1) return *found.front();
    point.refine_to((point.box()[0].upper() - point.box()[0].lower()) / 1024);
  }
}

} // namespace

std::vector<Algebraic_point> isolated_points(const Polynomial<Rational, 2>& f,
                                             const std::optional<Rational_box<2>>& box, const Run_options& run)
{
  auto singular = singular_points(f, box, run);
  if (singular.empty()) return {};
  Rational_box<2> around = singular.front().point.box();
  for (const auto& [point, order] : singular)
    for (std::size_t k = 0; k < 2; ++k)
      around[k] = {std::min(around[k].lower(), point.box()[k].lower()),
                   std::max(around[k].upper(), point.box()[k].upper())};
  Rational longest = 1;
  for (auto& side : around) {
    side = {side.lower() - 1, side.upper() + 1}; // no point lies on the border
    longest = std::max<Rational>(longest, side.upper() - side.lower());
  }
  const auto mesh = mesh_curve(f, around, longest, run);
  if (run.stop.stop_requested()) throw Cancelled("isolated_points: stopped on request");
  if (!mesh.is_certified()) throw Budget_exceeded("isolated_points: " + mesh.uncertified.front().reason);
  std::vector<Algebraic_point> result;
  for (auto& [point, order] : singular)
    if (vertex_at(mesh, point).branches == 0) result.push_back(std::move(point));
  return result;
}

} // namespace corral
