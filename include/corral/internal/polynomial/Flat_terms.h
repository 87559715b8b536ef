// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_INTERNAL_POLYNOMIAL_FLAT_TERMS_H
#define CORRAL_INTERNAL_POLYNOMIAL_FLAT_TERMS_H

#include <corral/polynomial/Polynomial.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace corral::detail {

/// The terms of a polynomial in any number of variables: `dimension` exponents for each coefficient.
struct Flat_terms
{
  std::size_t dimension;
  std::vector<std::uint16_t> exponents;
  std::vector<Integer> coefficients;
};

template <std::size_t D>
[[nodiscard]] Flat_terms flat_terms(const Polynomial<Integer, D>& f)
{
  Flat_terms flat{D, {}, {}};
  for (const auto& term : f.terms()) {
    flat.exponents.insert(flat.exponents.end(), term.exponents.begin(), term.exponents.end());
    flat.coefficients.push_back(term.coefficient);
  }
  return flat;
}

/// The inverse of `flat_terms`. \pre `flat.dimension` is D.
template <std::size_t D>
[[nodiscard]] Polynomial<Integer, D> from_flat_terms(Flat_terms flat)
{
  CORRAL_PRECONDITION(flat.dimension == D, "from_flat_terms: given terms of another dimension");
  std::vector<typename Polynomial<Integer, D>::Term> terms(flat.coefficients.size());
  for (std::size_t i = 0; i < terms.size(); ++i) {
    std::copy_n(flat.exponents.begin() + static_cast<std::ptrdiff_t>(i * D), D, terms[i].exponents.begin());
    terms[i].coefficient = std::move(flat.coefficients[i]);
  }
  return collect<Integer, D>(std::move(terms));
}

} // namespace corral::detail

#endif
