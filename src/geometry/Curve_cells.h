// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_GEOMETRY_CURVE_CELLS_H
#define CORRAL_SRC_GEOMETRY_CURVE_CELLS_H

#include "Plane_graph.h"
#include "Singular_points.h"

#include <corral/Run_options.h>

#include <optional>
#include <string>
#include <vector>

namespace corral::geometry {

/// A rectangle of the unit box and the polynomial on it.
struct Cell
{
  Cell_form form;
  std::array<Range, 2> box;

  [[nodiscard]] double length(std::size_t axis) const { return box[axis].high - box[axis].low; }
  [[nodiscard]] Segment side(std::size_t normal, bool upper) const
  {
    return {normal, upper ? box[normal].high : box[normal].low, box[1 - normal].low, box[1 - normal].high};
  }
};

struct Direction;

/// The derivatives of a polynomial along both axes and along the direction that tells all singular points apart, up to
/// positive factors.
struct Slopes
{
  std::array<Polynomial<Integer, 2>, 2> along_axis;
  Polynomial<Integer, 2> along_direction;
};

/// The zeros on the four sides of a cell, as vertices of the graph.
struct Border
{
  std::array<std::array<Side_zeros, 2>, 2> zeros;                  ///< [normal axis][lower or upper], without corners
  std::array<std::array<std::vector<std::size_t>, 2>, 2> inside;   ///< the vertices of these
  std::array<std::array<std::optional<std::size_t>, 2>, 2> corner; ///< [upper x][upper y]
  bool is_clear = true;                                            ///< no two zeros share a double

  [[nodiscard]] Outline outline() const;
};

/// What the graph should be like.
struct Curve_settings
{
  std::array<double, 2> size{1, 1}; ///< of the box, rounded up
  double tolerance = 1;             ///< rounded down
  Rational aspect = 1;              ///< height over width of the box
  Run_options run{};                ///< `cell_budget` is 2^21 by default
};

/// \brief The zero set of a square-free polynomial in the unit box as a graph, cell by cell.
///
/// The cells are cut until each is empty, a graph over one axis, or holds one singular point from which all its
/// branches run to the border. Proof: doc/geometry.md.
class Curve_cells
{
public:
  /// A part of the box of which nothing is claimed.
  struct Doubt
  {
    std::array<Range, 2> box;
    std::string reason;
  };

  /// \param f  on the unit box, without the lines that its sides lie on.
  Curve_cells(const Polynomial<Integer, 2>& f, Singular_points& singular, const Curve_settings& settings);

  /// Cuts the box first at `first_cuts`, which should be like no coordinate of the curve. \throw Not_generic if they
  /// are.
  void run(const std::array<double, 2>& first_cuts);

  [[nodiscard]] const Plane_graph& graph() const { return graph_; }
  [[nodiscard]] Plane_graph take_graph() { return std::move(graph_); }
  [[nodiscard]] const std::vector<Doubt>& doubts() const { return doubts_; }
  [[nodiscard]] std::size_t cells() const { return cells_; }
  [[nodiscard]] const Outline& outline() const { return outline_; }

private:
  enum class Shape { unclear, coarse, done }; ///< coarse: understood, but larger than the tolerance wants

  [[nodiscard]] Outline trace(Cell cell);
  [[nodiscard]] Outline cut(Cell cell, Shape shape);
  [[nodiscard]] Outline give_up(const Cell& cell, const std::string& reason);
  [[nodiscard]] Shape resolve(Cell& cell, Outline& outline);
  [[nodiscard]] Shape resolve_graph(const Cell& cell, std::size_t axis, Outline& outline);
  [[nodiscard]] Shape resolve_slanted(const Cell& cell, const std::array<double, 2>& v, Outline& outline);
  [[nodiscard]] Shape resolve_singular(const Cell& cell, Outline& outline);
  [[nodiscard]] Shape resolve_star(const Cell& cell, std::size_t point, Outline& outline);
  [[nodiscard]] Shape resolve_stack(const Cell& cell, Outline& outline);
  [[nodiscard]] bool finish_star(const Cell& cell, std::size_t point, const Direction& direction, const Slopes* slopes,
                                 Outline& outline);
  [[nodiscard]] Direction critical_direction(const Cell& cell) const;
  [[nodiscard]] const Slopes& slopes();
  [[nodiscard]] bool connect_graph(const Border& border, std::size_t axis);
  [[nodiscard]] bool connect_slanted(const Border& border, const Cell& cell, const std::array<double, 2>& v,
                                     double span);
  [[nodiscard]] Border border(const Cell& cell, double precision);
  [[nodiscard]] Border clear_border(const Cell& cell, double precision);
  [[nodiscard]] bool is_surely_bent(const Cell& cell, std::size_t axis) const;
  [[nodiscard]] bool is_flat(const Cell& cell, std::size_t axis) const;
  [[nodiscard]] double flat_span(const Cell& cell, const std::array<double, 2>& v) const;
  [[nodiscard]] bool is_small(const Cell& cell) const;

  const Polynomial<Integer, 2>& f_;
  Singular_points& singular_;
  Curve_settings settings_;
  std::array<double, 2> first_cuts_{};
  std::optional<Slopes> slopes_;
  Plane_graph graph_;
  Outline outline_;
  std::vector<Doubt> doubts_;
  std::size_t cells_ = 0;
};

} // namespace corral::geometry

#endif
