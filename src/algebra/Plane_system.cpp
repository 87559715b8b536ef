// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Plane_system.h"

#include "../polynomial/to_exponent.h"
#include "Extension.h"

#include <corral/internal/number/Wrong_answer.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace corral::exact {

namespace {

constexpr std::size_t max_columns = 256; // kept for other boxes over the same side, then forgotten: bounded memory

/// f over [alpha] x [beta], by Horner's rule in y.
Rational_interval enclose(const Bivariate& f, const Rational_interval& x, const Rational_interval& y)
{
  Rational_interval value = 0;
  for (std::size_t j = f.size(); j-- > 0;) value = value * y + evaluate(f[j], x);
  return value;
}

Extension_polynomial over_extension(const Bivariate& f, const Extension& field)
{
  Extension_polynomial result;
  for (const auto& c : f) result.push_back(field.reduce(Rational_coefficients(c.begin(), c.end())));
  trim_leading(result);
  return result;
}

/// The strict sign of p over the interval, shown by its Bernstein coefficients; 0 if they do not show one.
int shown_sign(const Integer_polynomial& p, const Rational_interval& x)
{
  if (x.lower() == x.upper()) return sign_at(p, x.lower());
  const auto b = bernstein_coefficients(compose_affine(p, x.lower(), x.upper() - x.lower()));
  const int sign = sgn(b.front());
  return std::all_of(b.begin(), b.end(), [&](const Integer& c) { return sgn(c) == sign; }) ? sign : 0;
}

Polynomial<Rational, 2> chain_element(const Extension_polynomial& h)
{
  std::vector<Polynomial<Rational, 2>::Term> terms;
  for (std::size_t j = 0; j < h.size(); ++j)
    for (std::size_t i = 0; i < h[j].size(); ++i)
      if (h[j][i] != 0) terms.push_back({{detail::to_exponent(i), detail::to_exponent(j)}, h[j][i]});
  return collect<Rational, 2>(std::move(terms));
}

Extension_polynomial linear(const Rational& root)
{
  return root == 0 ? Extension_polynomial{{}, {1}} : Extension_polynomial{{-root}, {1}};
}

/// The polynomial x - a or m, monic, as the first element of a chain.
Polynomial<Rational, 2> first_element(const Integer_polynomial& m, const Real_root& alpha)
{
  Extension_polynomial column(1);
  if (alpha.is_point())
    column[0] = {-alpha.lower(), 1};
  else
    for (const Integer& c : m) {
      Rational monic(c, m.lead());
      monic.canonicalize();
      column[0].push_back(monic);
    }
  return chain_element(column);
}

/// The minimal polynomial of alpha.
Integer_polynomial irreducible_modulus(const Real_root& alpha)
{
  if (!alpha.is_point()) return irreducible_factor(alpha);
  return {-alpha.lower().get_num(), alpha.lower().get_den()};
}

/// s1 y + s0 at a rational y, times a positive integer.
Integer_polynomial linear_at(const Integer_polynomial& s1, const Integer_polynomial& s0, const Rational& y)
{
  std::vector<Integer> result(std::max(s1.size(), s0.size()));
  for (std::size_t i = 0; i < s1.size(); ++i) result[i] += s1[i] * y.get_num();
  for (std::size_t i = 0; i < s0.size(); ++i) result[i] += s0[i] * y.get_den();
  return Integer_polynomial(std::move(result));
}

} // namespace

Plane_system::Plane_system(Polynomial<Integer, 2> f, Polynomial<Integer, 2> g) : f_(std::move(f)), g_(std::move(g)) {}

void Plane_system::eliminate_y(const Checkpoint& checkpoint)
{
  if (elimination_) return;
  auto elimination = eliminate(bivariate(f_, 1), bivariate(g_, 1), checkpoint);
  if (elimination.resultant.is_zero()) throw Wrong_answer("algebra: two polynomials said to be coprime are not");
  for (auto& factor : square_free_decomposition(elimination.resultant, checkpoint))
    if (degree(factor) > 0) first_.push_back(std::make_shared<const Integer_polynomial>(std::move(factor)));
  elimination_ = std::move(elimination); // last: a checkpoint that throws leaves nothing half done
}

std::vector<Triangular_zero<2>> Plane_system::zeros_in(const Rational_box<2>& box, bool first_only, bool with_chain,
                                                       const Checkpoint& checkpoint)
{
  std::vector<Triangular_zero<2>> zeros;
  if (f_.is_constant() || g_.is_constant()) return zeros;
  eliminate_y(checkpoint);
  for (Real_root alpha : first_coordinates(box[0], checkpoint)) {
    alpha.set_checkpoint(checkpoint);
    const auto fibre = over(alpha, box[1]);
    if (fibre == Over::one)
      zeros.push_back(with_chain ? linear_zero(alpha, box[1]) : Triangular_zero<2>{{}, {}, {alpha.interval(), box[1]}});
    if (fibre == Over::many) {
      if (!second_)
        second_ = std::make_shared<const Integer_polynomial>(
            square_free_part(eliminate(bivariate(f_, 0), bivariate(g_, 0), checkpoint).resultant, checkpoint));
      for (auto& beta : isolate_simple_roots(second_, box[1], checkpoint)) {
        beta.set_checkpoint(checkpoint);
        if (excluded(alpha, beta)) continue;
        if (auto zero = common_zero(alpha, beta, checkpoint)) zeros.push_back(std::move(*zero));
      }
    }
    if (first_only && !zeros.empty()) return zeros;
  }
  return zeros;
}

