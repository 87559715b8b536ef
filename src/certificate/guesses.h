// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_CERTIFICATE_GUESSES_H
#define CORRAL_SRC_CERTIFICATE_GUESSES_H

#include "Counted_form.h"

#include <corral/certificate/certificate.h>
#include <corral/decision/Witness.h>

#include <cstddef>
#include <vector>

/// \file
/// Cheap candidates for witnesses, by doubles; each has to be checked.
namespace corral::certificate {

/// \brief Points of the cell, in its own coordinates, where one polynomial might have another sign than at the corners:
/// near its least values, counted from that sign.
template <std::size_t D>
[[nodiscard]] std::vector<Rational_point<D>> guess_other_sign(const Counted_form<D>& form);

/// \brief Boxes around points of the cell where two polynomials might have a common zero, with the inverse of what
/// the forms have for a Jacobian there. The matrix is for polynomials with a gradient like that of the forms.
/// \param polynomials  those that the matrix is for: the forms times positive numbers.
template <std::size_t D>
[[nodiscard]] std::vector<Miranda_zero<D>> guess_common_zeros(const std::vector<Counted_form<D>>& forms,
                                                              const std::vector<Polynomial<Rational, D>>& polynomials,
                                                              const Rational_box<D>& cell);

} // namespace corral::certificate

#endif
