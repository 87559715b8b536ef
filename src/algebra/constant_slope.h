// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_ALGEBRA_CONSTANT_SLOPE_H
#define CORRAL_SRC_ALGEBRA_CONSTANT_SLOPE_H

#include <corral/number/Rational.h>
#include <corral/polynomial/Polynomial.h>
#include <corral/polynomial/arithmetic.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace corral::exact {

/// \brief Whether the derivative of f along some direction is constant, so that f takes its least value on every box on
/// the boundary: wherever one starts, f does not grow along that direction or its opposite.
/// \par Complexity  D^2 / 2 sums of partial derivatives.
template <std::size_t D>
[[nodiscard]] bool has_constant_slope(const Polynomial<Integer, D>& f)
{
  using Slope = Polynomial<Rational, D>;
  using Term = typename Slope::Term;
  std::vector<std::pair<Term, Slope>> independent; // up to constants, with a term that no later one has
  for (std::size_t axis = 0; axis < D; ++axis) {
    auto slope = transform<Rational>(derivative(f, axis), [](const Integer& c) { return Rational(c); });
    const auto find_term = [&](const auto& is_wanted) {
      const auto found = std::find_if(slope.terms().begin(), slope.terms().end(), is_wanted);
      return found == slope.terms().end() ? std::nullopt : std::optional<Term>(*found);
    };
    for (const auto& [lead, other] : independent)
      if (const auto same = find_term([&, e = lead.exponents](const Term& term) { return term.exponents == e; }))
        slope = slope - constant<Rational, D>(Rational(same->coefficient / lead.coefficient)) * other;
    const auto lead = find_term([](const Term& term) { return term.exponents != Exponents<D>{}; });
    if (!lead) return true;
    independent.emplace_back(*lead, std::move(slope));
  }
  return false;
}

} // namespace corral::exact

#endif
