// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_DECISION_LIFT_H
#define CORRAL_SRC_DECISION_LIFT_H

#include <corral/decision/Witness.h>

#include <cstddef>
#include <vector>

/// \file
/// Witnesses of a facet as witnesses of the box.
namespace corral::exact {

/// The sides of the box but that of one axis.
template <std::size_t D>
Rational_box<D - 1> side_of(const Rational_box<D>& box, std::size_t axis)
{
  Rational_box<D - 1> side;
  for (std::size_t k = 0, to = 0; k < D; ++k)
    if (k != axis) side[to++] = box[k];
  return side;
}

/// The point with one more coordinate.
template <std::size_t D>
Rational_point<D + 1> insert(const Rational_point<D>& point, std::size_t axis, const Rational& value)
{
  Rational_point<D + 1> result;
  for (std::size_t k = 0; k <= D; ++k) result[k] = k == axis ? value : point[k < axis ? k : k - 1];
  return result;
}

/// The polynomial with one more variable, which does not occur.
template <std::size_t D>
Polynomial<Rational, D + 1> insert(const Polynomial<Rational, D>& f, std::size_t axis)
{
  std::vector<typename Polynomial<Rational, D + 1>::Term> terms;
  for (const auto& term : f.terms()) {
    Exponents<D + 1> exponents{};
    for (std::size_t k = 0; k <= D; ++k)
      if (k != axis) exponents[k] = term.exponents[k < axis ? k : k - 1];
    terms.push_back({exponents, term.coefficient});
  }
  return collect<Rational, D + 1>(std::move(terms));
}

/// The witness of a facet as one of the whole cell.
template <std::size_t D>
Witness<D + 1> lift(const Witness<D>& witness, std::size_t axis, const Rational& value)
{
  if (const auto* change = std::get_if<Sign_change<D>>(&witness))
    return Sign_change<D + 1>{insert<D>(change->first, axis, value), insert<D>(change->second, axis, value)};
  if (const auto* zero = std::get_if<Triangular_zero<D>>(&witness)) {
    Triangular_zero<D + 1> result;
    result.order[0] = axis;
    result.chain[0] = collect<Rational, D + 1>(
        {{Exponents<D + 1>{}, -value}, {variable<Rational, D + 1>(axis).terms().front().exponents, 1}});
    result.box[axis] = Rational_interval(value);
    for (std::size_t k = 0; k < D; ++k) {
      const std::size_t from = zero->order[k];
      result.order[k + 1] = from < axis ? from : from + 1;
      result.chain[k + 1] = insert<D>(zero->chain[k], axis);
      result.box[k < axis ? k : k + 1] = zero->box[k];
    }
    return result;
  }
  return std::monostate{};
}

} // namespace corral::exact

#endif
