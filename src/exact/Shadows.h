// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_EXACT_SHADOWS_H
#define CORRAL_EXACT_SHADOWS_H

#include "Zero_set.h"

#include <array>
#include <memory>

namespace corral::exact {

/// \brief Excludes small closed surfaces and isolated points inside a box by their outlines.
///
/// A piece of the surface strictly inside a box has a point of largest x; there g = g_y = g_z = 0. So its projection
/// along z is a zero of the discriminant of g with respect to z, and its projection along y one of that with respect to
/// y. Where either has no zero in the box's projection (a question of the plane, decided exactly), the point is not in
/// the box.
class Shadows
{
public:
  /// \pre g is square-free. \throw whatever `checkpoint` throws.
  Shadows(const Polynomial<Integer, 3>& g, const Checkpoint& checkpoint);

  /// Whether no point of largest x of a piece that lies strictly inside a larger box, free of zeros on its
  /// boundary, lies in this one.
  [[nodiscard]] bool exclude(const Rational_box<3>& box);

private:
  bool nothing_inside_ = false;                       ///< g is a product of cylinders along the axes
  std::array<std::unique_ptr<Zero_set<2>>, 2> plane_; ///< discriminants by z and by y; empty if not available
  std::array<Polynomial<Integer, 2>, 2> outline_;
};

/// f on a box as a positive multiple of its Bernstein coefficients.
template <std::size_t D>
[[nodiscard]] Bernstein_form<D> bernstein_form(const Polynomial<Integer, D>& f, const Rational_box<D>& box);

} // namespace corral::exact

#endif
