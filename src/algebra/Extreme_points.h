// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_ALGEBRA_EXTREME_POINTS_H
#define CORRAL_SRC_ALGEBRA_EXTREME_POINTS_H

#include "Plane_system.h"

#include <corral/algebra/Triangular_zero.h>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace corral::exact {

/// \brief Finds the pieces of a surface g = 0, or of a curve f = g = 0 in space, that lie strictly inside a box, for
/// irreducible polynomials.
///
/// Such a piece is compact and has a point where x + t y is largest. By McCallum's theorem on delineability that point
/// lies over a common zero of F and of its derivative along x + t y = const, where F(x, y) is the square-free product
/// of the discriminants, resultants and coefficients with respect to z: finitely many points of the plane, over each of
/// which a polynomial in z decides. Proof: doc/exact.md, section 5.
class Extreme_points
{
public:
  /// \param system  one irreducible polynomial, or two different ones.
  /// \param checkpoint  called now and then; it stops the work by throwing.
  Extreme_points(std::vector<Polynomial<Integer, 3>> system, Checkpoint checkpoint);

  /// \brief Whether bounds on small boxes show that no piece lies strictly inside.
  /// \pre No zero lies on the boundary of the box.
  [[nodiscard]] bool excluded(const Rational_box<3>& box);

  /// Whether the degree of F is low enough for `zero_in`.
  [[nodiscard]] bool is_feasible() const { return feasible_; }

  /// \brief A zero strictly inside, proved by a chain; nothing if there is none.
  /// \pre No zero lies on the boundary of the box; `is_feasible()`. \throw whatever the checkpoint throws;
  /// Budget_exceeded.
  [[nodiscard]] std::optional<Triangular_zero<3>> zero_in(const Rational_box<3>& box);

private:
  using Forms = std::vector<Polynomial<Integer, 3>>;

  /// Polynomials that vanish where x_d + t x_e is largest on a piece, those of the system among them.
  [[nodiscard]] Forms conditions(const std::array<long, 3>& direction) const;
  [[nodiscard]] std::vector<Rational_box<3>> boxes_with_zero(const Forms& forms, const Rational_box<3>& box,
                                                             unsigned max_depth, std::size_t max_live) const;
  void eliminate();

  Forms system_; ///< with the variable that is eliminated last
  Checkpoint checkpoint_;
  std::array<std::size_t, 3> order_{}; ///< the user's axis of each variable
  bool cylinder_ = false;              ///< a product of lines along an axis, which cross the boundary
  bool feasible_ = true;
  std::array<Forms, 3> along_axis_; ///< the conditions in the directions of the axes
  Forms along_t_;                   ///< and in that of x + t y
  std::unique_ptr<Plane_system> below_;
};

/// \brief The same for any square-free polynomial, or two coprime ones: each combination of irreducible factors by
/// itself.
class Inner_pieces
{
public:
  Inner_pieces(const std::vector<Polynomial<Integer, 3>>& system, const Checkpoint& checkpoint);

  [[nodiscard]] bool excluded(const Rational_box<3>& box);
  [[nodiscard]] bool is_feasible() const;
  [[nodiscard]] std::optional<Triangular_zero<3>> zero_in(const Rational_box<3>& box);

private:
  std::vector<Extreme_points> parts_;
};

} // namespace corral::exact

#endif