std::vector<Real_root>& Plane_system::first_coordinates(const Rational_interval& side, const Checkpoint& checkpoint)
{
  const std::pair ends(side.lower(), side.upper());
  if (const auto known = alphas_.find(ends); known != alphas_.end()) return known->second;
  std::vector<Real_root> roots;
  for (const auto& factor : first_) {
    auto more = isolate_simple_roots(factor, side, checkpoint);
    std::move(more.begin(), more.end(), std::back_inserter(roots));
  }
  if (alphas_.size() >= max_columns) alphas_.clear();
  return alphas_.insert_or_assign(ends, std::move(roots)).first->second;
}

Plane_system::Over Plane_system::over(Real_root& alpha, const Rational_interval& side) const
{
  const auto& s1 = elimination_->s1;
  const auto& s0 = elimination_->s0;
  if (s1.is_zero() || alpha.sign_of(s1) == 0) return Over::many;
  if (alpha.sign_of(bivariate(f_, 1).back()) == 0 && alpha.sign_of(bivariate(g_, 1).back()) == 0) return Over::many;
  const int below = alpha.sign_of(linear_at(s1, s0, side.lower()));
  const int above = alpha.sign_of(linear_at(s1, s0, side.upper()));
  return below * above <= 0 ? Over::one : Over::none;
}

Triangular_zero<2> Plane_system::linear_zero(Real_root alpha, const Rational_interval& side) const
{
  (void)alpha.make_rational();
  const auto& [resultant, s1, s0] = *elimination_;
  for (auto m = irreducible_modulus(alpha);;) {
    try {
      const Extension field(m, alpha);
      const auto inverse = field.inverse(field.reduce(Rational_coefficients(s1.begin(), s1.end())));
      auto y = field.multiply(field.reduce(Rational_coefficients(s0.begin(), s0.end())), inverse); // minus y
      for (const Rational& end : {side.lower(), side.upper()})
        if (alpha.sign_of(linear_at(s1, s0, end)) == 0)
          return {{0, 1},
                  {first_element(m, alpha), chain_element(linear(end))},
                  {alpha.interval(), Rational_interval(end)}};
      const Extension_polynomial h = {std::move(y), {1}};
      const auto below = value_at(h, side.lower());
      const auto above = value_at(h, side.upper());
      while (shown_sign(below, alpha.interval()) * shown_sign(above, alpha.interval()) == 0) alpha.refine();
      return {{0, 1}, {first_element(m, alpha), chain_element(h)}, {alpha.interval(), side}};
    } catch (Extension::Split& split) {
      m = std::move(split.factor);
    }
  }
}

bool Plane_system::excluded(Real_root& alpha, Real_root& beta) const
{
  const auto f = bivariate(f_, 1);
  const auto g = bivariate(g_, 1);
  for (int round = 0; round < 5; ++round) {
    if (!contains_zero(enclose(f, alpha.interval(), beta.interval()))) return true;
    if (!contains_zero(enclose(g, alpha.interval(), beta.interval()))) return true;
    alpha.refine();
    beta.refine();
  }
  return false;
}

std::optional<Triangular_zero<2>> Plane_system::common_zero(Real_root alpha, Real_root beta,
                                                            const Checkpoint& checkpoint) const
{
  (void)alpha.make_rational();
  (void)beta.make_rational();
  const auto f = bivariate(f_, 1);
  const auto g = bivariate(g_, 1);
  for (auto m = irreducible_modulus(alpha);;) {
    if (checkpoint) checkpoint();
    try {
      const Extension field(m, alpha);
      auto h = gcd_over(field, over_extension(f, field), over_extension(g, field));
      if (beta.is_point()) {
        if (alpha.sign_of(value_at(h, beta.lower())) != 0) return std::nullopt;
        h = linear(beta.lower());
      } else {
        h = square_free_over(field, h);
        const auto below = value_at(h, beta.lower());
        const auto above = value_at(h, beta.upper());
        if (alpha.sign_of(below) == alpha.sign_of(above)) return std::nullopt;
        while (shown_sign(below, alpha.interval()) == 0 || shown_sign(above, alpha.interval()) == 0) alpha.refine();
      }
      return Triangular_zero<2>{
          {0, 1}, {first_element(m, alpha), chain_element(h)}, {alpha.interval(), beta.interval()}};
    } catch (Extension::Split& split) {
      m = std::move(split.factor);
    }
  }
}

} // namespace corral::exact
