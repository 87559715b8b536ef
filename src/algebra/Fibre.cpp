// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Fibre.h"

#include "../polynomial/to_exponent.h"
#include "on_box.h"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

namespace corral::exact {

namespace {

template <std::size_t D>
Integer_polynomial integer_coefficients(const Polynomial<Rational, D>& f)
{
  std::vector<Polynomial<Rational, 1>::Term> terms;
  for (const auto& term : f.terms()) terms.push_back({{term.exponents[0]}, term.coefficient});
  return integer_polynomial(Polynomial<Rational, 1>(std::move(terms)));
}

Extension_polynomial extension_coefficients(const Polynomial<Rational, 2>& f)
{
  Extension_polynomial result(f.degree(1) + 1U);
  for (const auto& term : f.terms()) {
    auto& c = result[term.exponents[1]];
    if (c.size() <= term.exponents[0]) c.resize(term.exponents[0] + 1U);
    c[term.exponents[0]] = term.coefficient;
  }
  return result;
}

/// The coefficients of z^0, z^1, ... as polynomials in y with coefficients in x.
std::vector<Extension_polynomial> by_last_variable(const Polynomial<Integer, 3>& f)
{
  std::vector<Extension_polynomial> result(f.degree(2) + 1U);
  for (const auto& term : f.terms()) {
    const auto [i, j, k] = term.exponents;
    if (result[k].size() <= j) result[k].resize(j + 1U);
    auto& c = result[k][j];
    if (c.size() <= i) c.resize(i + 1U);
    c[i] = term.coefficient;
  }
  return result;
}

void add_terms(std::vector<Polynomial<Rational, 3>::Term>& terms, const Extension_polynomial& element, std::size_t k)
{
  for (std::size_t j = 0; j < element.size(); ++j)
    for (std::size_t i = 0; i < element[j].size(); ++i)
      terms.push_back({{detail::to_exponent(i), detail::to_exponent(j), detail::to_exponent(k)}, element[j][i]});
}

Rational_interval enclose_coefficients(const Rational_coefficients& c, const Rational_interval& x)
{
  Rational_interval value = 0;
  for (std::size_t i = c.size(); i-- > 0;) value = value * x + Rational_interval(c[i]);
  return value;
}

using Interval_coefficients = std::vector<Rational_interval>;

/// Intervals of power coefficients to those of Bernstein coefficients over `side`.
Interval_coefficients bernstein_over(Interval_coefficients c, const Rational_interval& side)
{
  const std::size_t n = c.size() - 1;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = n; j-- > i;) c[j] = c[j] + c[j + 1] * Rational_interval(side.lower());
  Rational power = 1;
  const Rational width = side.upper() - side.lower();
  Integer binomial;
  for (std::size_t k = 0; k <= n; ++k, power *= width) {
    mpz_bin_uiui(binomial.get_mpz_t(), n, k);
    c[k] = c[k] * Rational_interval(Rational(power / binomial));
  }
  for (std::size_t i = 0; i < n; ++i) // the sums of C(j, k) c_k
    for (std::size_t j = n; j > i; --j) c[j] = c[j] + c[j - 1];
  return c;
}

/// Bisection for a change of sign, as far as intervals show signs.
struct Sign_search
{
  struct Seen
  {
    Rational z;
    int sign;
  };
  std::vector<Seen> seen{}; ///< points in increasing order where the sign is clear
  bool clear = true;        ///< elsewhere the polynomial has no zero

  void see(const Rational& z, const Rational_interval& value)
  {
    if (const int sign = strict_sign(value); sign != 0) seen.push_back({z, sign});
  }

  void run(Interval_coefficients b, const Rational_interval& side, unsigned depth)
  {
    const int sign = strict_sign(b.front());
    if (sign != 0
        && std::all_of(b.begin(), b.end(), [&](const Rational_interval& c) { return strict_sign(c) == sign; }))
      return;
    if (depth == 0) {
      clear = false;
      return;
    }
    const Rational_interval half(Rational(1, 2));
    Interval_coefficients lower;
    for (std::size_t k = b.size(); k-- > 0;) {
      lower.push_back(b.front());
      for (std::size_t i = 0; i < k; ++i) b[i] = (b[i] + b[i + 1]) * half;
    }
    const Rational middle = (side.lower() + side.upper()) / 2;
    run(lower, {side.lower(), middle}, depth - 1);
    see(middle, lower.back());
    run(std::move(b), {middle, side.upper()}, depth - 1);
  }

  [[nodiscard]] std::optional<Rational_interval> change() const
  {
    for (std::size_t k = 1; k < seen.size(); ++k)
      if (seen[k].sign != seen[k - 1].sign) return Rational_interval(seen[k - 1].z, seen[k].z);
    return std::nullopt;
  }
};

/// Whether the Bernstein coefficients of f(x, y, z) on the box of the first `axes` variables have one strict sign.
/// \pre f has only those variables, after z or y is set to `value`.
template <std::size_t Axes>
int shown_sign(const Polynomial<Rational, 3>& f, const Rational& value, const Rational_box<3>& box)
{
  std::vector<typename Polynomial<Rational, Axes>::Term> terms;
  for (const auto& term : f.terms()) {
    Exponents<Axes> exponents{};
    std::copy_n(term.exponents.begin(), Axes, exponents.begin());
    Rational c = term.coefficient;
    for (unsigned e = 0; e < term.exponents[Axes]; ++e) c *= value;
    terms.push_back({exponents, c});
  }
  Rational_box<Axes> side;
  std::copy_n(box.begin(), Axes, side.begin());
  const auto form = bernstein_form(integer_primitive(collect<Rational, Axes>(std::move(terms))), side);
  const int sign = form.values.empty() ? 0 : sgn(form.values.front());
  return std::all_of(form.values.begin(), form.values.end(), [&](const Integer& c) { return sgn(c) == sign; }) ? sign
                                                                                                               : 0;
}

} // namespace

