// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_ALGEBRA_ON_BOX_H
#define CORRAL_SRC_ALGEBRA_ON_BOX_H

#include "Bernstein_form.h"

#include <corral/internal/polynomial/integer_form.h>
#include <corral/polynomial/Box.h>
#include <corral/polynomial/substitution.h>

#include <cstddef>

namespace corral::exact {

[[nodiscard]] inline Rational to_rational(const Integer& c) { return c; }

/// f on a box as a positive multiple of its Bernstein coefficients. Sides may be points.
template <std::size_t D>
[[nodiscard]] Bernstein_form<D> bernstein_form(const Polynomial<Integer, D>& f, const Rational_box<D>& box)
{
  (void)dense_size(f); // before the substitution makes so many terms
  std::array<Rational, D> offset;
  std::array<Rational, D> scale;
  for (std::size_t k = 0; k < D; ++k) {
    offset[k] = box[k].lower();
    scale[k] = box[k].upper() - box[k].lower();
  }
  return to_bernstein(
      power_form(integer_primitive(affine_substitution(transform<Rational>(f, to_rational), offset, scale))));
}

} // namespace corral::exact

#endif
