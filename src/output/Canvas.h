// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_OUTPUT_CANVAS_H
#define CORRAL_OUTPUT_CANVAS_H

#include <corral/number/Rational_interval.h>
#include <corral/output/Output_options.h>

#include <cairo.h>

#include <cstdint>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

namespace corral {

struct Colour
{
  double red, green, blue;
};

/// \brief A Cairo drawing that ends up as PNG or SVG in a stream.
class Canvas
{
public:
  enum class Kind : std::uint8_t { png, svg };

  /// A white sheet. The stream must outlive the canvas.
  Canvas(std::ostream& out, Kind kind, int width, int height);

  [[nodiscard]] cairo_t* context() const { return context_.get(); }
  void set(const Colour& colour) const { cairo_set_source_rgb(context(), colour.red, colour.green, colour.blue); }

  /// How far `text` would advance.
  [[nodiscard]] double width(const std::string& what) const;
  /// Text whose anchor (0 left or top, 1 right or bottom) lies at the given point; returns its width.
  double text(const std::string& what, double x, double y, double anchor_x, double anchor_y) const;

  /// \brief Runs `draw` on a transparent sheet with twice the pixels and lays the result, smoothed, over this one. For
  /// shapes that must meet without seams and still have smooth outlines. Not for huge sheets, where it draws directly.
  template <class Draw>
  void draw_finer(const Draw& draw)
  {
    begin_finer();
    draw();
    end_finer();
  }

  /// Writes the drawing; a failure of the stream shows in its state. \throw Output_error if Cairo fails.
  void finish();

private:
  using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
  using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

  void begin_finer();
  void end_finer();

  std::ostream& out_;
  Kind kind_;
  Surface surface_;
  Context context_;
  Context coarse_{nullptr, cairo_destroy}; // the real sheet's while a finer one is drawn on
};

/// A mark on an axis; `fraction` is 0 at the lower end and 1 at the upper.
struct Tick
{
  double fraction;
  std::string label;
};

/// Round numbers of the interval, about `wanted` of them; the two ends if doubles cannot tell numbers apart there.
[[nodiscard]] std::vector<Tick> ticks(const Rational_interval& side, int wanted);

/// The sides of the box in true proportion, the longest 1 and none below 1/4 so that all can be seen.
template <std::size_t D>
[[nodiscard]] std::array<double, D> proportions(const std::array<Rational_interval, D>& box)
{
  std::array<Rational, D> width;
  for (std::size_t axis = 0; axis < D; ++axis) width[axis] = box[axis].upper() - box[axis].lower();
  const Rational longest = *std::max_element(width.begin(), width.end());
  std::array<double, D> result;
  for (std::size_t axis = 0; axis < D; ++axis) result[axis] = std::max(0.25, Rational(width[axis] / longest).get_d());
  return result;
}

/// \throw Invalid_input if the size is not one that can be drawn.
void require_drawable(const Output_options& options);

/// A line such as "[] hit 478  [] unknown 44", from (x, y) to the right, with samples of the two colours.
void draw_legend(const Canvas& canvas, double x, double y, double font, std::uint64_t hit, const Colour& hit_colour,
                 std::uint64_t unknown, const Colour& unknown_colour);

} // namespace corral

#endif
