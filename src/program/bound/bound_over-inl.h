// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_PROGRAM_BOUND_BOUND_OVER_INL_H
#define CORRAL_SRC_PROGRAM_BOUND_BOUND_OVER_INL_H

#include "bound_over.h"
#include "make_bounder.h"

#include <corral/number/format.h>
#include <corral/polynomial/Box.h>
#include <corral/polynomial/evaluate.h>

#include <algorithm>
#include <utility>

/// Compiles all of it for one number type.
#define CORRAL_INSTANTIATE_BOUND_OVER(I) template Bound_answer bound_over<I>(const Bound_problem&);

namespace corral::program {

template <IntervalNumber I, std::size_t D>
void bound_in(const Bound_problem& problem, Bound_answer& answer)
{
  const auto exact = polynomials_of<D>(problem.space, {problem.polynomial}).front();
  answer.polynomial = readings_of<D>(problem.space, {exact}).front();
  const Arithmetic_scope<I> arithmetic;
  const auto f = transform<I>(exact, [](const Rational& c) { return enclose<I>(c); });
  const auto bounder = make_bounder<I, D>(problem.method, f);
  const Counting_scope counting;
  const I bound = bounder.bound(enclose<I, D>(box_of<D>(problem.space)));
  answer.counts = counting.counts();
  answer.exact = exact_text(bound);
  answer.decimal = decimal_text(bound);
  if (problem.point.empty()) return;
  Rational_point<D> point;
  std::copy_n(problem.point.begin(), D, point.begin());
  Rational value = evaluate(exact, point);
  const bool is_contained = contains(bound, value);
  answer.at_point = Value_answer{std::move(value), is_contained};
}

template <IntervalNumber I>
Bound_answer bound_over(const Bound_problem& problem)
{
  Bound_answer answer;
  answer.is_guaranteed = is_guaranteed<I>;
  with_dimension(problem.space, [&](auto dimension) { bound_in<I, dimension>(problem, answer); });
  return answer;
}

} // namespace corral::program

#endif
