// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/output/curve_meshes.h>

#include "Curve_frame.h"

#include <array>
#include <cmath>
#include <numbers>

namespace corral {

namespace {

// Dark enough for thin lines on white, and apart for the colour-blind (after Okabe and Ito).
constexpr std::array<Colour, 6> curve_colours{
    {{0, 0, 0}, {0, 0.447, 0.698}, {0.835, 0.369, 0}, {0, 0.55, 0.4}, {0.7, 0.35, 0.55}, {0.55, 0.45, 0}}};
constexpr Colour doubt_colour{0.98, 0.75, 0.3};

// From the plane to pixels.
class View
{
public:
  explicit View(const Curve_frame& frame) : frame_(frame) {}

  [[nodiscard]] std::array<double, 2> operator()(const Rational& x, const Rational& y) const
  {
    return {frame_.left + fraction(x, 0) * frame_.frame[0], frame_.top + (1 - fraction(y, 1)) * frame_.frame[1]};
  }

private:
  [[nodiscard]] double fraction(const Rational& x, std::size_t axis) const
  {
    const auto& side = frame_.box[axis];
    return Rational((x - side.lower()) / (side.upper() - side.lower())).get_d();
  }

  const Curve_frame& frame_;
};

void draw_doubts(const Canvas& canvas, const View& view, const Curve_mesh& mesh)
{
  canvas.set(doubt_colour);
  for (const auto& region : mesh.uncertified) {
    const auto low = view(region.box[0].lower(), region.box[1].lower());
    const auto high = view(region.box[0].upper(), region.box[1].upper());
    cairo_rectangle(canvas.context(), low[0] - 1, high[1] - 1, high[0] - low[0] + 2, low[1] - high[1] + 2);
  }
  cairo_fill(canvas.context());
}

void draw_lines(const Canvas& canvas, const View& view, const Curve_mesh& mesh)
{
  cairo_t* const context = canvas.context();
  for (const auto& line : polylines(mesh)) {
    if (line.size() == 1) continue;
    cairo_new_sub_path(context);
    for (const std::size_t v : line) {
      const auto [x, y] = view(mesh.vertices[v].point[0], mesh.vertices[v].point[1]);
      cairo_line_to(context, x, y);
    }
    if (line.front() == line.back()) cairo_close_path(context);
  }
  cairo_stroke(context);
}

void draw_points(const Canvas& canvas, const View& view, const Curve_mesh& mesh, double radius, const Colour& colour)
{
  cairo_t* const context = canvas.context();
  for (const auto& vertex : mesh.vertices) {
    if (!vertex.is_singular && vertex.branches > 0) continue;
    const auto [x, y] = view(vertex.point[0], vertex.point[1]);
    cairo_arc(context, x, y, radius, 0, 2 * std::numbers::pi);
    if (vertex.branches == 0) {
      canvas.set(colour);
      cairo_fill(context);
      continue;
    }
    canvas.set({1, 1, 1});
    cairo_fill_preserve(context);
    canvas.set(colour);
    cairo_stroke(context);
  }
}

constexpr double row = 1.4; // of the legend, in heights of the font

/// The beginning of a name that is no wider than `width`.
std::string shortened(const Canvas& canvas, std::string name, double width)
{
  if (canvas.width(name) <= width) return name;
  const auto is_inside_letter = [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) == 0x80U; };
  while (!name.empty() && canvas.width(name + "...") > width) {
    while (is_inside_letter(name.back())) name.pop_back();
    name.pop_back();
  }
  return name + "...";
}

/// A legend above the frame, a row for each curve.
void draw_names(const Canvas& canvas, const Curve_frame& frame, const std::vector<Named_mesh>& meshes)
{
  const double mark = 1.2 * frame.font;
  const double space = 0.4 * frame.font;
  double y = frame.top - (0.9 + row * static_cast<double>(meshes.size() - 1)) * frame.font;
  for (std::size_t k = 0; k < meshes.size(); ++k, y += row * frame.font) {
    canvas.set(curve_colours[k % curve_colours.size()]);
    cairo_move_to(canvas.context(), frame.left, y);
    cairo_line_to(canvas.context(), frame.left + mark, y);
    cairo_stroke(canvas.context());
    canvas.set({0, 0, 0});
    canvas.text(shortened(canvas, meshes[k].name, frame.frame[0] - mark - space), frame.left + mark + space, y, 0, 0.5);
  }
}

void draw_meshes(std::ostream& out, Canvas::Kind kind, const std::vector<Named_mesh>& meshes,
                 const Output_options& options)
{
  require_drawable(options);
  Curve_frame frame(meshes.front().mesh.box, {1, 1}, options.size);
  frame.top += std::ceil(row * static_cast<double>(meshes.size() - 1) * frame.font);
  const View view(frame);
  Canvas canvas(out, kind, frame.width(), frame.height());
  cairo_t* const context = canvas.context();
  cairo_set_font_size(context, frame.font);
  cairo_save(context);
  cairo_rectangle(context, frame.left - 1, frame.top - 1, frame.frame[0] + 2, frame.frame[1] + 2);
  cairo_clip(context);
  for (const auto& named : meshes) draw_doubts(canvas, view, named.mesh);
  cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_width(context, frame.font / 13);
  for (std::size_t k = 0; k < meshes.size(); ++k) {
    canvas.set(curve_colours[k % curve_colours.size()]);
    draw_lines(canvas, view, meshes[k].mesh);
  }
  for (std::size_t k = 0; k < meshes.size(); ++k)
    draw_points(canvas, view, meshes[k].mesh, frame.font / 6, curve_colours[k % curve_colours.size()]);
  cairo_restore(context);
  cairo_set_line_width(context, frame.font / 13);
  if (meshes.size() > 1) draw_names(canvas, frame, meshes);
  frame.draw(canvas, options);
  canvas.finish();
}

} // namespace

void draw_meshes_png(std::ostream& out, const std::vector<Named_mesh>& meshes, const Output_options& options)
{
  draw_meshes(out, Canvas::Kind::png, meshes, options);
}

void draw_meshes_svg(std::ostream& out, const std::vector<Named_mesh>& meshes, const Output_options& options)
{
  draw_meshes(out, Canvas::Kind::svg, meshes, options);
}

} // namespace corral
