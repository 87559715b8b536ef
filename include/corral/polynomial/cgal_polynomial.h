// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_POLYNOMIAL_CGAL_POLYNOMIAL_H
#define CORRAL_POLYNOMIAL_CGAL_POLYNOMIAL_H

#include <corral/polynomial/Polynomial.h>

#include <CGAL/Polynomial.h>
#include <CGAL/Polynomial_traits_d.h>
#include <CGAL/Polynomial_type_generator.h>
#include <CGAL/mpq_class.h>
#include <CGAL/mpz_class.h>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

/// \file
/// To and from CGAL's polynomials, whose innermost variable is Corral's variable 0. The only header
/// of this folder that includes CGAL.
namespace corral {

/// CGAL's recursive polynomial in D variables over the coefficient type NT.
template <class NT, std::size_t D>
using Cgal_polynomial = typename CGAL::Polynomial_type_generator<NT, static_cast<int>(D)>::Type;

/// The same polynomial as one of CGAL. \par Complexity  a sort of the terms.
template <class NT, std::size_t D>
[[nodiscard]] Cgal_polynomial<NT, D> to_cgal(const Polynomial<NT, D>& f)
{
  std::vector<std::pair<CGAL::Exponent_vector, NT>> monomials;
  for (const auto& term : f.terms()) {
    const std::vector<int> exponents(term.exponents.begin(), term.exponents.end());
    monomials.emplace_back(CGAL::Exponent_vector(exponents.begin(), exponents.end()), term.coefficient);
  }
  using Traits = CGAL::Polynomial_traits_d<Cgal_polynomial<NT, D>>;
  return typename Traits::Construct_polynomial()(monomials.begin(), monomials.end());
}

/// The same polynomial as one of Corral; `from_cgal<NT, D>(f)`.
/// \throw Invalid_input if an exponent is above 65535.
template <class NT, std::size_t D>
[[nodiscard]] Polynomial<NT, D> from_cgal(const Cgal_polynomial<NT, D>& f)
{
  std::vector<std::pair<CGAL::Exponent_vector, NT>> monomials;
  using Traits = CGAL::Polynomial_traits_d<Cgal_polynomial<NT, D>>;
  typename Traits::Monomial_representation()(f, std::back_inserter(monomials));
  std::vector<typename Polynomial<NT, D>::Term> terms;
  for (const auto& [cgal_exponents, coefficient] : monomials) {
    Exponents<D> exponents;
    for (std::size_t axis = 0; axis < D; ++axis) {
      const int exponent = cgal_exponents[axis];
      if (exponent > 0xffff) detail::refuse_input("from_cgal: given an exponent above 65535; expected at most that");
      exponents[axis] = static_cast<std::uint16_t>(exponent);
    }
    terms.push_back({exponents, coefficient});
  }
  return collect<NT, D>(std::move(terms));
}

} // namespace corral

#endif
