// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_GEOMETRY_SINGULAR_POINTS_H
#define CORRAL_SRC_GEOMETRY_SINGULAR_POINTS_H

#include "Cell_form.h"

#include "../algebra/Projected_zeros.h"

#include <corral/internal/algebra/Checkpoint.h>

#include <optional>
#include <vector>

namespace corral::geometry {

/// \brief The singular points of a square-free curve f = 0 in a box, exactly, found when they are first needed.
class Singular_points
{
public:
  struct Point
  {
    Rational_box<2> box;                       ///< in the coordinates of the caller
    std::array<Range, 2> unit_box;             ///< in those of the unit box
    std::optional<exact::Projected_zero> zero; ///< none if it was guessed and not met since
    unsigned order = 0;                        ///< see `order_along`

    [[nodiscard]] bool is_rational() const { return box[0].lower() == box[0].upper(); }
  };

  Singular_points(Polynomial<Integer, 2> f, Rational_box<2> box, Checkpoint checkpoint);

  [[nodiscard]] const std::vector<Point>& points() const { return points_; }
  /// Whether `points` are all.
  [[nodiscard]] bool is_complete() const { return complete_; }

  /// Looks for one with small denominators in a part of the unit box.
  bool guess(const std::array<Range, 2>& part);
  /// Finds all. \throw whatever the checkpoint throws.
  void complete();
  /// The direction that tells all singular points apart: the lines x + shear() * y = const. \pre is_complete().
  [[nodiscard]] long shear() const { return shear_; }
  /// \brief Whether no point of a part of the unit box but, if given, one singular point can be critical: a zero of f
  /// and of its derivative along the lines of `shear()`. \pre is_complete().
  [[nodiscard]] bool is_regular(const std::array<Range, 2>& part, std::optional<std::size_t> but);
  /// The multiplicity of a singular point on the line of `shear()` through it. \pre is_complete().
  [[nodiscard]] unsigned order_along(std::size_t point);

  /// The indices of those known that may lie in a part of the unit box. \throw Not_generic if one lies on a line that
  /// cuts the box.
  [[nodiscard]] std::vector<std::size_t> in(const std::array<Range, 2>& part);

private:
  void refine(Point& point) const;
  void isolate_critical_values();
  [[nodiscard]] bool is_known(const Rational_point<2>& point) const;
  [[nodiscard]] std::array<Range, 2> to_unit(const Rational_box<2>& box) const;
  [[nodiscard]] Rational_interval from_unit(const Range& range, std::size_t axis) const;

  Polynomial<Integer, 2> f_;
  Rational_box<2> box_;
  Checkpoint checkpoint_;
  std::vector<Point> points_;
  bool complete_ = false;
  long shear_ = 0;
  std::vector<std::shared_ptr<const Integer_polynomial>> critical_polynomials_;
  std::optional<std::vector<Real_root>> critical_values_; ///< of x + shear * y over the box
};

} // namespace corral::geometry

#endif
