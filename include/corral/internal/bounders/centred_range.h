// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_INTERNAL_BOUNDERS_CENTRED_RANGE_H
#define CORRAL_INTERNAL_BOUNDERS_CENTRED_RANGE_H

#include <corral/internal/bounders/Scaled_taylor.h>
#include <corral/polynomial/evaluate.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace corral {

/// \brief The sum of the ranges of the terms of a centred polynomial, each taken by itself.
///
/// `range_of_term(k, c)` encloses c u^k for u in [-1, 1]^D; the constant term is kept as it is. The powers of the
/// half-widths, which are not negative, are multiplied in by Horner's rule.
template <IntervalNumber I, std::size_t D, class Range_of_term>
[[nodiscard]] I centred_range(const Centred_polynomial<I, D>& f, const Range_of_term& range_of_term)
{
  auto terms = f.taylor.terms();
  for (auto& term : terms)
    if (term.exponents != Exponents<D>{}) term.coefficient = range_of_term(term.exponents, term.coefficient);
  return evaluate(Polynomial<I, D>(Sorted_terms(), std::move(terms)), f.radius);
}

} // namespace corral

#endif
