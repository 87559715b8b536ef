// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/output/pictures.h>

#include "Canvas.h"
#include "Coarse_view.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace corral {

namespace {

using Vector = std::array<double, 3>;
struct Spot
{
  double x, y;
};

constexpr Colour hit_colour{0.75, 0.83, 0.92};
constexpr Colour unknown_colour{0.80, 0.33, 0.05};
constexpr Colour plain_colour{0.82, 0.82, 0.80};

double dot(const Vector& a, const Vector& b) { return std::inner_product(a.begin(), a.end(), b.begin(), 0.0); }

// A parallel projection of the box [0, proportion] onto the sheet. The eye is to the right, in front and above, so that
// the faces towards +x, -y and +z are seen.
class Projection
{
public:
  Projection(const Vector& proportion, double size, double font) : proportion_(proportion)
  {
    constexpr Vector right{2.4, 1.3, 0};
    constexpr Vector up{-2.6, 4.8, 7.45}; // eye x right, for an eye in the direction (1.3, -2.4, 2)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      right_[axis] = right[axis] / std::sqrt(dot(right, right));
      up_[axis] = up[axis] / std::sqrt(dot(up, up));
    }
    const double width = dot(right_, proportion);
    const double low = std::min({0.0, up_[0] * proportion[0]});
    const double height = dot(up_, proportion) - 2 * low;
    scale_ = std::min((size - 8 * font) / width, (size - 8 * font) / height);
    origin_ = {4.6 * font, 2.6 * font + scale_ * (dot(up_, proportion) - low)};
    sheet_ = {8 * font + scale_ * width, 6.6 * font + scale_ * height};
  }

  [[nodiscard]] int width() const { return static_cast<int>(std::ceil(sheet_.x)); }
  [[nodiscard]] int height() const { return static_cast<int>(std::ceil(sheet_.y)); }

  // The spot of a point given in fractions of the box.
  [[nodiscard]] Spot operator()(Vector at) const
  {
    for (std::size_t axis = 0; axis < 3; ++axis) at[axis] *= proportion_[axis];
    return {origin_.x + scale_ * dot(right_, at), origin_.y - scale_ * dot(up_, at)};
  }

  // Pixels of one unit of the box along an axis.
  [[nodiscard]] double length(std::size_t axis) const
  {
    return scale_ * proportion_[axis] * std::hypot(right_[axis], up_[axis]);
  }

private:
  Vector proportion_;
  Vector right_{};
  Vector up_{};
  double scale_ = 1;
  Spot origin_{};
  Spot sheet_{};
};

// Begins a new path through these points.
void path(cairo_t* context, const Projection& project, const std::vector<Vector>& points)
{
  cairo_new_path(context);
  for (const Vector& point : points) {
    const Spot spot = project(point);
    cairo_line_to(context, spot.x, spot.y);
  }
}

// The three walls behind the voxels, with a grid of lines at the ticks.
void draw_walls(const Canvas& canvas, const Projection& project, const std::array<std::vector<Tick>, 3>& marks)
{
  cairo_t* const context = canvas.context();
  constexpr Vector behind{0, 1, 0}; // where the wall of each axis stands
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t second = (axis + 1) % 3;
    const std::size_t third = (axis + 2) % 3;
    Vector corner{};
    corner[axis] = behind[axis];
    std::vector<Vector> wall(4, corner);
    wall[1][second] = wall[2][second] = wall[2][third] = wall[3][third] = 1;
    const double grey = axis == 2 ? 0.93 : axis == 1 ? 0.965 : 0.95;
    path(context, project, wall);
    cairo_close_path(context);
    canvas.set({grey, grey, grey});
    cairo_fill_preserve(context);
    canvas.set({0.55, 0.55, 0.55});
    cairo_set_line_width(context, 1);
    cairo_stroke(context);
    canvas.set({0.8, 0.8, 0.8});
    cairo_set_line_width(context, 0.7);
    for (const std::size_t along : {second, third})
      for (const Tick& tick : marks[along]) {
        std::vector<Vector> line(2, corner);
        line[0][along] = line[1][along] = tick.fraction;
        line[1][second + third - along] = 1;
        path(context, project, line);
        cairo_stroke(context);
      }
  }
}

