// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Curve_frame.h"

#include <algorithm>
#include <cmath>

namespace corral {

namespace {

constexpr int wanted_ticks = 5;

int longest_label(const Rational_interval& side)
{
  int longest = 0;
  for (const Tick& tick : ticks(side, wanted_ticks)) longest = std::max(longest, static_cast<int>(tick.label.size()));
  return longest;
}

} // namespace

Curve_frame::Curve_frame(const Rational_box<2>& plane, const std::array<std::uint32_t, 2>& resolution, unsigned size)
    : box(plane), font(size / 38.0), left(std::ceil((2.2 + 0.65 * longest_label(box[1])) * font)),
      top(std::ceil(2 * font))
{
  const auto proportion = proportions(box);
  const double room = std::max(size / 4.0, size - left - font);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double wanted = std::floor(room * proportion[axis]);
    const double cells = resolution[axis];
    cell[axis] = cells <= wanted ? std::round(wanted / cells) : 1;
    drawn[axis] = static_cast<std::uint32_t>(std::min(cells, wanted));
    frame[axis] = cell[axis] * drawn[axis];
  }
}

int Curve_frame::width() const { return static_cast<int>(left + frame[0] + std::ceil(1.2 * font)); }
int Curve_frame::height() const { return static_cast<int>(top + frame[1] + std::ceil(3.4 * font)); }

void Curve_frame::draw(const Canvas& canvas, const Output_options& options) const
{
  cairo_t* const context = canvas.context();
  const double right = left + frame[0];
  const double bottom = top + frame[1];
  const double mark = 0.45 * font;
  canvas.set({0, 0, 0});
  cairo_set_line_width(context, 1);
  // Half pixels: a line of one pixel is then one pixel and not two grey ones.
  cairo_rectangle(context, left - 0.5, top - 0.5, frame[0] + 1, frame[1] + 1);
  for (const Tick& tick : ticks(box[0], wanted_ticks)) {
    const double x = std::floor(left + tick.fraction * frame[0]) + (tick.fraction >= 1 ? -0.5 : 0.5);
    cairo_move_to(context, x, bottom);
    cairo_line_to(context, x, bottom - mark);
    cairo_move_to(context, x, top);
    cairo_line_to(context, x, top + mark);
    canvas.text(tick.label, x, bottom + 0.5 * font, 0.5, 0);
  }
  for (const Tick& tick : ticks(box[1], wanted_ticks)) {
    const double y = std::floor(bottom - tick.fraction * frame[1]) + (tick.fraction >= 1 ? 0.5 : -0.5);
    cairo_move_to(context, left, y);
    cairo_line_to(context, left + mark, y);
    cairo_move_to(context, right, y);
    cairo_line_to(context, right - mark, y);
    canvas.text(tick.label, left - 0.5 * font, y, 1, 0.5);
  }
  cairo_stroke(context);
  cairo_select_font_face(context, "serif", CAIRO_FONT_SLANT_ITALIC, CAIRO_FONT_WEIGHT_NORMAL);
  canvas.text(axis_name(options, 0), (left + right) / 2, bottom + 1.9 * font, 0.5, 0);
  canvas.text(axis_name(options, 1), 0.5 * font, (top + bottom) / 2, 0, 0.5);
}

} // namespace corral
