// SPDX-License-Identifier: LGPL-3.0-or-later
#include "fault_harness.h"

#include <corral/bounders/Affine_bounder.h>
#include <corral/bounders/Mean_value_bounder.h>
#include <corral/bounders/Natural_bounder.h>
#include <corral/number/Double_bracket.h>
#include <corral/polynomial/evaluate.h>
#include <corral/polynomial/substitution.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

namespace corral::audit {
namespace {

using Exact = Rational_interval;
using Point = std::array<Rational, 2>;

Polynomial<Exact, 2> over_points(const Exact_polynomial& f)
{
  return transform<Exact>(f, [](const Rational& c) { return Exact(c); });
}

Point centre_of(const Exact_box& box)
{
  return {Rational((box[0].lower() + box[0].upper()) / 2), Rational((box[1].lower() + box[1].upper()) / 2)};
}

Exact values_at_corners(const Exact_polynomial& f, const Exact_box& box)
{
  std::optional<Exact> values;
  for (const Rational& x : {box[0].lower(), box[0].upper()})
    for (const Rational& y : {box[1].lower(), box[1].upper()}) {
      const Exact value(evaluate(f, Point{x, y}));
      values = values ? hull(*values, value) : value;
    }
  return *values;
}

struct Corners_only
{
  static constexpr std::string_view name = "corners_only";
  static constexpr std::string_view description = "only the values at the corners are looked at";
  explicit Corners_only(const Exact_polynomial& given) : f(given) {}
  [[nodiscard]] Exact bound(const Exact_box& box) const { return values_at_corners(f, box); }
  Exact_polynomial f;
};

/// \brief Recursive Taylor expansion of order 2. A fault derives from this and replaces a rule. The control: nothing
/// may be caught.
struct Sound_rules
{
  static constexpr std::string_view name = "no_fault_rt";
  static constexpr std::string_view description = "recursive Taylor expansion of order 2 as it is";

  /// Whether the corners have the least and the greatest value.
  static bool is_decided_by_corners(const Exact_polynomial& f) { return f.total_degree() <= 1; }
  /// The factor of the second derivative.
  static Rational weight(bool is_mixed) { return is_mixed ? 1 : Rational(1, 2); }
  static Exact_box region_of_remainder(const Exact_box& box) { return box; }
};

template <class Rules>
Exact recursive_taylor(const Exact_polynomial& f, const Exact_box& box)
{
  if (Rules::is_decided_by_corners(f)) return values_at_corners(f, box);
  const Point centre = centre_of(box);
  const Point radius = {Rational(box[0].upper() - centre[0]), Rational(box[1].upper() - centre[1])};
  Exact sum(evaluate(f, centre));
  for (std::size_t i = 0; i < 2; ++i) {
    const auto first = derivative(f, i);
    sum += Exact(-1, 1) * Exact(Rational(evaluate(first, centre) * radius[i]));
    for (std::size_t j = i; j < 2; ++j) {
      const Exact second = recursive_taylor<Rules>(derivative(first, j), Rules::region_of_remainder(box));
      const Rational factor = radius[i] * radius[j] * Rules::weight(i != j);
      sum += (i == j ? Exact(0, 1) : Exact(-1, 1)) * (second * Exact(factor));
    }
  }
  return sum;
}

template <class Rules>
struct Recursive_bounder
{
  static constexpr std::string_view name = Rules::name;
  static constexpr std::string_view description = Rules::description;
  explicit Recursive_bounder(const Exact_polynomial& given) : f(given) {}
  [[nodiscard]] Exact bound(const Exact_box& box) const { return recursive_taylor<Rules>(f, box); }
  Exact_polynomial f;
};

struct Early_stop : Sound_rules
{
  static constexpr std::string_view name = "early_stop";
  static constexpr std::string_view description = "the recursion stops at degree 1 in y, as for y + 4x^2 - 1";
  static bool is_decided_by_corners(const Exact_polynomial& f) { return f.degree(1) <= 1; }
};

struct Remainder_at_the_midpoint : Sound_rules
{
  static constexpr std::string_view name = "remainder_at_midpoint";
  static constexpr std::string_view description = "second derivatives are taken at the midpoint and not bounded";
  static Exact_box region_of_remainder(const Exact_box& box)
  {
    const Point centre = centre_of(box);
    return {Exact(centre[0]), Exact(centre[1])};
  }
};

struct Mixed_halved : Sound_rules
{
  static constexpr std::string_view name = "mixed_halved";
  static constexpr std::string_view description = "the mixed second derivative is counted once and halved";
  static Rational weight(bool) { return {1, 2}; }
};

struct Mixed_second_dropped : Sound_rules
{
  static constexpr std::string_view name = "mixed_second_dropped";
  static constexpr std::string_view description = "the mixed second derivative is dropped";
  static Rational weight(bool is_mixed) { return is_mixed ? 0 : Rational(1, 2); }
};

/// a + b e_x + c e_y with e in [-1, 1], whose product forgets the terms of second order.
struct Lossy_affine
{
  Lossy_affine(const Rational& value = 0) : centre(value) {}
  template <MachineNumber T>
  Lossy_affine(T value) : centre(value)
  {}
  Lossy_affine& operator+=(const Lossy_affine& b)
  {
    centre += b.centre;
    for (std::size_t i = 0; i < 2; ++i) slope[i] += b.slope[i];
    return *this;
  }
  friend Lossy_affine operator*(const Lossy_affine& a, const Lossy_affine& b)
  {
    Lossy_affine product(Rational(a.centre * b.centre));
    for (std::size_t i = 0; i < 2; ++i) product.slope[i] = a.centre * b.slope[i] + b.centre * a.slope[i];
    return product;
  }
  Lossy_affine& operator*=(const Lossy_affine& b) { return *this = *this * b; }

