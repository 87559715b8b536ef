// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/geometry/mesh_curve.h>

#include "Curve_cells.h"
#include "components.h"
#include "nesting.h"

#include "../algebra/restriction.h"

#include <corral/errors.h>
#include <corral/number/Double_bracket.h>
#include <corral/number/Environment.h>
#include <corral/number/format.h>
#include <corral/polynomial/square_free.h>
#include <corral/polynomial/substitution.h>

#include <algorithm>
#include <array>
#include <utility>

namespace corral {

namespace {

using namespace geometry;

Rational rational(const Integer& c) { return c; }

/// First cuts that no curve drawn by people has for a special coordinate, nor for the corners they make; dyadic with
/// few bits.
constexpr std::array<std::array<double, 2>, 6> first_cuts{{{265.0 / 512, 251.0 / 512},
                                                           {243.0 / 512, 275.0 / 512},
                                                           {277.0 / 512, 231.0 / 512},
                                                           {233.0 / 512, 289.0 / 512},
                                                           {287.0 / 512, 221.0 / 512},
                                                           {219.0 / 512, 301.0 / 512}}};

void require_meshable(const Polynomial<Rational, 2>& f, const Rational_box<2>& box, const Rational& tolerance)
{
  if (f.is_zero())
    throw Invalid_input("mesh_curve: the polynomial is zero, so that every point is a zero; expected one that is not");
  for (std::size_t k = 0; k < 2; ++k)
    if (box[k].lower() >= box[k].upper())
      throw Invalid_input("mesh_curve: side " + std::to_string(k + 1) + " of the box is the point "
                          + box[k].lower().get_str() + "; expected LOWER < UPPER");
  if (tolerance <= 0)
    throw Invalid_input("mesh_curve: the tolerance is " + tolerance.get_str() + "; expected a positive number");
}

/// A curve and the sides of a box that are part of it.
struct Parts
{
  Polynomial<Integer, 2> rest;
  std::array<std::array<bool, 2>, 2> side{}; ///< [normal axis][lower or upper]
};

Parts without_sides(const Polynomial<Rational, 2>& f, const Rational_box<2>& box)
{
  Parts parts{square_free_part(f), {}};
  for (const std::size_t normal : {0U, 1U})
    for (const std::size_t end : {0U, 1U}) {
      const Rational& value = end == 0 ? box[normal].lower() : box[normal].upper();
      if (parts.rest.is_constant() || !exact::restriction(parts.rest, normal, value).is_zero()) continue;
      auto by_other = exact::bivariate(parts.rest, 1 - normal);
      for (auto& c : by_other) c = exact_quotient(c, {-value.get_num(), value.get_den()});
      parts.rest = exact::polynomial(by_other, 1 - normal);
      parts.side[normal][end] = true;
    }
  return parts;
}

Polynomial<Integer, 2> on_unit_box(const Polynomial<Integer, 2>& f, const Rational_box<2>& box)
{
  return integer_primitive(
      affine_substitution(transform<Rational>(f, rational), {box[0].lower(), box[1].lower()},
                          {Rational(box[0].upper() - box[0].lower()), Rational(box[1].upper() - box[1].lower())}));
}

/// From the pieces in the unit box to the mesh in the caller's box.
class Assembly
{
public:
  Assembly(Plane_graph graph, const std::vector<Singular_points::Point>& singular, const Rational_box<2>& box)
      : graph_(std::move(graph)), singular_(singular)
  {
    mesh_.box = box;
    for (std::size_t k = 0; k < 2; ++k) width_[k] = box[k].upper() - box[k].lower();
  }

  /// Adds the side of the box between the vertices on it. \param on_side  in increasing order.
  void add_side(std::size_t normal, std::size_t end, std::vector<std::size_t> on_side)
  {
    crossings_.insert(crossings_.end(), on_side.begin(), on_side.end()); // whatever else meets the side
    for (const bool upper : {false, true}) {
      std::array<double, 2> corner{};
      corner[normal] = static_cast<double>(end);
      corner[1 - normal] = upper ? 1 : 0;
      const std::size_t vertex = corner_vertex(corner);
      const auto is_it = [&](std::size_t v) { return graph_.find(v) == graph_.find(vertex); };
      if (std::none_of(on_side.begin(), on_side.end(), is_it))
        on_side.insert(upper ? on_side.end() : on_side.begin(), vertex);
    }
    for (std::size_t k = 0; k + 1 < on_side.size(); ++k) graph_.connect(on_side[k], on_side[k + 1]);
  }

