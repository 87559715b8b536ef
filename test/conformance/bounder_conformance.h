// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_TEST_CONFORMANCE_BOUNDER_CONFORMANCE_H
#define CORRAL_TEST_CONFORMANCE_BOUNDER_CONFORMANCE_H

#include "conformance/Random.h"

#include <corral/bounders/Range_bounder.h>
#include <corral/polynomial/Box.h>
#include <corral/polynomial/evaluate.h>
#include <corral/polynomial/print.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace corral::test {

inline constexpr std::array<const char*, 4> variable_names = {"x", "y", "z", "w"};

template <std::size_t D>
std::string text_of(const Rational_box<D>& box)
{
  std::string text;
  for (const auto& side : box)
    text += (text.empty() ? "[" : " x [") + to_string(side.lower()) + ", " + to_string(side.upper()) + "]";
  return text;
}

template <std::size_t D>
std::string text_of(const Polynomial<Rational, D>& f)
{
  std::array<std::string, D> names;
  std::copy_n(variable_names.begin(), D, names.begin());
  return to_string(f, names);
}

/// A polynomial, a box, and the least and greatest exact value among some points of the box.
template <std::size_t D>
struct Bounder_case
{
  static constexpr int points = 16;
  Polynomial<Rational, D> f;
  Rational_box<D> box;
  Rational least;
  Rational greatest;
};

/// \brief Random cases on which rounding faults and false bounds show.
///
/// Coefficients and corners fill the mantissa, because on round numbers nothing is rounded; half of the sides are
/// points, because on wide boxes overestimation hides a missing rounding; many boxes are centred at zero, because
/// there the terms take both signs; points are mostly corners, because the extremes are there.
template <std::size_t D>
Bounder_case<D> random_case(Random& random)
{
  Bounder_case<D> result;
  const long degree = random.integer(0, D == 1 ? 9 : D == 2 ? 6 : 4);
  std::vector<typename Polynomial<Rational, D>::Term> terms;
  for (long n = random.integer(1, 8); n > 0; --n) {
    Exponents<D> exponents;
    for (auto& e : exponents) e = static_cast<std::uint16_t>(random.integer(0, degree));
    terms.push_back({exponents, random.chance(12) ? random.trouble() : random.full_mantissa()});
  }
  result.f = collect<Rational, D>(std::move(terms));
  const bool has_points = random.chance(2);
  for (auto& side : result.box) {
    const Rational centre = random.chance(3) ? Rational(0) : random.full_mantissa();
    Rational radius = abs(random.full_mantissa()) / (Integer(1) << static_cast<unsigned>(random.integer(0, 12)));
    if (random.chance(4)) radius /= Integer(1) << 40;
    if (has_points && !random.chance(4)) radius = 0;
    side = Rational_interval(Rational(centre - radius), Rational(centre + radius));
  }
  for (int i = 0; i < Bounder_case<D>::points; ++i) {
    std::array<Rational, D> point;
    for (std::size_t axis = 0; axis < D; ++axis) {
      const auto& side = result.box[axis];
      const long position = random.chance(3) ? random.integer(0, 1000) : random.chance(2) ? 0 : 1000;
      point[axis] = side.lower() + (side.upper() - side.lower()) * position / 1000;
    }
    const Rational value = evaluate(result.f, point);
    if (i == 0 || value < result.least) result.least = value;
    if (i == 0 || value > result.greatest) result.greatest = value;
  }
  return result;
}

/// "" if the bound of `B` contains the values of the case, else the whole case.
template <RangeBounder B, std::size_t D>
std::string escape_in(const Bounder_case<D>& example)
{
  using I = typename B::Interval;
  const B bounder(transform<I>(example.f, [](const Rational& c) { return enclose<I>(c); }));
  const I bound = bounder.bound(enclose<I>(example.box));
  for (const Rational& value : {example.least, example.greatest})
    if (!contains(bound, value)) {
      const auto low = exact_lower(bound);
      const auto high = exact_upper(bound);
      return std::string(B::name) + " over " + std::string(Interval_traits<I>::name) + " lost a value\n  f = "
             + text_of(example.f) + "\n  X = " + text_of(example.box) + "\n  f(x) = " + to_string(value)
             + "\n  bound(X) = [" + (low ? to_string(*low) : "-inf") + ", " + (high ? to_string(*high) : "inf") + "]";
    }
  return "";
}

/// \brief The first counterexample to inclusion among random cases for any of these bounders (of the same number
/// type and dimension), or "" if none was found. Every case makes `Bounder_case::points` exact checks of each bounder.
template <RangeBounder First, RangeBounder... Others>
std::string find_escape(std::uint64_t seed, int cases)
{
  const Arithmetic_scope<typename First::Interval> scope;
  Random random(seed);
  for (int i = 0; i < cases; ++i) {
    const auto example = random_case<First::dimension>(random);
    std::string escape = escape_in<First>(example);
    (void)((escape.empty() && (escape = escape_in<Others>(example)).empty()) && ...);
    if (!escape.empty()) return escape + "\n  (seed " + std::to_string(seed) + ", case " + std::to_string(i) + ")";
  }
  return "";
}

} // namespace corral::test

#endif
