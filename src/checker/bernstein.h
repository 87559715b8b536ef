// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_CHECKER_BERNSTEIN_H
#define CORRAL_CHECKER_BERNSTEIN_H

#include "polynomial.h"

#include <utility>

namespace corral_check {

/// A positive multiple of the Bernstein coefficients of a polynomial on a box (section 4).
struct Bernstein_form
{
  std::vector<std::size_t> sizes; ///< degree + 1 of each axis; the last axis runs fastest
  std::vector<mpz_class> coefficients;

  /// Memory in words, at most.
  [[nodiscard]] double weight() const;
};

/// \pre f is not zero; every side of the box is at most flat where f has the degree 0.
[[nodiscard]] Bernstein_form bernstein(const Polynomial& f, const Box& box, Budget& budget);

/// The forms on the lower and the upper half of an axis.
[[nodiscard]] std::pair<Bernstein_form, Bernstein_form> halve(const Bernstein_form& form, std::size_t axis,
                                                              Budget& budget);

/// Condition `e` of section 4: proves that there is no zero on the box.
[[nodiscard]] bool excludes_zero(const Bernstein_form& form);

/// Condition `h` of section 4: the corners prove a zero on the box.
[[nodiscard]] bool corners_show_zero(const Bernstein_form& form);

/// 1 or -1 if all coefficients are of that strict sign, 0 otherwise, and for the zero polynomial.
/// Flat sides of the box are substituted first ("restricted", section 5).
[[nodiscard]] int strict_sign(Polynomial f, const Box& box, Budget& budget);

} // namespace corral_check

#endif
