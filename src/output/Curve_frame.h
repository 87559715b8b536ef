// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_OUTPUT_CURVE_FRAME_H
#define CORRAL_SRC_OUTPUT_CURVE_FRAME_H

#include "Canvas.h"

#include <corral/polynomial/Box.h>

#include <array>
#include <cstdint>

namespace corral {

/// \brief Where things are in a picture of the plane, in pixels, and the frame with ticks and axis names around them.
/// The frame is a whole number of pixels a cell, so that all cells look alike.
struct Curve_frame
{
  /// \param resolution  of the cells to draw; {1, 1} if there are none.
  Curve_frame(const Rational_box<2>& box, const std::array<std::uint32_t, 2>& resolution, unsigned size);

  [[nodiscard]] int width() const;
  [[nodiscard]] int height() const;
  void draw(const Canvas& canvas, const Output_options& options) const;

  Rational_box<2> box;
  double font, left, top;
  std::array<double, 2> cell{};         ///< pixels of a drawn cell
  std::array<std::uint32_t, 2> drawn{}; ///< number of drawn cells
  std::array<double, 2> frame{};        ///< pixels
};

} // namespace corral

#endif
