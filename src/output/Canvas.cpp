// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Canvas.h"

#include <corral/errors.h>

#include <cairo-svg.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace corral {

namespace {

cairo_status_t write_to_stream(void* closure, const unsigned char* data, unsigned length)
{
  auto& out = *static_cast<std::ostream*>(closure);
  // Cairo is C: no exception may pass through it.
  try {
    out.write(reinterpret_cast<const char*>(data), length);
  } catch (...) {
    return CAIRO_STATUS_WRITE_ERROR;
  }
  return out ? CAIRO_STATUS_SUCCESS : CAIRO_STATUS_WRITE_ERROR;
}

cairo_surface_t* make_surface(std::ostream& out, Canvas::Kind kind, int width, int height)
{
  return kind == Canvas::Kind::svg ? cairo_svg_surface_create_for_stream(write_to_stream, &out, width, height)
                                   : cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
}

void require_success(cairo_status_t status)
{
  if (status != CAIRO_STATUS_SUCCESS)
    throw Output_error(std::string("output: drawing failed: ") + cairo_status_to_string(status));
}

std::string format(double value, int digits)
{
  char text[64];
  std::snprintf(text, sizeof text, "%.*g", digits, value == 0 ? 0.0 : value); // no minus zero
  return text;
}

std::string shortened(const Rational& value)
{
  const std::string exact = to_string(value);
  if (exact.size() <= 14) return exact;
  const double nearest = value.get_d();
  return std::isfinite(nearest) ? format(nearest, 8) : exact.substr(0, 10) + "...";
}

} // namespace

Canvas::Canvas(std::ostream& out, Kind kind, int width, int height)
    : out_(out), kind_(kind), surface_(make_surface(out, kind, width, height), cairo_surface_destroy),
      context_(cairo_create(surface_.get()), cairo_destroy)
{
  require_success(cairo_surface_status(surface_.get()));
  set({1, 1, 1});
  cairo_paint(context());
  cairo_select_font_face(context(), "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
}

double Canvas::width(const std::string& what) const
{
  cairo_text_extents_t size;
  cairo_text_extents(context(), what.c_str(), &size);
  return size.x_advance;
}

double Canvas::text(const std::string& what, double x, double y, double anchor_x, double anchor_y) const
{
  cairo_font_extents_t font;
  cairo_text_extents_t size;
  cairo_font_extents(context(), &font);
  cairo_text_extents(context(), what.c_str(), &size);
  // The height of a digit and not of the letters at hand, so that labels of one row share a base line.
  const double height = 0.72 * (font.ascent / (font.ascent + font.descent)) * font.height;
  cairo_move_to(context(), x - anchor_x * size.x_advance, y + (1 - anchor_y) * height);
  cairo_show_text(context(), what.c_str());
  return size.x_advance;
}

void Canvas::begin_finer()
{
  constexpr int finer = 2;
  const int width = finer * cairo_image_surface_get_width(surface_.get());
  const int height = finer * cairo_image_surface_get_height(surface_.get());
  if (std::max(width, height) > 10000) return;
  const Surface sheet(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height), cairo_surface_destroy);
  require_success(cairo_surface_status(sheet.get()));
  coarse_ = std::move(context_);
  context_.reset(cairo_create(sheet.get())); // which keeps the sheet alive
  cairo_scale(context(), finer, finer);
}

void Canvas::end_finer()
{
  if (!coarse_) return;
  require_success(cairo_status(context()));
  const Context fine = std::exchange(context_, std::move(coarse_));
  cairo_save(context());
  cairo_matrix_t matrix;
  cairo_get_matrix(fine.get(), &matrix);
  cairo_scale(context(), 1 / matrix.xx, 1 / matrix.yy);
  cairo_set_source_surface(context(), cairo_get_target(fine.get()), 0, 0);
  cairo_pattern_set_filter(cairo_get_source(context()), CAIRO_FILTER_GOOD);
  cairo_paint(context());
  cairo_restore(context());
}

void Canvas::finish()
{
  require_success(cairo_status(context()));
  const cairo_status_t written = kind_ == Kind::png
                                     ? cairo_surface_write_to_png_stream(surface_.get(), write_to_stream, &out_)
                                     : CAIRO_STATUS_SUCCESS;
  cairo_surface_finish(surface_.get());
  if (!out_) return;
  require_success(written);
  require_success(cairo_surface_status(surface_.get()));
}

std::vector<Tick> ticks(const Rational_interval& side, int wanted)
{
  const double low = side.lower().get_d();
  const double width = Rational(side.upper() - side.lower()).get_d();
  const double largest = std::max(std::abs(low), std::abs(side.upper().get_d()));
  const std::vector<Tick> ends{{0, shortened(side.lower())}, {1, shortened(side.upper())}};
  if (!std::isnormal(width) || !std::isfinite(largest) || width < 1e-12 * largest) return ends;
  const double rough = width / wanted;
  const double magnitude = std::pow(10, std::floor(std::log10(rough)));
  if (!std::isnormal(magnitude)) return ends;
  const double leading = rough / magnitude;
  const double step = magnitude * (leading <= 1 ? 1 : leading <= 2 ? 2 : leading <= 5 ? 5 : 10);
  const int digits = std::max(6, static_cast<int>(std::floor(std::log10(largest)) - std::floor(std::log10(step))) + 1);
  std::vector<Tick> result;
  constexpr double slack = 1e-9; // of a step: an end that is itself a round number keeps its tick
  for (double k = std::ceil(low / step - slack); k * step <= low + width + slack * step; ++k)
    result.push_back({(k * step - low) / width, format(k * step, digits)});
  return result;
}

void require_drawable(const Output_options& options)
{
  if (options.size < 64 || options.size > 8192)
    throw Invalid_input("picture: the size is " + std::to_string(options.size) + "; expected 64 to 8192");
}

void draw_legend(const Canvas& canvas, double x, double y, double font, std::uint64_t hit, const Colour& hit_colour,
                 std::uint64_t unknown, const Colour& unknown_colour)
{
  const auto entry = [&](const std::string& label, std::uint64_t count, const Colour& colour) {
    if (count == 0) return;
    canvas.set(colour);
    cairo_rectangle(canvas.context(), x, y - 0.4 * font, 0.8 * font, 0.8 * font);
    cairo_fill(canvas.context());
    canvas.set({0, 0, 0});
    x += 1.2 * font;
    x += canvas.text(label + " " + std::to_string(count), x, y, 0, 0.5) + 1.5 * font;
  };
  entry("hit", hit, hit_colour);
  entry("unknown", unknown, unknown_colour);
  if (hit + unknown == 0) canvas.text("no cell plotted", x, y, 0, 0.5);
}

} // namespace corral
