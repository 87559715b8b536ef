// SPDX-License-Identifier: LGPL-3.0-or-later
#include "case_polynomials.h"

#include <corral/polynomial/arithmetic.h>

#include <vector>

namespace corral::audit {
namespace {

template <std::size_t D>
using Terms = std::vector<typename Polynomial<Rational, D>::Term>;

template <std::size_t D>
long highest_degree()
{
  return D == 1 ? 9 : D == 2 ? 6 : 4;
}

/// A coefficient of the given taste.
enum class Taste {
  full,  ///< every bit of a double matters
  small, ///< an integer, on which nothing is rounded: false methods show, false rounding does not
  long_, ///< more bits than a double has
  fraction,
  any ///< both ends of the range of doubles
};

Taste taste_of(Trouble_source& source)
{
  switch (source.integer(0, 9)) {
  case 0:
    return Taste::small;
  case 1:
    return Taste::long_;
  case 2:
    return Taste::fraction;
  case 3:
    return Taste::any;
  default:
    return Taste::full;
  }
}

// One draw after the other: compilers differ in which operand they compute first.
Rational long_coefficient(Trouble_source& source)
{
  const Rational scale = Trouble_source::scaled(1, -source.integer(40, 70));
  const Rational trailing = source.full_mantissa() * scale;
  return source.full_mantissa() + trailing;
}

Rational coefficient(Trouble_source& source, Taste taste)
{
  switch (taste) {
  case Taste::small:
    return source.integer(0, 1) == 0 ? source.integer(1, 9) : source.integer(-9, -1);
  case Taste::long_:
    return long_coefficient(source);
  case Taste::fraction:
    return source.fraction();
  case Taste::any:
    return source.trouble();
  default:
    return source.chance(20) ? source.trouble() : source.full_mantissa();
  }
}

template <std::size_t D>
Polynomial<Rational, D> random_polynomial(Trouble_source& source, Taste taste)
{
  Terms<D> terms;
  const long degree = source.integer(0, highest_degree<D>());
  for (long n = source.integer(1, 8); n > 0; --n) {
    Exponents<D> exponents;
    for (auto& e : exponents) e = static_cast<std::uint16_t>(source.integer(0, degree));
    terms.push_back({exponents, coefficient(source, taste)});
  }
  return collect<Rational, D>(std::move(terms));
}

/// c y + g(the other variables), such as y + 4x^2 - 1.
template <std::size_t D>
Polynomial<Rational, D> linear_in_one(Trouble_source& source, Taste taste)
{
  const auto axis = static_cast<std::size_t>(source.integer(0, static_cast<long>(D) - 1));
  auto terms = random_polynomial<D>(source, taste).terms();
  for (auto& term : terms) term.exponents[axis] = 0;
  Exponents<D> exponents{};
  exponents[axis] = 1;
  terms.push_back({exponents, coefficient(source, taste)});
  return collect<Rational, D>(std::move(terms));
}

/// Even exponents only: the terms are never negative and their least values lie inside the box.
template <std::size_t D>
Polynomial<Rational, D> even_powers(Trouble_source& source, Taste taste)
{
  auto terms = random_polynomial<D>(source, taste).terms();
  for (auto& term : terms)
    for (auto& e : term.exponents) e = static_cast<std::uint16_t>(e + e % 2);
  return collect<Rational, D>(std::move(terms));
}

/// Every term has every variable, so that all derivatives but the mixed ones vanish at zero.
template <std::size_t D>
Polynomial<Rational, D> mixed_only(Trouble_source& source, Taste taste)
{
  Terms<D> terms;
  for (long n = source.integer(1, 3); n > 0; --n) {
    Exponents<D> exponents;
    for (auto& e : exponents) e = static_cast<std::uint16_t>(source.integer(1, 2));
    terms.push_back({exponents, coefficient(source, taste)});
  }
  return collect<Rational, D>(std::move(terms));
}

/// A power of a linear function, plus a little: on its zero set large terms cancel.
template <std::size_t D>
Polynomial<Rational, D> cancelling(Trouble_source& source)
{
  Terms<D> terms{{Exponents<D>{}, source.full_mantissa()}};
  for (std::size_t axis = 0; axis < D; ++axis) {
    Exponents<D> exponents{};
    exponents[axis] = 1;
    terms.push_back({exponents, source.integer(1, 9)});
  }
  const auto linear = collect<Rational, D>(std::move(terms));
  const auto tiny = Rational(source.full_mantissa() * Trouble_source::scaled(1, -60));
  return power(linear, static_cast<unsigned>(source.integer(2, D <= 2 ? 4 : 2))) + constant<Rational, D>(tiny);
}

} // namespace

template <std::size_t D>
Polynomial<Rational, D> generated_polynomial(Trouble_source& source)
{
  const Taste taste = taste_of(source);
  switch (source.integer(0, 15)) {
  case 0:
    return source.chance(4) ? Polynomial<Rational, D>() : constant<Rational, D>(coefficient(source, taste));
  case 1:
  case 2:
    return linear_in_one<D>(source, taste);
  case 3:
    return even_powers<D>(source, taste);
  case 4:
    return mixed_only<D>(source, taste);
  case 5:
    return cancelling<D>(source);
  default:
    return random_polynomial<D>(source, taste);
  }
}

template Polynomial<Rational, 1> generated_polynomial<1>(Trouble_source&);
template Polynomial<Rational, 2> generated_polynomial<2>(Trouble_source&);
template Polynomial<Rational, 3> generated_polynomial<3>(Trouble_source&);
template Polynomial<Rational, 4> generated_polynomial<4>(Trouble_source&);

} // namespace corral::audit
