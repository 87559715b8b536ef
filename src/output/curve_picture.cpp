// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/output/pictures.h>

#include "Canvas.h"
#include "Coarse_view.h"
#include "Curve_frame.h"

#include <cmath>

namespace corral {

namespace {

constexpr Colour hit_colour{0, 0, 0};
constexpr Colour unknown_colour{0.835, 0.369, 0}; // half as bright as white also in grey

// Cells with one verdict, as vertical runs: far fewer rectangles than cells.
void draw_cells(const Canvas& canvas, const Curve_frame& layout, const Raster<2>& cells, Verdict wanted)
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

void draw_curve(std::ostream& out, Canvas::Kind kind, const Raster<2>& raster, const Output_options& options)
{
  require_drawable(options);
  const Curve_frame layout(raster.grid().box(), raster.grid().resolution(), options.size);
  const Raster<2> view = coarsen(raster, layout.drawn);
  Canvas canvas(out, kind, layout.width(), layout.height());
  cairo_set_font_size(canvas.context(), layout.font);
  const bool alike = options.colouring == Colouring::plotted;
  canvas.set(alike ? hit_colour : unknown_colour);
  draw_cells(canvas, layout, view, Verdict::unknown);
  canvas.set(hit_colour);
  draw_cells(canvas, layout, view, Verdict::hit);
  if (!alike)
    draw_legend(canvas, layout.left, layout.top - 0.9 * layout.font, layout.font, raster.hit(), hit_colour,
                raster.unknown(), unknown_colour);
  layout.draw(canvas, options);
  canvas.finish();
}

} // namespace

void draw_curve_png(std::ostream& out, const Raster<2>& raster, const Output_options& options)
{
  draw_curve(out, Canvas::Kind::png, raster, options);
}

void draw_curve_svg(std::ostream& out, const Raster<2>& raster, const Output_options& options)
{
  draw_curve(out, Canvas::Kind::svg, raster, options);
}

} // namespace corral
