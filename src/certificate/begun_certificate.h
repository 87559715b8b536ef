// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_CERTIFICATE_BEGUN_CERTIFICATE_H
#define CORRAL_SRC_CERTIFICATE_BEGUN_CERTIFICATE_H

#include <corral/certificate/certificate.h>

#include <cstddef>
#include <vector>

namespace corral::certificate {

/// The decimal digits of a word of 64 bits.
inline constexpr double digits_of_a_word = 19.3;

/// \brief A certificate that has its polynomials and its grid and says nothing yet of any cell.
/// \param work  that of a checker, to which what it does with the polynomials is added.
/// \throw Invalid_input, Budget_exceeded for what the format cannot hold.
template <std::size_t D>
[[nodiscard]] Certificate<D> begun_certificate(const std::vector<Polynomial<Rational, D>>& system, const Grid<D>& grid,
                                               double& work);

} // namespace corral::certificate

#endif
