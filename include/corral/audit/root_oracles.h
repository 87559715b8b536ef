// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_AUDIT_ROOT_ORACLES_H
#define CORRAL_AUDIT_ROOT_ORACLES_H

#include <corral/algebra/Integer_polynomial.h>
#include <corral/polynomial/Box.h>
#include <corral/polynomial/Polynomial.h>

#include <cstddef>
#include <string_view>
#include <vector>

/// \file
/// Other people's exact root finders, against which Corral's own is tested. Library target `Corral::oracles`.
namespace corral {

/// How many distinct real roots a polynomial that is not zero has.
using Count_real_roots = std::size_t(const Integer_polynomial& p);

/// One maker's way to count.
struct Root_oracle
{
  std::string_view name;
  Count_real_roots* count;
};

/// All of them; the list is in `src/audit/sources.cmake`.
[[nodiscard]] std::vector<Root_oracle> root_oracles();

/// What an oracle says of one real root: the only one in the closed interval.
struct Oracle_root
{
  Rational_interval interval;
  unsigned multiplicity = 1;
};

/// \brief All real roots of p in increasing order, by CGAL's univariate algebraic kernel, with intervals at most
/// `width` wide. \pre p is not zero; width > 0.
[[nodiscard]] std::vector<Oracle_root> cgal_real_roots(const Integer_polynomial& p, const Rational& width);

/// \brief All common real zeros of f and g, by CGAL's bivariate algebraic kernel, as boxes with sides at most `width`.
/// \pre f and g are not constant and have no common factor; width > 0.
[[nodiscard]] std::vector<Rational_box<2>> cgal_common_zeros(const Polynomial<Integer, 2>& f,
                                                             const Polynomial<Integer, 2>& g, const Rational& width);

} // namespace corral

#endif