// Ticks and names along the three outer edges that no voxel can hide.
void draw_axes(const Canvas& canvas, const Projection& project, const std::array<std::vector<Tick>, 3>& marks,
               const Output_options& options, double font)
{
  struct Edge
  {
    Vector start;  // its lower end
    Spot outwards; // direction of the tick marks on the sheet
    double anchor_x, anchor_y;
  };
  static constexpr Edge edges[] = {
      {{0, 0, 0}, {-0.3, 1}, 0.6, 0}, {{1, 0, 0}, {1, 0.35}, 0, 0.2}, {{0, 0, 0}, {-1, 0}, 1, 0.5}};
  cairo_t* const context = canvas.context();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Edge& edge = edges[axis];
    Vector at = edge.start;
    canvas.set({0, 0, 0});
    cairo_set_line_width(context, 1.2);
    Vector end = at;
    end[axis] = 1;
    path(context, project, {at, end});
    cairo_stroke(context);
    cairo_select_font_face(context, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(context, font);
    const double mark = 0.4 * font;
    for (const Tick& tick : marks[axis]) {
      at[axis] = tick.fraction;
      const Spot spot = project(at);
      cairo_move_to(context, spot.x, spot.y);
      cairo_line_to(context, spot.x + edge.outwards.x * mark, spot.y + edge.outwards.y * mark);
      cairo_stroke(context);
      canvas.text(tick.label, spot.x + 1.8 * edge.outwards.x * mark, spot.y + 1.8 * edge.outwards.y * mark,
                  edge.anchor_x, edge.anchor_y);
    }
    at[axis] = 0.5;
    const Spot middle = project(at);
    cairo_select_font_face(context, "serif", CAIRO_FONT_SLANT_ITALIC, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(context, 1.2 * font);
    canvas.text(axis_name(options, axis), middle.x + 3 * edge.outwards.x * font,
                middle.y + 2.4 * edge.outwards.y * font, edge.anchor_x, edge.anchor_y);
  }
}

// Draws the visible faces of voxels, the farthest voxels first.
class Voxel_painter
{
public:
  Voxel_painter(const Canvas& canvas, const Projection& project, const Raster<3>& view, bool alike)
      : canvas_(canvas), project_(project), view_(view), alike_(alike)
  {
    double smallest = project.length(0) / view.grid().resolution()[0];
    for (std::size_t axis = 1; axis < 3; ++axis)
      smallest = std::min(smallest, project.length(axis) / view.grid().resolution()[axis]);
    line_width_ = smallest < 5 ? 0 : std::min(1.0, smallest / 16);
  }

  void draw() const
  {
    std::vector<std::pair<Cell<3>, Verdict>> order;
    for (const auto& [cell, verdict] : view_) order.emplace_back(cell, verdict);
    // Far to near along every axis: any such order is a painter's order for cubes of one grid.
    std::sort(order.begin(), order.end(), [](const auto& a, const auto& b) {
      if (a.first[1] != b.first[1]) return a.first[1] > b.first[1];
      if (a.first[0] != b.first[0]) return a.first[0] < b.first[0];
      return a.first[2] < b.first[2];
    });
    cairo_set_line_join(canvas_.context(), CAIRO_LINE_JOIN_ROUND);
    for (const auto& [cell, verdict] : order)
      for (std::size_t axis = 0; axis < 3; ++axis) draw_face(cell, verdict, axis);
  }

private:
  static constexpr std::array<bool, 3> sees_upper{true, false, true};
  static constexpr Vector brightness{0.62, 0.82, 1};

  void draw_face(const Cell<3>& cell, Verdict verdict, std::size_t axis) const
  {
    const bool outermost = sees_upper[axis] ? cell[axis] + 1 == view_.grid().resolution()[axis] : cell[axis] == 0;
    Cell<3> neighbour = cell;
    neighbour[axis] += sees_upper[axis] ? 1U : ~0U;
    if (!outermost && view_.verdict(neighbour) != Verdict::empty) return;

    const std::size_t second = (axis + 1) % 3;
    const std::size_t third = (axis + 2) % 3;
    Vector low;
    Vector high;
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = double(cell[k]) / view_.grid().resolution()[k];
      high[k] = double(cell[k] + 1) / view_.grid().resolution()[k];
    }
    Vector corner = low;
    if (sees_upper[axis]) corner[axis] = high[axis];
    std::vector<Vector> square(4, corner);
    square[1][second] = square[2][second] = high[second];
    square[2][third] = square[3][third] = high[third];
    paint(square, shade(alike_                    ? plain_colour
                        : verdict == Verdict::hit ? hit_colour
                                                  : unknown_colour,
                        brightness[axis]));
  }

  void paint(const std::vector<Vector>& square, const Colour& colour) const
  {
    cairo_t* const context = canvas_.context();
    path(context, project_, square);
    cairo_close_path(context);
    canvas_.set(colour);
    cairo_set_antialias(context, CAIRO_ANTIALIAS_NONE); // no seams between neighbours
    if (line_width_ == 0) {
      cairo_fill(context);
      return;
    }
    cairo_fill_preserve(context);
    cairo_set_antialias(context, CAIRO_ANTIALIAS_DEFAULT);
    canvas_.set(shade(colour, 0.45));
    cairo_set_line_width(context, line_width_);
    cairo_stroke(context);
  }

  static Colour shade(const Colour& colour, double factor)
  {
    return {factor * colour.red, factor * colour.green, factor * colour.blue};
  }

  const Canvas& canvas_;
  const Projection& project_;
  const Raster<3>& view_;
  bool alike_;
  double line_width_ = 0;
};

} // namespace

void draw_voxels_png(std::ostream& out, const Raster<3>& raster, const Output_options& options)
{
  require_drawable(options);
  const double font = options.size / 42.0;
  const Projection project(proportions(raster.grid().box()), options.size, font);
  const std::uint32_t finest = std::max(32U, options.size / 2);
  const Raster<3> view = coarsen(raster, {finest, finest, finest});
  std::array<std::vector<Tick>, 3> marks;
  for (std::size_t axis = 0; axis < 3; ++axis) marks[axis] = ticks(raster.grid().box()[axis], 4);

  Canvas canvas(out, Canvas::Kind::png, project.width(), project.height());
  draw_walls(canvas, project, marks);
  const bool alike = options.colouring == Colouring::plotted;
  canvas.draw_finer([&] { Voxel_painter(canvas, project, view, alike).draw(); });
  draw_axes(canvas, project, marks, options, font);
  cairo_select_font_face(canvas.context(), "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(canvas.context(), font);
  if (!alike)
    draw_legend(canvas, 0.8 * font, 1.2 * font, font, raster.hit(), hit_colour, raster.unknown(), unknown_colour);
  canvas.finish();
}

} // namespace corral
