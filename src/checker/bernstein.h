// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_CHECKER_BERNSTEIN_H
#define CORRAL_CHECKER_BERNSTEIN_H

#include "polynomial.h"

#include <utility>

namespace corral_check {

/// A positive multiple of the Bernstein coefficients of a polynomial on a box (section 4).
struct Bernstein_form
{
  std::vector<std::size_t> sizes; ///< degree + 1 of each axis, 1 where the box is flat; the last axis runs fastest
  std::vector<mpz_class> coefficients;
  double bit_bound = 0; ///< section 7: no coefficient has more bits

  /// The words that section 7 counts for it.
  [[nodiscard]] double held() const;
  /// Whether an axis can be halved: the polynomial depends on it, and the box is not flat.
  [[nodiscard]] bool is_free(std::size_t axis) const { return sizes[axis] > 1; }
};

/// \pre f is not zero; a side of the box where f has a positive degree is not flat.
[[nodiscard]] Bernstein_form bernstein(const Polynomial& f, const Box& box, Budget& budget);

/// The forms on the lower and the upper half of an axis.
[[nodiscard]] std::pair<Bernstein_form, Bernstein_form> halve(const Bernstein_form& form, std::size_t axis,
                                                              Budget& budget);

/// The form on the lower or the upper facet of an axis.
[[nodiscard]] Bernstein_form facet(const Bernstein_form& form, std::size_t axis, bool is_upper, Budget& budget);

/// Condition `e` of section 4: proves that there is no zero on the box.
[[nodiscard]] bool excludes_zero(const Bernstein_form& form);

/// Condition `h` of section 4: the corners prove a zero on the box.
[[nodiscard]] bool corners_show_zero(const Bernstein_form& form);

/// 1 or -1 if all coefficients are of that strict sign, 0 otherwise, and for the zero polynomial.
/// Flat sides of the box are substituted first ("restricted", section 5).
[[nodiscard]] int strict_sign(Polynomial f, const Box& box, Budget& budget);

} // namespace corral_check

#endif
