// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_CERTIFICATE_VALIDATE_H
#define CORRAL_CERTIFICATE_VALIDATE_H

#include <corral/certificate/certificate.h>

#include <cstddef>
#include <vector>

/// \file
/// The conditions of doc/certificate.md, section 5, seen from the side that writes.
namespace corral::certificate {

/// \brief Whether the proof shows a common zero of the polynomials in the closed cell in a way that a checker accepts.
/// \param work  grows by what a checker counts for it.
template <std::size_t D>
[[nodiscard]] bool is_acceptable(const Cell_proof<D>& proof, const std::vector<Polynomial<Rational, D>>& polynomials,
                                 const Rational_box<D>& cell, double& work);

/// \brief What a checker counts to see that g divides f and that f divides g^power, as they do; more than `max_work` if
/// it would not do it.
template <std::size_t D>
[[nodiscard]] double square_free_work(const Polynomial<Rational, D>& f, const Polynomial<Rational, D>& g,
                                      unsigned power);

/// Multiplicity of the most multiple factor of `f`, or more. \pre f is not zero.
template <std::size_t D>
[[nodiscard]] unsigned highest_multiplicity(const Polynomial<Rational, D>& f);

} // namespace corral::certificate

#endif
