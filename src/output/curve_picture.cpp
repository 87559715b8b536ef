// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/output/pictures.h>

#include "Canvas.h"
#include "Coarse_view.h"

#include <cmath>

namespace corral {

namespace {

constexpr Colour hit_colour{0, 0, 0};
constexpr Colour unknown_colour{0.835, 0.369, 0}; // half as bright as white also in grey

constexpr int wanted_ticks = 5;

int longest_label(const Rational_interval& side)
{
  int longest = 0;
  for (const Tick& tick : ticks(side, wanted_ticks)) longest = std::max(longest, static_cast<int>(tick.label.size()));
  return longest;
}

// Where things are, in pixels. The frame is a whole number of pixels a cell, so that all cells look alike.
struct Layout
{
  explicit Layout(const Grid<2>& grid, unsigned size)
      : font(size / 38.0), left(std::ceil((2.2 + 0.65 * longest_label(grid.box()[1])) * font)), top(std::ceil(2 * font))
  {
    const auto proportion = proportions(grid.box());
    const double room = std::max(size / 4.0, size - left - font);
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double wanted = std::floor(room * proportion[axis]);
      const double cells = grid.resolution()[axis];
      cell[axis] = cells <= wanted ? std::round(wanted / cells) : 1;
      drawn[axis] = static_cast<std::uint32_t>(std::min(cells, wanted));
      frame[axis] = cell[axis] * drawn[axis];
    }
  }
  [[nodiscard]] int width() const { return static_cast<int>(left + frame[0] + std::ceil(1.2 * font)); }
  [[nodiscard]] int height() const { return static_cast<int>(top + frame[1] + std::ceil(3.4 * font)); }

  double font, left, top;
  std::array<double, 2> cell{};  // pixels of a drawn cell
  Resolution<2> drawn{};         // number of drawn cells
  std::array<double, 2> frame{}; // pixels
};

// Cells with one verdict, as vertical runs: far fewer rectangles than cells.
void draw_cells(const Canvas& canvas, const Layout& layout, const Cell_set<2>& cells, Verdict wanted)
{
  cairo_t* const context = canvas.context();
  Cell<2> start{};
  std::uint32_t length = 0;
  const auto flush = [&] {
    if (length == 0) return;
    const double bottom = layout.top + layout.frame[1] - start[1] * layout.cell[1];
    const double height = length * layout.cell[1];
    cairo_rectangle(context, layout.left + start[0] * layout.cell[0], bottom - height, layout.cell[0], height);
    length = 0;
  };
  cells.for_each_sorted([&](const Cell<2>& cell, Verdict verdict) {
    if (verdict != wanted) return;
    if (length == 0 || cell[0] != start[0] || cell[1] != start[1] + length) {
      flush();
      start = cell;
    }
    ++length;
  });
  flush();
  cairo_set_antialias(context, CAIRO_ANTIALIAS_NONE);
  cairo_fill(context);
  cairo_set_antialias(context, CAIRO_ANTIALIAS_DEFAULT);
}

void draw_frame(const Canvas& canvas, const Layout& layout, const Grid<2>& grid, const Output_options& options)
{
  cairo_t* const context = canvas.context();
  const double right = layout.left + layout.frame[0];
  const double bottom = layout.top + layout.frame[1];
  const double mark = 0.45 * layout.font;
  canvas.set({0, 0, 0});
  cairo_set_line_width(context, 1);
  // Half pixels: a line of one pixel is then one pixel and not two grey ones.
  cairo_rectangle(context, layout.left - 0.5, layout.top - 0.5, layout.frame[0] + 1, layout.frame[1] + 1);
  for (const Tick& tick : ticks(grid.box()[0], wanted_ticks)) {
    const double x = std::floor(layout.left + tick.fraction * layout.frame[0]) + (tick.fraction >= 1 ? -0.5 : 0.5);
    cairo_move_to(context, x, bottom);
    cairo_line_to(context, x, bottom - mark);
    cairo_move_to(context, x, layout.top);
    cairo_line_to(context, x, layout.top + mark);
    canvas.text(tick.label, x, bottom + 0.5 * layout.font, 0.5, 0);
  }
  for (const Tick& tick : ticks(grid.box()[1], wanted_ticks)) {
    const double y = std::floor(bottom - tick.fraction * layout.frame[1]) + (tick.fraction >= 1 ? 0.5 : -0.5);
    cairo_move_to(context, layout.left, y);
    cairo_line_to(context, layout.left + mark, y);
    cairo_move_to(context, right, y);
    cairo_line_to(context, right - mark, y);
    canvas.text(tick.label, layout.left - 0.5 * layout.font, y, 1, 0.5);
  }
  cairo_stroke(context);
  cairo_select_font_face(context, "serif", CAIRO_FONT_SLANT_ITALIC, CAIRO_FONT_WEIGHT_NORMAL);
  canvas.text(axis_name(options, 0), (layout.left + right) / 2, bottom + 1.9 * layout.font, 0.5, 0);
  canvas.text(axis_name(options, 1), 0.5 * layout.font, (layout.top + bottom) / 2, 0, 0.5);
}

void draw_curve(std::ostream& out, Canvas::Kind kind, const Grid<2>& grid, const Cell_set<2>& cells,
                const Output_options& options)
{
  require_drawable(options);
  const Layout layout(grid, options.size);
  const Coarse_view<2> view = coarsen(grid, cells, layout.drawn);
  Canvas canvas(out, kind, layout.width(), layout.height());
  cairo_set_font_size(canvas.context(), layout.font);
  const bool alike = options.colouring == Colouring::plotted;
  canvas.set(alike ? hit_colour : unknown_colour);
  draw_cells(canvas, layout, view.cells, Verdict::unknown);
  canvas.set(hit_colour);
  draw_cells(canvas, layout, view.cells, Verdict::hit);
  if (!alike)
    draw_legend(canvas, layout.left, layout.top - 0.9 * layout.font, layout.font, cells.hit(), hit_colour,
                cells.unknown(), unknown_colour);
  draw_frame(canvas, layout, grid, options);
  canvas.finish();
}

} // namespace

void draw_curve_png(std::ostream& out, const Grid<2>& grid, const Cell_set<2>& cells, const Output_options& options)
{
  draw_curve(out, Canvas::Kind::png, grid, cells, options);
}

void draw_curve_svg(std::ostream& out, const Grid<2>& grid, const Cell_set<2>& cells, const Output_options& options)
{
  draw_curve(out, Canvas::Kind::svg, grid, cells, options);
}

} // namespace corral
