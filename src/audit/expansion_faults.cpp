// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Stepwise_bounder.h"

#include <corral/number/Double_bracket.h>
#include <corral/polynomial/evaluate.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string_view>
#include <utility>

namespace corral::audit {
namespace {

Rational nearest_double(const Rational& x)
{
  const double nearest = bracket(x).nearest;
  return std::isfinite(nearest) ? Rational(nearest) : x;
}

template <class Keep>
Exact_polynomial terms_where(const Exact_polynomial& f, const Keep& keep)
{
  std::vector<Exact_polynomial::Term> terms;
  std::copy_if(f.terms().begin(), f.terms().end(), std::back_inserter(terms),
               [&](const auto& term) { return keep(term.exponents); });
  return Exact_polynomial(std::move(terms));
}

struct Odd_as_even : Sound_steps
{
  static constexpr std::string_view name = "odd_as_even";
  static constexpr std::string_view description = "[0, 1] is used for the terms of degree 1 in x";
  static Exact range(const Exponents<2>& k) { return k[0] == 1 ? Exact(0, 1) : Sound_steps::range(k); }
};

struct Parity_of_the_sum : Sound_steps
{
  static constexpr std::string_view name = "parity_of_the_sum";
  static constexpr std::string_view description = "[0, 1] is used where the sum of the exponents is even, as in x*y";
  static Exact range(const Exponents<2>& k) { return total(k) % 2 == 0 ? Exact(0, 1) : Exact(-1, 1); }
};

struct Even_halved : Sound_steps
{
  static constexpr std::string_view name = "even_halved";
  static constexpr std::string_view description = "[-1, 1] halved instead of [0, 1] for even terms";
  static Exact range(const Exponents<2>& k)
  {
    return all_even(k) ? Exact(Rational(-1, 2), Rational(1, 2)) : Exact(-1, 1);
  }
};

struct Missing_half : Sound_steps
{
  static constexpr std::string_view name = "missing_half";
  static constexpr std::string_view description = "for even terms 1 + [-1/2, 1/2] instead of 1/2 + [-1/2, 1/2]";
  static Exact range(const Exponents<2>& k)
  {
    return all_even(k) ? Exact(Rational(1, 2), Rational(3, 2)) : Exact(-1, 1);
  }
};

struct Missing_factorial : Sound_steps
{
  static constexpr std::string_view name = "missing_factorial";
  static constexpr std::string_view description =
      "the value at the centre by Taylor's formula from zero, without 1/3! for the third derivative in x";
  static Exact_polynomial expansion(const Exact_polynomial& f, const Point& centre)
  {
    auto terms = Sound_steps::expansion(f, centre).terms();
    const auto cubic = terms_where(f, [](const auto& k) { return k[0] == 3; });
    if (!terms.empty() && total(terms.front().exponents) == 0) terms.front().coefficient += 5 * evaluate(cubic, centre);
    return Exact_polynomial(std::move(terms));
  }
};

struct Factorial_of_the_sum : Sound_steps
{
  static constexpr std::string_view name = "factorial_of_the_sum";
  static constexpr std::string_view description = "derivatives are divided by (i+j)! instead of i! j!";
  static Exact_polynomial expansion(const Exact_polynomial& f, const Point& centre)
  {
    auto terms = Sound_steps::expansion(f, centre).terms();
    for (auto& [k, c] : terms) {
      Integer binomial;
      mpz_bin_uiui(binomial.get_mpz_t(), total(k), k[0]);
      c /= binomial;
    }
    return Exact_polynomial(std::move(terms));
  }
};

struct Mixed_dropped : Sound_steps
{
  static constexpr std::string_view name = "mixed_dropped";
  static constexpr std::string_view description = "mixed derivatives are dropped";
  static Exact_polynomial expansion(const Exact_polynomial& f, const Point& centre)
  {
    return terms_where(Sound_steps::expansion(f, centre), [](const auto& k) { return k[0] == 0 || k[1] == 0; });
  }
};

struct Highest_dropped : Sound_steps
{
  static constexpr std::string_view name = "highest_dropped";
  static constexpr std::string_view description = "the derivatives of the highest order are dropped";
  static Exact_polynomial expansion(const Exact_polynomial& f, const Point& centre)
  {
    const unsigned degree = f.total_degree();
    return terms_where(Sound_steps::expansion(f, centre), [&](const auto& k) { return total(k) < degree; });
  }
};

struct Remainder_of_order_3_lost : Sound_steps
{
  static constexpr std::string_view name = "remainder_of_order_3_lost";
  static constexpr std::string_view description =
      "Taylor's formula ends at the second derivatives, without a remainder";
  static Exact_polynomial expansion(const Exact_polynomial& f, const Point& centre)
  {
    return terms_where(Sound_steps::expansion(f, centre), [](const auto& k) { return total(k) < 3; });
  }
};

struct Expansion_to_doubles : Sound_steps
{
  static constexpr std::string_view name = "expansion_to_doubles";
  static constexpr std::string_view description = "the coefficients of the expansion are rounded and the errors lost";
  static Exact_polynomial expansion(const Exact_polynomial& f, const Point& centre)
  {
    return transform<Rational>(Sound_steps::expansion(f, centre), nearest_double);
  }
};

struct Constant_dropped : Sound_steps
{
  static constexpr std::string_view name = "constant_dropped";
  static constexpr std::string_view description = "the constant term of the polynomial is dropped";
  static Exact_polynomial coefficients(const Exact_polynomial& f)
  {
    return terms_where(f, [](const auto& k) { return total(k) > 0; });
  }
};

struct Last_term_forgotten : Sound_steps
{
  static constexpr std::string_view name = "last_term_forgotten";
  static constexpr std::string_view description = "the loop over the terms ends one too early";
  static Exact_polynomial coefficients(const Exact_polynomial& f)
  {
    auto terms = f.terms();
    if (!terms.empty()) terms.pop_back();
    return Exact_polynomial(std::move(terms));
  }
};

struct Long_coefficients_rounded : Sound_steps
{
  static constexpr std::string_view name = "long_coefficients_rounded";
  static constexpr std::string_view description = "coefficients lose what is beyond 53 bits, as those above 2^53 do";
  static Exact_polynomial coefficients(const Exact_polynomial& f) { return transform<Rational>(f, nearest_double); }
};

struct Midpoint_rounded : Sound_steps
{
  static constexpr std::string_view name = "midpoint_rounded";
  static constexpr std::string_view description =
      "the midpoint is wrong in the last bit of a double and taken as exact";
  static Rational centre(const Exact& side) { return nearest_double(Sound_steps::centre(side)); }
  static Rational radius(const Exact& side, const Rational&) { return (side.upper() - side.lower()) / 2; }
};

struct Radius_rounded_down : Sound_steps
{
  static constexpr std::string_view name = "radius_rounded_down";
  static constexpr std::string_view description = "the half-width is rounded down to a double";
  static Rational radius(const Exact& side, const Rational& centre)
  {
    return Rational(bracket(Sound_steps::radius(side, centre)).below);
  }
};

struct One_unit_short : Sound_steps
{
  static constexpr std::string_view name = "one_unit_short";
  static constexpr std::string_view description = "the upper end of the bound is one unit in the last place too low";
  static Exact result(const Exact& bound)
  {
    const double shorter = std::nextafter(bracket(bound.upper()).below, -std::numeric_limits<double>::infinity());
    if (!std::isfinite(shorter)) return bound;
    return {std::min(bound.lower(), Rational(shorter)), Rational(shorter)};
  }
};

struct Shrinks : Sound_steps
{
  static constexpr std::string_view name = "shrinks";
  static constexpr std::string_view description = "a thousandth of the width is cut off at each end";
  static Exact result(const Exact& bound)
  {
    const Rational margin = (bound.upper() - bound.lower()) / 1000;
    return {Rational(bound.lower() + margin), Rational(bound.upper() - margin)};
  }
};

template <class... Steps>
std::vector<Planted_bounder> stepwise()
{
  return {planted<Stepwise_bounder<Steps>>()...};
}

} // namespace

std::vector<Planted_bounder> expansion_faults()
{
  return stepwise<Odd_as_even, Parity_of_the_sum, Even_halved, Missing_half, Missing_factorial, Factorial_of_the_sum,
                  Mixed_dropped, Highest_dropped, Remainder_of_order_3_lost, Expansion_to_doubles, Constant_dropped,
                  Last_term_forgotten, Long_coefficients_rounded, Midpoint_rounded, Radius_rounded_down, One_unit_short,
                  Shrinks>();
}

std::vector<Planted_bounder> sound_expansions() { return stepwise<Sound_steps>(); }

} // namespace corral::audit