Fibre::Fibre(const Triangular_zero<2>& point)
    : modulus_(integer_coefficients(point.chain[0])),
      alpha_(std::make_shared<const Integer_polynomial>(modulus_), point.box[0], 1),
      second_(extension_coefficients(point.chain[1])), beta_(point.box[1])
{}

std::optional<Triangular_zero<3>> Fibre::zero_in(const std::vector<Polynomial<Integer, 3>>& system,
                                                 const Rational_interval& side, const Checkpoint& checkpoint)
{
  alpha_.set_checkpoint(checkpoint);
  const auto t = common_part(system);
  if (t.size() < 2) return std::nullopt;
  const auto z = bracket(t, side);
  if (!z) return std::nullopt;
  return chain(t, *z);
}

Fibre::Tower_polynomial Fibre::common_part(const std::vector<Polynomial<Integer, 3>>& system)
{
  for (;;) {
    try {
      const Tower tower(Extension(modulus_, alpha_), second_, beta_);
      Tower_polynomial common;
      for (const auto& f : system) {
        Tower_polynomial over;
        for (auto& c : by_last_variable(f)) over.push_back(tower.reduce(std::move(c)));
        trim_leading(over);
        if (!over.empty()) common = gcd_over(tower, std::move(over), std::move(common));
      }
      return square_free_over(tower, common);
    } catch (Extension::Split& split) {
      modulus_ = std::move(split.factor);
    } catch (Tower::Split& split) {
      second_ = std::move(split.factor);
    }
  }
}

/// Twice two halvings of beta, each by the exact sign over alpha.
void Fibre::refine()
{
  alpha_.refine();
  const auto sign = [&](const Rational& y) { return alpha_.sign_of(value_at(second_, y)); };
  for (int k = 0; k < 4 && beta_.lower() < beta_.upper(); ++k) {
    const Rational middle = (beta_.lower() + beta_.upper()) / 2;
    const int s = sign(middle);
    if (s == 0) {
      beta_ = Rational_interval(middle);
      second_ = {Rational_coefficients{Rational(-middle)}, Rational_coefficients{1}};
      if (middle == 0) second_[0].clear();
    } else
      beta_ = s == sign(beta_.lower()) ? Rational_interval(middle, beta_.upper())
                                       : Rational_interval(beta_.lower(), middle);
  }
}

Rational_interval Fibre::enclose(const Extension_polynomial& element) const
{
  Rational_interval value = 0;
  for (std::size_t j = element.size(); j-- > 0;)
    value = value * beta_ + enclose_coefficients(element[j], alpha_.interval());
  return value;
}

std::optional<Rational_interval> Fibre::bracket(const Tower_polynomial& t, const Rational_interval& side)
{
  for (unsigned depth = 2;; depth += 2) {
    refine();
    Interval_coefficients c;
    for (const auto& element : t) c.push_back(enclose(element));
    auto b = bernstein_over(std::move(c), side);
    Sign_search search;
    search.see(side.lower(), b.front());
    const auto last = b.back();
    search.run(std::move(b), side, depth);
    search.see(side.upper(), last);
    if (auto found = search.change()) return found;
    if (search.clear) return std::nullopt;
  }
}

Triangular_zero<3> Fibre::chain(const Tower_polynomial& t, const Rational_interval& z)
{
  Triangular_zero<3> result;
  result.order = {0, 1, 2};
  std::vector<Polynomial<Rational, 3>::Term> terms;
  for (std::size_t k = 0; k < t.size(); ++k) add_terms(terms, t[k], k);
  result.chain[2] = collect<Rational, 3>(std::move(terms));
  for (;;) {
    Rational_coefficients m;
    if (alpha_.is_point())
      m = {-alpha_.lower(), 1};
    else
      for (const Integer& c : modulus_) m.push_back(Rational(c) / modulus_.lead());
    for (const std::size_t k : {0U, 1U}) {
      std::vector<Polynomial<Rational, 3>::Term> lower;
      add_terms(lower, k == 0 ? Extension_polynomial{m} : second_, 0);
      result.chain[k] = collect<Rational, 3>(std::move(lower));
    }
    result.box = {alpha_.interval(), beta_, z};
    const bool second_clear = beta_.lower() == beta_.upper()
                              || shown_sign<1>(result.chain[1], beta_.lower(), result.box)
                                         * shown_sign<1>(result.chain[1], beta_.upper(), result.box)
                                     < 0;
    if (second_clear
        && shown_sign<2>(result.chain[2], z.lower(), result.box) * shown_sign<2>(result.chain[2], z.upper(), result.box)
               < 0)
      return result;
    refine();
  }
}

} // namespace corral::exact
