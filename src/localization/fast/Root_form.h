// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_LOCALIZATION_FAST_ROOT_FORM_H
#define CORRAL_SRC_LOCALIZATION_FAST_ROOT_FORM_H

#include "Monomial_shape.h"

#include <corral/localization/Grid.h>

#include <array>
#include <vector>

namespace corral::fast {

/// A positive multiple of a polynomial on the padded grid, in coordinates u of [-1, 1]^D: it differs from
/// sum_k coefficients[k] u^shape[k] by at most `remainder`, and every |coefficient| is at most 1.
struct Root_form
{
  std::vector<double> coefficients;
  double remainder = 0;
  /// All coefficients are multiples of this power of two; 0 if a coefficient was rounded.
  double quantum = 0;
};

/// \brief Substitutes x_i = lower_i + step_i 2^(K_i) (1 + u_i) / 2 exactly, in integers, and rounds once at the end.
/// \param cells_log2  the exponents K_i of the padded grid.
/// \pre `shape` is the shape of `f`, and f is not zero.
template <std::size_t D>
[[nodiscard]] Root_form root_form(const Polynomial<Rational, D>& f, const Monomial_shape<D>& shape, const Grid<D>& grid,
                                  const std::array<unsigned, D>& cells_log2);

extern template Root_form root_form<2>(const Polynomial<Rational, 2>&, const Monomial_shape<2>&, const Grid<2>&,
                                       const std::array<unsigned, 2>&);
extern template Root_form root_form<3>(const Polynomial<Rational, 3>&, const Monomial_shape<3>&, const Grid<3>&,
                                       const std::array<unsigned, 3>&);

} // namespace corral::fast

#endif
