// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_EXACT_PLANE_SYSTEM_H
#define CORRAL_EXACT_PLANE_SYSTEM_H

#include "Bivariate.h"

#include <corral/verification/Witness.h>

#include <memory>
#include <optional>
#include <vector>

namespace corral::exact {

/// \brief Two coprime polynomials in the plane and their finitely many common real zeros, decided exactly.
///
/// The resultants with respect to y and to x give, as their real roots, all first and all second coordinates. A pair
/// of them is a common zero iff the greatest common divisor of f(alpha, y) and g(alpha, y) over Q(alpha) vanishes at
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
  /// The resultants are computed at the first call and kept.
  /// \throw whatever `checkpoint` throws.
  [[nodiscard]] std::vector<Triangular_zero<2>> zeros_in(const Rational_box<2>& box, bool first_only,
                                                         const Checkpoint& checkpoint);

private:
  using Shared_polynomial = std::shared_ptr<const Integer_polynomial>;

  void eliminate(const Checkpoint& checkpoint);
  [[nodiscard]] bool excluded(Real_root& alpha, Real_root& beta) const;
  [[nodiscard]] std::optional<Triangular_zero<2>> common_zero(Real_root alpha, Real_root beta,
                                                              const Checkpoint& checkpoint) const;

  Polynomial<Integer, 2> f_;
  Polynomial<Integer, 2> g_;
  bool eliminated_ = false;
  std::vector<Shared_polynomial> first_; ///< square-free, coprime factors of the resultant in x
  Shared_polynomial second_;             ///< the square-free resultant in y
};

} // namespace corral::exact

#endif
