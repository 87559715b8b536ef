// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Curve_cells.h"

#include "in_cell.h"

#include <algorithm>
#include <cmath>

/// \file
/// Cells in which the curve is a graph over a slanted axis.
namespace corral::geometry {

namespace {

constexpr double coarse = 0x1p-10; // parts of sides up to which zeros are known
constexpr double fine = 0x1p-26;

struct Crossing
{
  Interval place; ///< of the linear form that is constant along v
  std::size_t vertex;
  std::size_t side;
};

/// The zeros on the border in the order of the form v[1] x - v[0] y; nothing if it is not clear, or not all of them are
/// crossings.
std::optional<std::vector<Crossing>> crossings(const Plane_graph& graph, const Border& border, const Cell& cell,
                                               const std::array<double, 2>& v)
{
  for (const auto& column : border.corner)
    if (column[0] || column[1]) return std::nullopt;
  std::vector<Crossing> result;
  for (const std::size_t normal : {0U, 1U})
    for (const std::size_t end : {0U, 1U}) {
      const auto& signs = border.zeros[normal][end].signs;
      for (std::size_t k = 0; k + 1 < signs.size(); ++k) {
        if (signs[k] == signs[k + 1]) return std::nullopt;
        const std::size_t vertex = border.inside[normal][end][k];
        const auto& box = graph.node(vertex).box;
        result.push_back({Interval(v[1]) * in_cell(box[0], cell.box[0]) - Interval(v[0]) * in_cell(box[1], cell.box[1]),
                          vertex, 2 * normal + end});
      }
    }
  std::sort(result.begin(), result.end(),
            [](const Crossing& a, const Crossing& b) { return a.place.lower() < b.place.lower(); });
  for (std::size_t k = 0; k + 1 < result.size(); ++k)
    if (result[k].place.upper() >= result[k + 1].place.lower()) return std::nullopt;
  return result;
}

} // namespace

/// How much of the form's range a chord may span and be close to the graph: as `is_flat`, with the form as the
/// coordinate along the graph.
double Curve_cells::flat_span(const Cell& cell, const std::array<double, 2>& v) const
{
  if (is_small(cell)) return HUGE_VAL;
  constexpr double slack = 1 + 0x1p-40;
  const double square = v[0] * v[0] + v[1] * v[1];
  const std::array<double, 2> w{std::fabs(v[1]) / square, std::fabs(v[0]) / square};
  const std::array<double, 2> u{std::fabs(v[0]), std::fabs(v[1])};
  const double x = cell.form.derivative({1, 0}).magnitude();
  const double y = cell.form.derivative({0, 1}).magnitude();
  const double xx = cell.form.derivative({2, 0}).magnitude();
  const double xy = cell.form.derivative({1, 1}).magnitude();
  const double yy = cell.form.derivative({0, 2}).magnitude();
  const auto second = [&](const auto& a, const auto& b) {
    return a[0] * b[0] * xx + (a[0] * b[1] + a[1] * b[0]) * xy + a[1] * b[1] * yy;
  };
  const Range across = cell.form.derivative_along(v);
  const double least = across.low > 0 ? across.low : -across.high;
  const double slope = (w[0] * x + w[1] * y) / least;
  const double bend = (second(w, w) + 2 * second(w, u) * slope + second(u, u) * slope * slope) / least;
  const double stretch =
      std::hypot(v[0] * cell.length(0) * settings_.size[0], v[1] * cell.length(1) * settings_.size[1]);
  return std::sqrt(4 * settings_.tolerance / (bend * stretch * slack)) / slack;
}

/// A cell that may have a direction v along which the derivative has no zero: the curve is a graph across v.
Curve_cells::Shape Curve_cells::resolve_slanted(const Cell& cell, const std::array<double, 2>& v, Outline& outline)
{
  if (v[0] == 0 || v[1] == 0 || cell.form.derivative_along(v).has_zero()) return Shape::unclear;
  const double span = flat_span(cell, v);
  if (!(span > coarse * (std::fabs(v[0]) + std::fabs(v[1])))) return Shape::coarse;
  const std::size_t nodes = graph_.size();
  const std::size_t edges = graph_.edges().size();
  for (const double precision : {coarse, fine}) {
    const Border found = clear_border(cell, precision);
    if (connect_slanted(found, cell, v, span)) {
      outline = found.outline();
      return Shape::done;
    }
    graph_.roll_back(nodes, edges);
    if (!is_small(cell)) break; // its halves are looked at anyway
  }
  return Shape::coarse;
}

/// Joins zeros on the border in pairs. False if their order is not clear or a chord would lie on a side or be too long.
bool Curve_cells::connect_slanted(const Border& border, const Cell& cell, const std::array<double, 2>& v, double span)
{
  const auto events = crossings(graph_, border, cell, v);
  if (!events || events->size() % 2 != 0) return false;
  for (std::size_t k = 0; k < events->size(); k += 2) {
    const auto& start = (*events)[k];
    const auto& end = (*events)[k + 1];
    if (start.side == end.side || end.place.upper() - start.place.lower() > span) return false;
    graph_.connect(start.vertex, end.vertex);
  }
  return true;
}

} // namespace corral::geometry
