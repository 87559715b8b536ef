// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Curve_cells.h"

#include "in_cell.h"

#include <corral/internal/polynomial/integer_form.h>
#include <corral/polynomial/arithmetic.h>

#include <algorithm>
#include <cmath>

/// \file
/// Cells with a singular point.
namespace corral::geometry {

/// A direction in a cell's coordinates. The linear form that is constant along it is v[1] x - v[0] y.
struct Direction
{
  std::array<Interval, 2> v;

  [[nodiscard]] Interval form(const std::array<Interval, 2>& at) const { return v[1] * at[0] - v[0] * at[1]; }
};

namespace {

constexpr double guess_length = 0x1p-4;   // of cells in which a singular point is guessed
constexpr double algebra_length = 0x1p-9; // of cells for which all are computed
// Parts of a side up to which its zeros are known, so that signs at them show: two tries.
constexpr std::array<double, 2> fine{0x1p-26, 0x1p-42};
constexpr double strip_length = 0x1p-5; // of cells that are compared with all critical values

struct Hessian
{
  explicit Hessian(const Cell_form& form)
      : xx(interval(form.derivative({2, 0}))), xy(interval(form.derivative({1, 1}))),
        yy(interval(form.derivative({0, 2})))
  {}

  [[nodiscard]] Interval along(const Direction& d) const
  {
    return square(d.v[0]) * xx + Interval(2) * d.v[0] * d.v[1] * xy + square(d.v[1]) * yy;
  }
  /// Whether no zero but a singular point itself is critical in this direction. Proof: doc/geometry.md.
  [[nodiscard]] bool is_regular(const Direction& d) const
  {
    const bool first = contains_zero(d.v[1]); // the other basis vector
    const Interval own = first ? yy : xx;
    const Interval mixed = first ? d.v[0] * xy + d.v[1] * yy : d.v[0] * xx + d.v[1] * xy;
    const Interval both = along(d);
    if (contains_zero(both)) return false;
    return !contains_zero(own * square(both) - Interval(2) * mixed * mixed * both + both * square(mixed));
  }

  Interval xx;
  Interval xy;
  Interval yy;
};

/// Whether each zero on the border, but the point itself, lies on a branch that runs towards the point as it enters.
class Entrance
{
public:
  /// \param slopes  where doubles do not show a sign; may be null.
  Entrance(const Cell& cell, const Plane_graph& graph, const Direction& direction, const Slopes* slopes,
           const std::array<Interval, 2>& point)
      : cell_(cell), graph_(graph), direction_(direction), slopes_(slopes), form_at_point_(direction.form(point))
  {}

  [[nodiscard]] bool leads_to_point(std::size_t vertex, std::size_t normal, bool upper) const
  {
    return strict_sign(form_at_point_ - form_at(vertex)) * growth_inward(vertex, normal, upper) > 0;
  }
  /// The sign of the growth of the direction's form on the way inside; 0 if it is not clear.
  [[nodiscard]] int growth_inward(std::size_t vertex, std::size_t normal, bool upper) const
  {
    const auto gradient = gradient_at(position(vertex)[1 - normal], normal, upper);
    // Along (f_y, -f_x) the form grows by f_v; the inner normal tells which way leads inside.
    int growth = strict_sign(direction_.v[0] * gradient[0] + direction_.v[1] * gradient[1]);
    int along = strict_sign(gradient[1 - normal]);
    if (growth * along == 0 && slopes_ != nullptr) {
      const auto& box = graph_.node(vertex).box;
      growth = sign_on_side(slopes_->along_direction, normal, box[normal].low, box[1 - normal]);
      along = sign_on_side(slopes_->along_axis[1 - normal], normal, box[normal].low, box[1 - normal]);
    }
    return growth * along * ((normal == 0) == upper ? -1 : 1);
  }
  [[nodiscard]] Interval form_at(std::size_t vertex) const { return direction_.form(position(vertex)); }

private:
  [[nodiscard]] std::array<Interval, 2> position(std::size_t vertex) const
  {
    const auto& box = graph_.node(vertex).box;
    return {in_cell(box[0], cell_.box[0]), in_cell(box[1], cell_.box[1])};
  }
  [[nodiscard]] std::array<Interval, 2> gradient_at(const Interval& where, std::size_t normal, bool upper) const
  {
    const auto& form = cell_.form;
    const Range part{std::max(0.0, where.lower()), std::min(1.0, where.upper())};
    const double error = 2.001 * form.error() + 0x1p-51 * form.largest();
    auto across = range_on_part(form.slope_on_side(normal, upper), error, part);
    std::vector<double> along = form.side(normal, upper);
    for (std::size_t i = 0; i + 1 < along.size(); ++i) along[i] = along[i + 1] - along[i];
    if (along.size() > 1)
      along.pop_back();
    else
      along[0] = 0;
    std::array<Interval, 2> gradient;
    gradient[normal] = interval(across) * Interval(static_cast<int>(form.degree(normal)));
    gradient[1 - normal] =
        interval(range_on_part(along, error, part)) * Interval(static_cast<int>(form.degree(1 - normal)));
    return gradient;
  }

