// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Curve_cells.h"

#include <algorithm>
#include <cmath>

namespace corral::geometry {

namespace {

constexpr double coarse = 0x1p-7; // of a side: zeros on it should be apart
constexpr double fine = 0x1p-26;  // where they must be
constexpr double large = 0x1p-5;  // cells so few that precision, which all others inherit, costs nothing
constexpr const char* stopped = "stopped on request";
constexpr double least_length = 0x1p-40; // of a cell in the unit box: its corners are doubles

/// Two zeros on a side have no double between them.
struct Close_branches
{
};

struct Event
{
  Range where;
  std::size_t vertex;
  int side; ///< 0 lower, 1 upper, -1 none of the two
};

} // namespace

Outline Border::outline() const
{
  Outline result;
  for (std::size_t normal = 0; normal < 2; ++normal)
    for (std::size_t end = 0; end < 2; ++end) {
      auto& list = result.side[normal][end];
      const auto corner_at = [&](std::size_t other) { return normal == 0 ? corner[end][other] : corner[other][end]; };
      if (const auto first = corner_at(0)) list.push_back(*first);
      list.insert(list.end(), inside[normal][end].begin(), inside[normal][end].end());
      if (const auto last = corner_at(1)) list.push_back(*last);
    }
  return result;
}

Curve_cells::Curve_cells(const Polynomial<Integer, 2>& f, Singular_points& singular, const Curve_settings& settings)
    : f_(f), singular_(singular), settings_(settings)
{}

void Curve_cells::run(const std::array<double, 2>& first_cuts)
{
  first_cuts_ = first_cuts;
  graph_ = Plane_graph();
  doubts_.clear();
  cells_ = 0;
  const Rational_interval unit(Rational(0), Rational(1));
  outline_ = trace({Cell_form(f_, {unit, unit}), {Range{0, 1}, Range{0, 1}}});
}

Outline Curve_cells::trace(Cell cell)
{
  constexpr std::uint64_t most_cells = std::uint64_t{1} << 21;
  if (settings_.run.progress && cells_ % 256 == 0) settings_.run.progress(0);
  if (settings_.run.stop.stop_requested()) return give_up(cell, stopped);
  ++cells_;
  const double worst = std::max(cell.length(0), cell.length(1)) > large ? 0x1p-32 : 0x1p-16;
  if (cell.form.error() > worst * cell.form.largest()) {
    const auto side = [&](std::size_t k) {
      return Rational_interval(Rational(cell.box[k].low), Rational(cell.box[k].high));
    };
    cell.form = Cell_form(f_, {side(0), side(1)});
  }
  const std::size_t nodes = graph_.size();
  const std::size_t edges = graph_.edges().size();
  Outline outline;
  Shape shape = Shape::unclear;
  try {
    shape = resolve(cell, outline);
  } catch (const Cancelled&) { // by the search of singular points
    return give_up(cell, stopped);
  } catch (const Close_branches&) {
    graph_.roll_back(nodes, edges);
    if (is_small(cell)) return give_up(cell, "two branches are closer than 2^-52 of the box");
  }
  if (shape == Shape::done) return outline;
  if (cells_ > settings_.run.cell_budget.value_or(most_cells))
    return give_up(cell, "more cells than the budget allows");
  return cut(std::move(cell), shape);
}

/// Traces the halves of a cell.
Outline Curve_cells::cut(Cell cell, Shape shape)
{
  const double scale0 = shape == Shape::coarse ? settings_.size[0] : 1;
  const double scale1 = shape == Shape::coarse ? settings_.size[1] : 1;
  const std::size_t axis = cell.length(0) * scale0 >= cell.length(1) * scale1 ? 0 : 1;
  const Range whole = cell.box[axis];
  if (whole.high - whole.low < least_length) return give_up(cell, "cells became too small");
  const double where = whole.low == 0 && whole.high == 1 ? first_cuts_[axis] : 0.5;
  const double middle = whole.low + where * (whole.high - whole.low);
  Cell lower{cell.form.cut(axis, where), cell.box};
  lower.box[axis].high = cell.box[axis].low = middle;
  auto first = trace(std::move(lower));
  return graph_.join(axis, std::move(first), trace(std::move(cell)));
}

Outline Curve_cells::give_up(const Cell& cell, const std::string& reason)
{
  doubts_.push_back({cell.box, reason});
  return border(cell, coarse).outline();
}

Curve_cells::Shape Curve_cells::resolve(Cell& cell, Outline& outline)
{
  if (!cell.form.range().has_zero()) return Shape::done;
  bool is_graph = false;
  for (const std::size_t axis : {0U, 1U}) {
    std::array<std::size_t, 2> order{};
    order[1 - axis] = 1;
    if (cell.form.derivative(order).has_zero()) continue;
    is_graph = true;
    if (resolve_graph(cell, axis, outline) == Shape::done) return Shape::done;
  }
  if (is_graph) return Shape::coarse;
  for (const auto& v : {cell.form.mean_gradient(), cell.form.mean_flat_direction()})
    if (const Shape shape = resolve_slanted(cell, v, outline); shape != Shape::unclear) return shape;
  return resolve_singular(cell, outline);
}

/// The border with all its zeros, up to a part `precision` of its sides.
Border Curve_cells::border(const Cell& cell, double precision)
{
  Border result;
  const auto& form = cell.form;
  std::array<std::array<int, 2>, 2> signs{};
  for (const std::size_t i : {0U, 1U})
    for (const std::size_t j : {0U, 1U}) {
      const double value = form(i * form.degree(0), j * form.degree(1));
      const double x = i == 0 ? cell.box[0].low : cell.box[0].high;
      const double y = j == 0 ? cell.box[1].low : cell.box[1].high;
      signs[i][j] = value > form.error() ? 1 : value < -form.error() ? -1 : sign_at(f_, x, y);
      if (signs[i][j] == 0) result.corner[i][j] = graph_.add({{Range{x, x}, Range{y, y}}});
    }
  for (const std::size_t normal : {0U, 1U})
    for (const std::size_t end : {0U, 1U}) {
      const Segment side = cell.side(normal, end == 1);
      const std::array<int, 2> ends =
          normal == 0 ? std::array{signs[end][0], signs[end][1]} : std::array{signs[0][end], signs[1][end]};
      const double width =
          std::min(settings_.tolerance / (8 * settings_.size[1 - normal]), precision * (side.high - side.low));
      auto zeros = isolate(form.side(normal, end == 1), form.error(), ends, side, width);
      if (!zeros) zeros = isolate_exactly(f_, ends, side, width);
      for (const Range& zero : zeros->zeros) {
        std::array<Range, 2> box;
        box[normal] = {side.at, side.at};
        box[1 - normal] = zero;
        result.inside[normal][end].push_back(graph_.add({box}));
      }
      result.is_clear = result.is_clear && zeros->are_apart;
      result.zeros[normal][end] = std::move(*zeros);
    }
  return result;
}

/// The border of a cell that is to be understood. \throw Close_branches if two zeros on it share a double.
Border Curve_cells::clear_border(const Cell& cell, double precision)
{
  Border result = border(cell, precision);
  if (!result.is_clear) throw Close_branches{};
  return result;
}

bool Curve_cells::is_small(const Cell& cell) const
{
  return std::hypot(cell.length(0) * settings_.size[0], cell.length(1) * settings_.size[1]) * (1 + 0x1p-40)
         <= settings_.tolerance / 2;
}

/// Whether the means of the derivatives alone, no larger than the bounds, make `is_flat` false: a quick look.
bool Curve_cells::is_surely_bent(const Cell& cell, std::size_t axis) const
{
  const auto gradient = cell.form.mean_gradient();
  const auto [xx, xy, yy] = cell.form.mean_hessian();
  const double along = axis == 0 ? xx : yy;
  const double across = axis == 0 ? yy : xx;
  const double slope = std::fabs(gradient[axis] / gradient[1 - axis]);
  const double second = (std::fabs(along) + 2 * std::fabs(xy) * slope + std::fabs(across) * slope * slope)
                        / std::fabs(gradient[1 - axis]);
  return second / 8 * cell.length(1 - axis) * settings_.size[1 - axis] > settings_.tolerance / 2;
}

/// Whether the chords of the graph over `axis` are close to it. Proof: doc/geometry.md.
bool Curve_cells::is_flat(const Cell& cell, std::size_t axis) const
{
  const auto bound = [&](std::size_t along, std::size_t across) {
    std::array<std::size_t, 2> order{};
    order[axis] = along;
    order[1 - axis] = across;
    return cell.form.derivative(order);
  };
  if (is_surely_bent(cell, axis)) return false;
  const Range across = bound(0, 1);
  const double least = across.low > 0 ? across.low : -across.high;
  const double slope = bound(1, 0).magnitude() / least;
  const double second =
      (bound(2, 0).magnitude() + 2 * bound(1, 1).magnitude() * slope + bound(0, 2).magnitude() * slope * slope) / least;
  return second / 8 * cell.length(1 - axis) * settings_.size[1 - axis] * (1 + 0x1p-40) <= settings_.tolerance / 2;
}

Curve_cells::Shape Curve_cells::resolve_graph(const Cell& cell, std::size_t axis, Outline& outline)
{
  const bool small = is_small(cell);
  if (!small && !is_flat(cell, axis)) return Shape::coarse;
  const std::size_t nodes = graph_.size();
  const std::size_t edges = graph_.edges().size();
  for (const double precision : {coarse, fine}) {
    const Border found = clear_border(cell, precision);
    if (connect_graph(found, axis)) {
      outline = found.outline();
      return Shape::done;
    }
    graph_.roll_back(nodes, edges);
    if (!small) break; // its halves are looked at anyway
  }
  return Shape::coarse;
}

/// Joins neighbours along the graph. False if a piece would have both ends on one side, or their order is not clear.
bool Curve_cells::connect_graph(const Border& border, std::size_t axis)
{
  const std::size_t across = 1 - axis;
  const auto corner = [&](std::size_t along, std::size_t up) {
    return axis == 0 ? border.corner[along][up] : border.corner[up][along];
  };
  std::vector<Event> events;
  for (const int up : {0, 1})
    for (const std::size_t vertex : border.inside[across][static_cast<std::size_t>(up)])
      events.push_back({graph_.node(vertex).box[axis], vertex, up});
  std::sort(events.begin(), events.end(), [](const Event& a, const Event& b) { return a.where.low < b.where.low; });
  for (std::size_t k = 0; k + 1 < events.size(); ++k)
    if (events[k].side != events[k + 1].side && events[k].where.high >= events[k + 1].where.low) return false;
  const auto end_event = [&](std::size_t along) -> std::optional<Event> {
    for (const int up : {0, 1})
      if (const auto vertex = corner(along, static_cast<std::size_t>(up))) return Event{{}, *vertex, up};
    if (!border.inside[axis][along].empty()) return Event{{}, border.inside[axis][along].front(), -1};
    return std::nullopt;
  };
  std::optional<Event> last = end_event(0);
  events.push_back({});
  std::array<std::size_t, 2> gap{0, 0};
  for (std::size_t k = 0; k < events.size(); ++k) {
    const bool is_end = k + 1 == events.size();
    const auto next = is_end ? end_event(1) : std::optional<Event>(events[k]);
    const int below = border.zeros[across][0].signs[gap[0]];
    const int above = border.zeros[across][1].signs[gap[1]];
    if (below != above) { // the graph runs inside
      if (!last || !next || (last->side >= 0 && last->side == next->side)) return false;
      graph_.connect(last->vertex, next->vertex);
    }
    if (!is_end) ++gap[static_cast<std::size_t>(next->side)];
    last = next;
  }
  return true;
}

} // namespace corral::geometry
