// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_ALGEBRA_PLANE_SYSTEM_H
#define CORRAL_SRC_ALGEBRA_PLANE_SYSTEM_H

#include "Bivariate.h"

#include <corral/algebra/Triangular_zero.h>

#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace corral::exact {

/// \brief Two coprime polynomials in the plane and their finitely many common real zeros, decided exactly.
///
/// The real roots alpha of the resultant with respect to y are the first coordinates. Where the linear subresultant
/// s1 y + s0 has s1(alpha) != 0, and f or g keeps its degree in y, the one common zero over alpha is y = -s0/s1
/// (alpha). Elsewhere the second coordinates are the real roots of the resultant with respect to x, and a pair (alpha,
/// beta) is a common zero iff the greatest common divisor of f(alpha, y) and g(alpha, y) over Q(alpha) vanishes at
/// beta; as its roots are among the second coordinates, it does iff its square-free part changes sign over beta's
/// isolating interval. Most pairs are excluded by interval arithmetic first. Q(alpha) is Q[x]/m with m square-free,
/// split whenever an element without inverse shows that m is reducible (dynamic evaluation, Della Dora, Dicrescenzo and
/// Duval 1985).
class Plane_system
{
public:
  /// \pre f and g are coprime, and neither is zero.
  Plane_system(Polynomial<Integer, 2> f, Polynomial<Integer, 2> g);

  /// \brief The common zeros in the closed box, each once; only the first one found if `first_only`.
  /// \param with_chain  whether to prove each by a chain, which can cost more than to find it; else the boxes alone are
  /// given. The resultants are computed at the first call and kept.
  /// \throw whatever `checkpoint` throws.
  [[nodiscard]] std::vector<Triangular_zero<2>> zeros_in(const Rational_box<2>& box, bool first_only, bool with_chain,
                                                         const Checkpoint& checkpoint);

private:
  using Shared_polynomial = std::shared_ptr<const Integer_polynomial>;

  enum class Over { none, one, many };

  void eliminate_y(const Checkpoint& checkpoint);
  /// The first coordinates of common zeros, complex ones over them included, in a side. Many boxes share it.
  [[nodiscard]] std::vector<Real_root>& first_coordinates(const Rational_interval& side, const Checkpoint& checkpoint);
  /// The common zeros over alpha as far as the linear subresultant tells: none in `side`, the one it gives, or unclear.
  [[nodiscard]] Over over(Real_root& alpha, const Rational_interval& side) const;
  [[nodiscard]] Triangular_zero<2> linear_zero(Real_root alpha, const Rational_interval& side) const;
  [[nodiscard]] bool excluded(Real_root& alpha, Real_root& beta) const;
  [[nodiscard]] std::optional<Triangular_zero<2>> common_zero(Real_root alpha, Real_root beta,
                                                              const Checkpoint& checkpoint) const;

  Polynomial<Integer, 2> f_;
  Polynomial<Integer, 2> g_;
  std::optional<Elimination> elimination_; ///< of y
  std::vector<Shared_polynomial> first_;   ///< square-free, coprime factors of the resultant in x
  std::map<std::pair<Rational, Rational>, std::vector<Real_root>> alphas_;
  Shared_polynomial second_; ///< the square-free resultant in y
};

} // namespace corral::exact

#endif