  const Cell& cell_;
  const Plane_graph& graph_;
  const Direction& direction_;
  const Slopes* slopes_;
  Interval form_at_point_;
};

bool overlap(const Range& a, const Range& b) { return a.low <= b.high && b.low <= a.high; }

/// The vertex on the border that is the point itself, a new one if it lies inside, none if that is not clear.
std::optional<std::size_t> vertex_at(Plane_graph& graph, const Border& border, const Cell& cell,
                                     const std::array<Range, 2>& point)
{
  std::array<int, 2> on{-1, -1}; // the end of each axis on which it lies
  for (std::size_t k = 0; k < 2; ++k)
    if (point[k].low == point[k].high)
      on[k] = point[k].low == cell.box[k].low ? 0 : point[k].low == cell.box[k].high ? 1 : -1;
  if (on[0] >= 0 && on[1] >= 0) return border.corner[static_cast<std::size_t>(on[0])][static_cast<std::size_t>(on[1])];
  for (std::size_t k = 0; k < 2; ++k) {
    if (on[k] < 0) continue;
    std::optional<std::size_t> found;
    for (const std::size_t vertex : border.inside[k][static_cast<std::size_t>(on[k])])
      if (overlap(graph.node(vertex).box[1 - k], point[1 - k])) {
        if (found) return std::nullopt;
        found = vertex;
      }
    return found;
  }
  return graph.add({point});
}

/// Joins all zeros on the border with the point. False if not all lead there, or a chord would lie on a side.
bool connect_star(Plane_graph& graph, const Outline& outline, std::size_t centre, const Entrance& entrance)
{
  for (const std::size_t normal : {0U, 1U})
    for (const std::size_t end : {0U, 1U}) {
      const auto& side = outline.side[normal][end];
      if (side.size() > 1 && std::find(side.begin(), side.end(), centre) != side.end()) return false;
      for (const std::size_t vertex : side) {
        if (vertex == centre) continue;
        if (!entrance.leads_to_point(vertex, normal, end == 1)) return false;
        graph.connect(vertex, centre);
      }
    }
  return true;
}

/// The derivative of some order along a direction, on the cell.
Interval derivative_along(const Cell_form& form, const Direction& direction, unsigned order)
{
  Interval sum = 0;
  Integer binomial = 1;
  for (unsigned i = 0; i <= order; ++i) {
    sum += enclose<Interval>(Rational(binomial)) * power(direction.v[0], i) * power(direction.v[1], order - i)
           * interval(form.derivative({i, order - i}));
    binomial = binomial * (order - i) / (i + 1);
  }
  return sum;
}

/// A zero on the border of a cell that is swept in the order of a direction's form.
struct Passage
{
  Interval form;
  std::size_t vertex;
  std::size_t side;
  bool is_low;   ///< on the part of the border where the direction points inside
  bool is_start; ///< the form grows on the way inside
};

/// Joins starts and ends of arcs by a sweep: on each line along the direction they are in a fixed order. False if the
/// order of events is not clear, or a chord would lie on a side.
bool connect_stack(Plane_graph& graph, const Border& border, const Direction& direction, const Entrance& entrance)
{
  std::vector<Passage> passages;
  const int slant = strict_sign(direction.v[0]);
  for (const std::size_t normal : {0U, 1U})
    for (const std::size_t end : {0U, 1U})
      for (const std::size_t vertex : border.inside[normal][end]) {
        const int growth = entrance.growth_inward(vertex, normal, end == 1);
        if (growth == 0) return false;
        const bool is_low = normal == 1 ? end == 0 : (end == 0) == (slant > 0);
        passages.push_back({entrance.form_at(vertex), vertex, 2 * normal + end, is_low, growth > 0});
      }
  std::sort(passages.begin(), passages.end(),
            [](const auto& a, const auto& b) { return a.form.lower() < b.form.lower(); });
  for (std::size_t k = 0; k + 1 < passages.size(); ++k)
    if (passages[k].form.upper() >= passages[k + 1].form.lower()) return false;
  std::vector<Passage> open; // from low to high
  for (const Passage& passage : passages) {
    const auto place = passage.is_low ? open.begin() : open.end();
    if (passage.is_start) {
      open.insert(place, passage);
      continue;
    }
    if (open.empty()) return false;
    const auto start = passage.is_low ? place : place - 1;
    if (start->side == passage.side) return false;
    graph.connect(start->vertex, passage.vertex);
    open.erase(start);
  }
  return open.empty();
}

/// Whether the curve passes through a corner that is not the point. \throw Not_generic if a cut makes the corner.
bool has_other_corner(const Plane_graph& graph, const Border& border, std::size_t centre)
{
  const auto is_end = [](double x) { return x == 0 || x == 1; };
  for (const auto& column : border.corner)
    for (const auto& corner : column) {
      if (!corner || *corner == centre) continue;
      const auto& box = graph.node(*corner).box;
      if (!is_end(box[0].low) || !is_end(box[1].low)) throw Not_generic{};
      return true;
    }
  return false;
}

} // namespace

Curve_cells::Shape Curve_cells::resolve_singular(const Cell& cell, Outline& outline)
{
  const double longest = std::max(cell.length(0), cell.length(1));
  auto points = singular_.in(cell.box);
  if (points.empty() && !singular_.is_complete() && !cell.form.is_surely_regular()) {
    if (longest < guess_length && singular_.guess(cell.box))
      points = singular_.in(cell.box);
    else if (longest < algebra_length) {
      singular_.complete();
      points = singular_.in(cell.box);
    }
  }
  if (points.size() == 1) return resolve_star(cell, points[0], outline);
  if (points.empty() && singular_.is_complete() && longest < strip_length) return resolve_stack(cell, outline);
  return Shape::unclear;
}

/// A cell with one singular point.
Curve_cells::Shape Curve_cells::resolve_star(const Cell& cell, std::size_t point, Outline& outline)
{
  const Hessian hessian(cell.form);
  for (const auto& v : {std::array{0, 1}, std::array{1, 0}, std::array{1, 1}, std::array{1, -1}}) {
    const Direction direction{{Interval(v[0]), Interval(v[1])}};
    if (!hessian.is_regular(direction)) continue;
    if (!is_small(cell)) return Shape::coarse;
    if (finish_star(cell, point, direction, nullptr, outline)) return Shape::done;
  }
  if (!is_small(cell) || std::max(cell.length(0), cell.length(1)) > strip_length) return Shape::unclear;
  singular_.complete();
  const Direction direction = critical_direction(cell);
  const bool is_double = !contains_zero(hessian.along(direction));
  if (!is_double && contains_zero(derivative_along(cell.form, direction, singular_.order_along(point))))
    return Shape::unclear;
  if (!singular_.is_regular(cell.box, point)) return Shape::unclear;
  return finish_star(cell, point, direction, &slopes(), outline) ? Shape::done : Shape::unclear;
}

/// Joins the border with the point, in whose cell nothing else is critical in the direction.
bool Curve_cells::finish_star(const Cell& cell, std::size_t point, const Direction& direction, const Slopes* slopes,
                              Outline& outline)
{
  const std::size_t nodes = graph_.size();
  const std::size_t edges = graph_.edges().size();
  const auto box = singular_.points()[point].unit_box;
  const std::array<Interval, 2> at{in_cell(box[0], cell.box[0]), in_cell(box[1], cell.box[1])};
  for (const double precision : fine) {
    const Border found = clear_border(cell, precision);
    const auto centre = vertex_at(graph_, found, cell, box);
    outline = found.outline();
    if (centre && !has_other_corner(graph_, found, *centre)
        && connect_star(graph_, outline, *centre, Entrance(cell, graph_, direction, slopes, at))) {
      graph_.node(*centre).box = box;
      graph_.node(*centre).singular = static_cast<int>(point);
      return true;
    }
    graph_.roll_back(nodes, edges);
  }
  outline = {};
  return false;
}

/// The direction of the lines that tell all singular points apart.
Direction Curve_cells::critical_direction(const Cell& cell) const
{
  const Rational ratio = settings_.aspect * Rational(cell.length(1)) / Rational(cell.length(0));
  return {{enclose<Interval>(-singular_.shear() * ratio), Interval(1)}};
}

const Slopes& Curve_cells::slopes()
{
  if (slopes_) return *slopes_;
  const auto along = [&](std::size_t axis) {
    return transform<Rational>(derivative(f_, axis), [](const Integer& c) { return Rational(c); });
  };
  const Rational slant = -singular_.shear() * settings_.aspect;
  slopes_ = {{derivative(f_, 0), derivative(f_, 1)}, integer_primitive(slant * along(0) + along(1))};
  return *slopes_;
}

/// A cell in which nothing is critical: disjoint arcs along which the direction's form grows.
Curve_cells::Shape Curve_cells::resolve_stack(const Cell& cell, Outline& outline)
{
  if (!is_small(cell) || !singular_.is_regular(cell.box, std::nullopt)) return Shape::unclear;
  const std::size_t nodes = graph_.size();
  const std::size_t edges = graph_.edges().size();
  const Direction direction = critical_direction(cell);
  for (const double precision : fine) {
    const Border found = clear_border(cell, precision);
    if (!has_other_corner(graph_, found, graph_.size())
        && connect_stack(graph_, found, direction,
                         Entrance(cell, graph_, direction, &slopes(), {Interval(0), Interval(0)}))) {
      outline = found.outline();
      return Shape::done;
    }
    graph_.roll_back(nodes, edges);
  }
  return Shape::unclear;
}

} // namespace corral::geometry
