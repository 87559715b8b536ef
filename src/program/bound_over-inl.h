// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_PROGRAM_BOUND_OVER_INL_H
#define CORRAL_PROGRAM_BOUND_OVER_INL_H

#include "bound_over.h"

#include <corral/bounders/Any_bounder.h>
#include <corral/number/format.h>
#include <corral/polynomial/Box.h>

namespace corral::program {

template <IntervalNumber I, std::size_t D>
[[nodiscard]] I bound_in(const Bound_problem& problem, Operation_counts& counts)
{
  const auto exact = polynomials_of<D>(problem.space, {problem.polynomial}).front();
  const Arithmetic_scope<I> arithmetic;
  const auto f = transform<I>(exact, [](const Rational& c) { return enclose<I>(c); });
  const Any_bounder<I, D> bounder(problem.method.bounder, f, Bounder_options{.order = problem.method.order});
  const Counting_scope counting;
  const I bound = bounder.bound(enclose<I, D>(box_of<D>(problem.space)));
  counts = counting.counts();
  return bound;
}

template <IntervalNumber I>
Bound_answer bound_over(const Bound_problem& problem)
{
  Bound_answer answer;
  answer.is_guaranteed = is_guaranteed<I>;
  with_dimension(problem.space, [&](auto dimension) {
    const I bound = bound_in<I, dimension>(problem, answer.counts);
    answer.exact = exact_text(bound);
    answer.decimal = decimal_text(bound);
  });
  return answer;
}

} // namespace corral::program

#endif
