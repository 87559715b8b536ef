// SPDX-License-Identifier: LGPL-3.0-or-later
#include "validate.h"

#include "../algebra/Bernstein_form.h"

#include <corral/algebra/Integer_polynomial.h>
#include <corral/polynomial/arithmetic.h>
#include <corral/polynomial/evaluate.h>
#include <corral/polynomial/integer_form.h>
#include <corral/polynomial/substitution.h>

#include <algorithm>
#include <numeric>

namespace corral::certificate {
namespace {

template <std::size_t D>
bool contains_point(const Rational_box<D>& cell, const Rational_point<D>& point)
{
  for (std::size_t axis = 0; axis < D; ++axis)
    if (point[axis] < cell[axis].lower() || point[axis] > cell[axis].upper()) return false;
  return true;
}

/// The strict sign of all Bernstein coefficients on the box, 0 if they have none.
template <std::size_t D>
int strict_sign(const Polynomial<Rational, D>& f, const Rational_box<D>& box)
{
  std::array<Rational, D> offset;
  std::array<Rational, D> scale;
  for (std::size_t axis = 0; axis < D; ++axis) {
    offset[axis] = box[axis].lower();
    scale[axis] = box[axis].upper() - box[axis].lower();
  }
  const auto on_unit_box = affine_substitution(f, offset, scale);
  if (on_unit_box.is_zero()) return 0;
  auto form = exact::dense_power_form(integer_primitive(on_unit_box));
  exact::to_bernstein(form);
  const int sign = sgn(form.values.front());
  return std::all_of(form.values.begin(), form.values.end(), [&](const Integer& b) { return sgn(b) == sign; }) ? sign
                                                                                                               : 0;
}

template <std::size_t D>
bool changes_sign_along(const Polynomial<Rational, D>& f, std::size_t axis, const Rational_box<D>& box)
{
  auto lower = box;
  auto upper = box;
  lower[axis] = Rational_interval(box[axis].lower());
  upper[axis] = Rational_interval(box[axis].upper());
  return strict_sign(f, lower) * strict_sign(f, upper) < 0;
}

/// Whether `f` has no variable of the axes `later` and is monic in that of `axis`.
template <std::size_t D>
bool is_monic(const Polynomial<Rational, D>& f, std::size_t axis, std::span<const std::size_t> later)
{
  const unsigned degree = f.degree(axis);
  if (degree == 0) return false;
  Exponents<D> lead{};
  lead[axis] = static_cast<std::uint16_t>(degree);
  return std::all_of(f.terms().begin(), f.terms().end(), [&](const auto& term) {
    const bool is_lead = term.exponents[axis] == degree;
    return (!is_lead || (term.exponents == lead && term.coefficient == 1))
           && std::all_of(later.begin(), later.end(), [&](std::size_t k) { return term.exponents[k] == 0; });
  });
}

/// The remainder on division by `divisor`, monic in the variable of `axis`.
template <std::size_t D>
Polynomial<Rational, D> remainder(Polynomial<Rational, D> f, const Polynomial<Rational, D>& divisor, std::size_t axis)
{
  const unsigned degree = divisor.degree(axis);
  for (unsigned current = f.degree(axis); !f.is_zero() && current >= degree; current = f.degree(axis)) {
    std::vector<typename Polynomial<Rational, D>::Term> quotient;
    for (auto term : f.terms())
      if (term.exponents[axis] == current) {
        term.exponents[axis] = static_cast<std::uint16_t>(current - degree);
        quotient.push_back(std::move(term));
      }
    f = f - Polynomial<Rational, D>(std::move(quotient)) * divisor;
  }
  return f;
}

template <std::size_t D>
bool fixes(const Polynomial<Rational, D>& f, std::size_t axis, const Rational& value)
{
  return f == variable<Rational, D>(axis) - constant<Rational, D>(value);
}

template <std::size_t D>
bool proves(const Sign_change<D>& change, const Polynomial<Rational, D>& g, const Rational_box<D>& cell)
{
  if (!contains_point<D>(cell, change.first) || !contains_point<D>(cell, change.second)) return false;
  const int first = sgn(evaluate(g, change.first));
  return change.first == change.second ? first == 0 : first * sgn(evaluate(g, change.second)) < 0;
}

template <std::size_t D>
bool proves(const Triangular_zero<D>& zero, Polynomial<Rational, D> g, const Rational_box<D>& cell)
{
  constexpr double max_dense = 65536;
  for (std::size_t k = 0; k < D; ++k) {
    const std::size_t axis = zero.order[k];
    const auto& side = zero.box[axis];
    const auto& t = zero.chain[k];
    double dense = 1;
    for (std::size_t i = 0; i < D; ++i) dense *= t.degree(i) + 1;
    if (dense > max_dense || side.lower() < cell[axis].lower() || side.upper() > cell[axis].upper()) return false;
    if (!is_monic<D>(t, axis, std::span(zero.order).subspan(k + 1))) return false;
    const bool is_flat = side.lower() == side.upper();
    if (is_flat ? !fixes(t, axis, side.lower()) : !changes_sign_along(t, axis, zero.box)) return false;
  }
  for (std::size_t k = D; k-- > 0;) g = remainder(std::move(g), zero.chain[k], zero.order[k]);
  return g.is_zero();
}

} // namespace

template <std::size_t D>
bool is_acceptable(const Witness<D>& witness, const Polynomial<Rational, D>& g, const Rational_box<D>& cell)
{
  if (const auto* change = std::get_if<Sign_change<D>>(&witness)) return proves(*change, g, cell);
  if (const auto* zero = std::get_if<Triangular_zero<D>>(&witness)) return proves(*zero, g, cell);
  return false;
}

/// On a line through the origin in a direction where the form of highest degree does not vanish, no factor becomes
/// constant, so that none loses its multiplicity.
template <std::size_t D>
unsigned highest_multiplicity(const Polynomial<Rational, D>& f)
{
  const unsigned degree = f.total_degree();
  if (degree <= 1) return 1;
  const auto integer = integer_primitive(f);
  for (unsigned long slope = 1;; ++slope) {
    Integer_polynomial line(degree + 1);
    for (const auto& term : integer.terms()) {
      unsigned long exponent = 0; // of `slope`: the direction is (1, slope, slope^2, ...)
      for (std::size_t axis = 0; axis < D; ++axis) exponent += axis * term.exponents[axis];
      Integer factor;
      mpz_ui_pow_ui(factor.get_mpz_t(), slope, exponent);
      line[std::accumulate(term.exponents.begin(), term.exponents.end(), std::size_t{0})] += term.coefficient * factor;
    }
    if (line.back() != 0) return static_cast<unsigned>(square_free_decomposition(line).size());
  }
}

template bool is_acceptable(const Witness<1>&, const Polynomial<Rational, 1>&, const Rational_box<1>&);
template bool is_acceptable(const Witness<2>&, const Polynomial<Rational, 2>&, const Rational_box<2>&);
template bool is_acceptable(const Witness<3>&, const Polynomial<Rational, 3>&, const Rational_box<3>&);
template unsigned highest_multiplicity(const Polynomial<Rational, 1>&);
template unsigned highest_multiplicity(const Polynomial<Rational, 2>&);
template unsigned highest_multiplicity(const Polynomial<Rational, 3>&);

} // namespace corral::certificate
