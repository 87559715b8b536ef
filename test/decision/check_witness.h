// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_TEST_DECISION_CHECK_WITNESS_H
#define CORRAL_TEST_DECISION_CHECK_WITNESS_H

#include <corral/decision/Witness.h>
#include <corral/polynomial/arithmetic.h>
#include <corral/polynomial/evaluate.h>

#include <string>
#include <variant>

/// \file
/// Checks what `hit` witnesses claim, by the definition in Witness.h and nothing else.
namespace check {

using namespace corral;

/// The coefficient of x_axis^power, as a polynomial in the other variables.
template <std::size_t D>
Polynomial<Rational, D> coefficient(const Polynomial<Rational, D>& f, std::size_t axis, unsigned power)
{
  std::vector<typename Polynomial<Rational, D>::Term> terms;
  for (auto term : f.terms())
    if (term.exponents[axis] == power) {
      term.exponents[axis] = 0;
      terms.push_back(term);
    }
  return collect<Rational, D>(std::move(terms));
}

/// The remainder of f modulo the monic h with respect to one variable.
template <std::size_t D>
Polynomial<Rational, D> remainder(Polynomial<Rational, D> f, const Polynomial<Rational, D>& h, std::size_t axis)
{
  const unsigned n = h.degree(axis);
  while (!f.is_zero() && f.degree(axis) >= n) {
    const unsigned m = f.degree(axis);
    Exponents<D> shift{};
    shift[axis] = static_cast<std::uint16_t>(m - n);
    f = f - coefficient(f, axis, m) * Polynomial<Rational, D>({{shift, 1}}) * h;
  }
  return f;
}

template <std::size_t D>
bool inside(const Rational_point<D>& point, const Rational_box<D>& cell)
{
  for (std::size_t k = 0; k < D; ++k)
    if (!contains(cell[k], point[k])) return false;
  return true;
}

template <std::size_t D>
int sign_on_end(const Polynomial<Rational, D>& h, Rational_box<D> box, std::size_t axis, bool upper)
{
  box[axis] = Rational_interval(upper ? box[axis].upper() : box[axis].lower());
  return strict_sign(
      evaluate(transform<Rational_interval>(h, [](const Rational& c) { return Rational_interval(c); }), box));
}

template <std::size_t D>
std::string complaint(const Triangular_zero<D>& zero, const Polynomial<Rational, D>& g, const Rational_box<D>& cell)
{
  for (std::size_t k = 0; k < D; ++k)
    if (zero.box[k].lower() < cell[k].lower() || zero.box[k].upper() > cell[k].upper()) return "box leaves the cell";
  auto rest = g;
  for (std::size_t k = D; k-- > 0;) {
    const auto& h = zero.chain[k];
    const std::size_t axis = zero.order[k];
    for (std::size_t later = k + 1; later < D; ++later)
      if (h.degree(zero.order[later]) > 0) return "chain is not triangular";
    if (h.degree(axis) == 0 || !(coefficient(h, axis, h.degree(axis)) == constant<Rational, D>(1))) return "not monic";
    const auto& side = zero.box[axis];
    if (side.lower() == side.upper()) {
      if (!(h == variable<Rational, D>(axis) - constant<Rational, D>(side.lower()))) return "not x - q";
    } else if (sign_on_end(h, zero.box, axis, false) * sign_on_end(h, zero.box, axis, true) != -1)
      return "no change of sign along axis " + std::to_string(axis);
    rest = remainder(rest, h, axis);
  }
  return rest.is_zero() ? "" : "the polynomial does not reduce to zero";
}

/// Why the witness does not prove a zero of g in the closed cell, or "".
template <std::size_t D>
std::string complaint(const Witness<D>& witness, const Polynomial<Rational, D>& g, const Rational_box<D>& cell)
{
  if (const auto* zero = std::get_if<Triangular_zero<D>>(&witness)) return complaint(*zero, g, cell);
  const auto* change = std::get_if<Sign_change<D>>(&witness);
  if (!change) return "no witness of a hit";
  if (!inside<D>(change->first, cell) || !inside<D>(change->second, cell)) return "a point lies outside the cell";
  return sgn(evaluate(g, change->first)) * sgn(evaluate(g, change->second)) <= 0 ? "" : "no change of sign";
}

} // namespace check

#endif
