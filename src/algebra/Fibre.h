// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_ALGEBRA_FIBRE_H
#define CORRAL_SRC_ALGEBRA_FIBRE_H

#include "Extension.h"

#include <corral/algebra/Triangular_zero.h>

#include <optional>
#include <vector>

namespace corral::exact {

/// \brief The line over one algebraic point (alpha, beta) of the plane, asked for common zeros of polynomials on it.
///
/// The greatest common divisor t of f_i(alpha, beta, z) over Q(alpha, beta), made square-free, has simple roots only.
/// So intervals around alpha and beta that are short enough show each of them by a change of sign, or that there is
/// none. Elements without inverse split the tower of extensions (dynamic evaluation).
class Fibre
{
public:
  /// \pre `point` is proved by its chain, in the order x, y.
  explicit Fibre(const Triangular_zero<2>& point);

  /// \brief A common zero over the point with z in `side`, proved by a chain; nothing if there is none.
  /// \pre At either end of `side` some polynomial is not zero over the point, and it is not a single point.
  /// \throw whatever `checkpoint` throws.
  [[nodiscard]] std::optional<Triangular_zero<3>> zero_in(const std::vector<Polynomial<Integer, 3>>& system,
                                                          const Rational_interval& side, const Checkpoint& checkpoint);

private:
  using Tower_polynomial = Polynomial_over<Tower>;

  /// t over the fibre; constant if there is no common zero, complex ones included.
  [[nodiscard]] Tower_polynomial common_part(const std::vector<Polynomial<Integer, 3>>& system);
  /// A side over which t has a root and changes sign, with alpha and beta refined until that is clear.
  [[nodiscard]] std::optional<Rational_interval> bracket(const Tower_polynomial& t, const Rational_interval& side);
  [[nodiscard]] Triangular_zero<3> chain(const Tower_polynomial& t, const Rational_interval& z);
  void refine();
  [[nodiscard]] Rational_interval enclose(const Extension_polynomial& element) const;

  Integer_polynomial modulus_; ///< of alpha
  Real_root alpha_;
  Extension_polynomial second_; ///< monic, of beta over Q(alpha)
  Rational_interval beta_;
};

} // namespace corral::exact

#endif
