// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_AUDIT_CASE_POLYNOMIALS_H
#define CORRAL_SRC_AUDIT_CASE_POLYNOMIALS_H

#include <corral/audit/Trouble_source.h>
#include <corral/polynomial/Polynomial.h>

#include <cstddef>

namespace corral::audit {

/// A polynomial on which false methods and false rounding show; doc/audit.md says how they are biased.
template <std::size_t D>
[[nodiscard]] Polynomial<Rational, D> generated_polynomial(Trouble_source& source);

} // namespace corral::audit

#endif