  [[nodiscard]] Curve_mesh finish()
  {
    std::vector<std::size_t> index(graph_.size());
    mesh_.vertices.reserve(graph_.size());
    for (std::size_t node = 0; node < graph_.size(); ++node)
      if (graph_.find(node) == node) {
        index[node] = mesh_.vertices.size();
        mesh_.vertices.push_back(vertex(graph_.node(node)));
      }
    mesh_.edges.reserve(graph_.edges().size());
    for (const auto& [a, b] : graph_.edges()) mesh_.edges.push_back({index[graph_.find(a)], index[graph_.find(b)]});
    for (const std::size_t node : crossings_) mesh_.vertices[index[graph_.find(node)]].is_singular = true;
    return std::move(mesh_);
  }

private:
  /// The vertex at a corner. One that is already there lies on another part of the curve, too.
  std::size_t corner_vertex(const std::array<double, 2>& corner)
  {
    const auto is_at = [&](const Range& range, double x) { return range.low == x && range.high == x; };
    for (std::size_t node = 0; node < graph_.size(); ++node)
      if (const auto& box = graph_.node(node).box; is_at(box[0], corner[0]) && is_at(box[1], corner[1])) {
        crossings_.push_back(node);
        return node;
      }
    return graph_.add({{Range{corner[0], corner[0]}, Range{corner[1], corner[1]}}});
  }

  [[nodiscard]] Rational_interval side(const Range& range, std::size_t axis) const
  {
    const auto& whole = mesh_.box[axis];
    if (range.low == 0 && range.high == 1) return whole;
    Rational low = whole.lower() + width_[axis] * Rational(range.low);
    if (range.low == range.high) return Rational_interval(std::move(low));
    return {std::move(low), Rational(whole.lower() + width_[axis] * Rational(range.high))};
  }

  [[nodiscard]] Curve_vertex vertex(const Plane_graph::Node& node) const
  {
    Curve_vertex result;
    for (std::size_t k = 0; k < 2; ++k) {
      const Range& range = node.box[k];
      result.box[k] = side(range, k);
      result.is_on_boundary = result.is_on_boundary || (range.low == range.high && (range.low == 0 || range.low == 1));
    }
    if (node.singular >= 0) {
      const auto& point = singular_[static_cast<std::size_t>(node.singular)];
      result.is_singular = true;
      result.box = point.box;
    }
    for (std::size_t k = 0; k < 2; ++k)
      result.point[k] = result.box[k].lower() == result.box[k].upper()
                            ? result.box[k].lower()
                            : Rational((result.box[k].lower() + result.box[k].upper()) / 2);
    return result;
  }

  Plane_graph graph_;
  const std::vector<Singular_points::Point>& singular_;
  std::array<Rational, 2> width_;
  std::vector<std::size_t> crossings_;
  Curve_mesh mesh_;
};

/// Runs with the first choice of cuts that meets nothing special; false if none does.
bool finds_generic_cuts(Curve_cells& curve)
{
  for (const auto& cuts : first_cuts) {
    try {
      curve.run(cuts);
      return true;
    } catch (const Not_generic&) {
    }
  }
  return false;
}

} // namespace

Curve_mesh mesh_curve(const Polynomial<Rational, 2>& f, const Rational_box<2>& box, const Rational& tolerance,
                      const Run_options& run)
{
  const Nearest_scope scope;
  require_meshable(f, box, tolerance);
  const Parts parts = without_sides(f, box);
  Singular_points singular(parts.rest, box, checkpoint_of(run, "mesh_curve"));
  Curve_settings settings;
  for (std::size_t k = 0; k < 2; ++k) settings.size[k] = bracket(box[k].upper() - box[k].lower()).above;
  settings.tolerance = bracket(tolerance).below;
  settings.aspect = (box[1].upper() - box[1].lower()) / (box[0].upper() - box[0].lower());
  settings.run = run;
  Plane_graph graph;
  Outline outline;
  std::vector<Curve_cells::Doubt> doubts;
  std::size_t cells = 0;
  if (!parts.rest.is_constant()) {
    const auto on_unit = on_unit_box(parts.rest, box);
    Curve_cells curve(on_unit, singular, settings);
    if (!finds_generic_cuts(curve)) {
      Curve_mesh nothing;
      nothing.box = box;
      nothing.uncertified.push_back({box, "each choice of first cuts meets a special point of the curve"});
      return nothing;
    }
    graph = curve.take_graph();
    outline = curve.outline();
    doubts = curve.doubts();
    cells = curve.cells();
  }
  Assembly assembly(std::move(graph), singular.points(), box);
  for (const std::size_t normal : {0U, 1U})
    for (const std::size_t end : {0U, 1U})
      if (parts.side[normal][end]) assembly.add_side(normal, end, outline.side[normal][end]);
  Curve_mesh mesh = assembly.finish();
  mesh.cells = cells;
  for (const auto& doubt : doubts) {
    Rational_box<2> region;
    for (std::size_t k = 0; k < 2; ++k) {
      const Rational width = box[k].upper() - box[k].lower();
      region[k] = {box[k].lower() + width * Rational(doubt.box[k].low),
                   box[k].lower() + width * Rational(doubt.box[k].high)};
    }
    mesh.uncertified.push_back({region, doubt.reason});
  }
  find_components(mesh);
  find_nesting(mesh);
  return mesh;
}

} // namespace corral