  Rational centre;
  Point slope{};
};

struct Affine_error_lost
{
  static constexpr std::string_view name = "affine_error_lost";
  static constexpr std::string_view description = "the product of affine forms has no error term";
  explicit Affine_error_lost(const Exact_polynomial& given)
      : f(transform<Lossy_affine>(given, [](const Rational& c) { return Lossy_affine(c); }))
  {}
  [[nodiscard]] Exact bound(const Exact_box& box) const
  {
    const Point centre = centre_of(box);
    std::array<Lossy_affine, 2> point{centre[0], centre[1]};
    for (std::size_t i = 0; i < 2; ++i) point[i].slope[i] = box[i].upper() - centre[i];
    const auto value = evaluate(f, point);
    const Rational spread = abs(value.slope[0]) + abs(value.slope[1]);
    return {Rational(value.centre - spread), Rational(value.centre + spread)};
  }
  Polynomial<Lossy_affine, 2> f;
};

struct Derivative_at_the_midpoint
{
  static constexpr std::string_view name = "derivative_at_midpoint";
  static constexpr std::string_view description = "the mean-value form with the derivatives at the midpoint only";
  explicit Derivative_at_the_midpoint(const Exact_polynomial& given) : f(given) {}
  [[nodiscard]] Exact bound(const Exact_box& box) const
  {
    const Point centre = centre_of(box);
    Exact sum(evaluate(f, centre));
    for (std::size_t i = 0; i < 2; ++i) sum += Exact(evaluate(derivative(f, i), centre)) * (box[i] - Exact(centre[i]));
    return sum;
  }
  Exact_polynomial f;
};

struct Powers_by_their_ends
{
  static constexpr std::string_view name = "powers_by_their_ends";
  static constexpr std::string_view description =
      "the range of every power is taken from its ends, so that x^2 loses zero";
  explicit Powers_by_their_ends(const Exact_polynomial& given) : f(given) {}
  [[nodiscard]] Exact bound(const Exact_box& box) const
  {
    Exact sum(0);
    for (const auto& [k, c] : f.terms()) {
      Exact product(c);
      for (std::size_t i = 0; i < 2; ++i)
        if (k[i] > 0) product *= hull(power(lower(box[i]), k[i]), power(upper(box[i]), k[i]));
      sum += product;
    }
    return sum;
  }
  Exact_polynomial f;
};

/// \brief Horner's rule in x on doubles where each a*b+c is rounded once. Beyond the range of doubles, and where the
/// box is no point, it is sound.
struct Contraction
{
  static constexpr std::string_view name = "contraction";
  static constexpr std::string_view description =
      "a*b+c is rounded once, to nearest, and the step outward that belongs to the product is lost with it";
  explicit Contraction(const Exact_polynomial& given) : f(given) {}
  [[nodiscard]] Exact bound(const Exact_box& box) const
  {
    const Exact sound = Natural_bounder<Exact, 2>(over_points(f)).bound(box);
    const auto x = as_double(box[0]);
    const auto y = as_double(box[1]);
    if (!x || !y) return sound;
    double sum = 0;
    for (unsigned k = f.degree(0) + 1; k-- > 0;) {
      double inner = 0;
      for (unsigned j = f.degree(1) + 1; j-- > 0;) {
        const auto c = as_double(Exact(coefficient(k, j)));
        if (!c) return sound;
        inner = std::fma(inner, *y, *c);
      }
      sum = std::fma(sum, *x, inner);
    }
    return std::isfinite(sum) ? Exact(Rational(sum)) : sound;
  }

private:
  static std::optional<double> as_double(const Exact& x)
  {
    const auto doubles = bracket(x.lower());
    const bool is_double = x.lower() == x.upper() && doubles.below == doubles.above;
    return is_double ? std::optional(doubles.below) : std::nullopt;
  }
  [[nodiscard]] Rational coefficient(unsigned k, unsigned j) const
  {
    const auto it = std::find_if(f.terms().begin(), f.terms().end(),
                                 [&](const auto& term) { return term.exponents[0] == k && term.exponents[1] == j; });
    return it == f.terms().end() ? Rational(0) : it->coefficient;
  }
  Exact_polynomial f;
};

/// The library's own methods, from which the others here were made.
template <class Method>
struct Sound_method
{
  static constexpr std::string_view name = Method::name;
  static constexpr std::string_view description = "the method of the library as it is";
  explicit Sound_method(const Exact_polynomial& f) : method(over_points(f)) {}
  [[nodiscard]] Exact bound(const Exact_box& box) const { return method.bound(box); }
  Method method;
};

} // namespace

std::vector<Planted_bounder> method_faults()
{
  return {planted<Corners_only>(),
          planted<Recursive_bounder<Early_stop>>(),
          planted<Recursive_bounder<Remainder_at_the_midpoint>>(),
          planted<Recursive_bounder<Mixed_halved>>(),
          planted<Recursive_bounder<Mixed_second_dropped>>(),
          planted<Affine_error_lost>(),
          planted<Derivative_at_the_midpoint>(),
          planted<Powers_by_their_ends>(),
          planted<Contraction>()};
}

std::vector<Planted_bounder> sound_methods()
{
  return {planted<Recursive_bounder<Sound_rules>>(), planted<Sound_method<Affine_bounder<Exact, 2>>>(),
          planted<Sound_method<Mean_value_bounder<Exact, 2>>>(), planted<Sound_method<Natural_bounder<Exact, 2>>>()};
}

} // namespace corral::audit
