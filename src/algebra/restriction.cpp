// SPDX-License-Identifier: LGPL-3.0-or-later
#include "restriction.h"

#include <corral/internal/polynomial/integer_form.h>
#include <corral/polynomial/evaluate.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace corral::exact {

std::vector<Integer> homogeneous_powers(const Rational& value, std::size_t degree)
{
  std::vector<Integer> powers(degree + 1);
  Integer numerator_power = 1;
  for (std::size_t e = 0; e <= degree; ++e, numerator_power *= value.get_num()) powers[e] = numerator_power;
  Integer denominator_power = 1;
  for (std::size_t e = degree + 1; e-- > 0; denominator_power *= value.get_den()) powers[e] *= denominator_power;
  return powers;
}

template <std::size_t D>
Polynomial<Integer, D - 1> restriction(const Polynomial<Integer, D>& g, std::size_t axis, const Rational& value)
{
  const auto weights = homogeneous_powers(value, g.degree(axis));
  std::vector<typename Polynomial<Integer, D - 1>::Term> terms;
  for (const auto& term : g.terms()) {
    Exponents<D - 1> exponents{};
    for (std::size_t k = 0, to = 0; k < D; ++k)
      if (k != axis) exponents[to++] = term.exponents[k];
    terms.push_back({exponents, Integer(term.coefficient * weights[term.exponents[axis]])});
  }
  return primitive_part(collect<Integer, D - 1>(std::move(terms)));
}

template <std::size_t D>
bool vanishes_at(const Polynomial<Integer, D>& g, const Rational_point<D>& point)
{
  if constexpr (D == 1)
    return evaluate(transform<Rational>(g, [](const Integer& c) { return Rational(c); }), point) == 0;
  else {
    Rational_point<D - 1> rest;
    std::copy(point.begin() + 1, point.end(), rest.begin());
    return vanishes_at<D - 1>(restriction(g, 0, point[0]), rest);
  }
}

template Polynomial<Integer, 1> restriction(const Polynomial<Integer, 2>&, std::size_t, const Rational&);
template Polynomial<Integer, 2> restriction(const Polynomial<Integer, 3>&, std::size_t, const Rational&);
template bool vanishes_at(const Polynomial<Integer, 1>&, const Rational_point<1>&);
template bool vanishes_at(const Polynomial<Integer, 2>&, const Rational_point<2>&);
template bool vanishes_at(const Polynomial<Integer, 3>&, const Rational_point<3>&);

} // namespace corral::exact
