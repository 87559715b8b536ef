// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Bernstein_form.h"

#include <corral/algebra/exact_range.h>
#include <corral/errors.h>
#include <corral/internal/polynomial/integer_form.h>
#include <corral/polynomial/substitution.h>

#include <algorithm>
#include <queue>
#include <string>
#include <utility>
#include <vector>

namespace corral {

namespace {

using exact::Bernstein_form;

constexpr std::size_t max_parts = 200000;

/// A part of the box with the greatest Bernstein coefficient, as a true value of the polynomial's scale.
template <std::size_t D>
struct Part
{
  Bernstein_form<D> form;
  Rational scale; ///< value = coefficient * scale
  Rational bound;
  std::size_t next_axis = 0;
  friend bool operator<(const Part& a, const Part& b) { return a.bound < b.bound; }
};

template <std::size_t D>
Rational highest_corner(const Part<D>& part)
{
  Integer highest = part.form.corner(0);
  for (unsigned corner = 1; corner < 1U << D; ++corner) highest = std::max(highest, part.form.corner(corner));
  return highest * part.scale;
}

template <std::size_t D>
void bound(Part<D>& part)
{
  part.bound = *std::max_element(part.form.values.begin(), part.form.values.end()) * part.scale;
}

/// A value that is taken and one that is not exceeded, at most `tolerance` apart.
template <std::size_t D>
std::pair<Rational, Rational> maximum(Part<D> whole, const Rational& tolerance, const Checkpoint& checkpoint)
{
  std::priority_queue<Part<D>> parts;
  Rational best = highest_corner(whole);
  bound(whole);
  parts.push(std::move(whole));
  for (std::size_t made = 0; parts.top().bound > best + tolerance; ++made) {
    if (checkpoint) checkpoint();
    if (made > max_parts)
      throw Budget_exceeded("exact range: more than " + std::to_string(max_parts)
                            + " parts of the box; expected fewer, or a larger tolerance");
    Part<D> upper = parts.top();
    parts.pop();
    while (upper.form.size[upper.next_axis] == 1) upper.next_axis = (upper.next_axis + 1) % D;
    const std::size_t axis = upper.next_axis;
    upper.next_axis = (axis + 1) % D;
    Part<D> lower = upper;
    lower.form = exact::halve_exactly(upper.form, axis);
    mpq_div_2exp(upper.scale.get_mpq_t(), upper.scale.get_mpq_t(), upper.form.size[axis] - 1);
    lower.scale = upper.scale;
    for (auto* part : {&lower, &upper}) {
      best = std::max(best, highest_corner(*part));
      bound(*part);
    }
    for (auto* part : {&lower, &upper})
      if (part->bound > best) parts.push(std::move(*part));
    if (parts.empty()) return {best, best};
  }
  return {best, std::max(best, parts.top().bound)};
}

/// f on the box as Bernstein coefficients on [0,1]^D.
template <std::size_t D>
Part<D> whole_box(const Polynomial<Rational, D>& f, const Rational_box<D>& box)
{
  std::array<Rational, D> offset;
  std::array<Rational, D> scale;
  for (std::size_t k = 0; k < D; ++k) {
    offset[k] = box[k].lower();
    scale[k] = box[k].upper() - box[k].lower();
  }
  const auto local = integer_form(affine_substitution(f, offset, scale));
  Part<D> part{exact::to_bernstein(exact::power_form(local.numerator)), 1, {}, 0};
  Integer factor = local.denominator;
  for (const std::size_t size : part.form.size) factor *= exact::bernstein_weights(size - 1).front();
  part.scale /= factor;
  return part;
}

/// The extreme values of p on an interval: at its ends and at the roots of the derivative.
Range_enclosure univariate_range(const Polynomial<Rational, 1>& f, const Rational_interval& side,
                                 const Rational& tolerance, const Checkpoint& checkpoint)
{
  const auto p = integer_polynomial(f);
  const Rational scale = Rational(1) / integer_form(f).denominator;
  const Rational a = evaluate(p, side.lower());
  const Rational b = evaluate(p, side.upper());
  Range_enclosure range{{std::min(a, b), std::max(a, b)}, {std::min(a, b), std::max(a, b)}};
  if (const auto slope = derivative(p); !slope.is_zero())
    for (auto& root : isolate_real_roots(slope, side, checkpoint)) {
      while (true) {
        const auto value = evaluate(p, root.interval());
        if ((value.upper() - value.lower()) * scale <= tolerance) {
          const Rational inside = evaluate(p, root.lower());
          range.inner = {std::min(range.inner.lower(), inside), std::max(range.inner.upper(), inside)};
          range.outer = {std::min(range.outer.lower(), value.lower()), std::max(range.outer.upper(), value.upper())};
          break;
        }
        root.refine();
      }
    }
  const auto scaled = [&](const Rational_interval& x) {
    return Rational_interval(x.lower() * scale, x.upper() * scale);
  };
  return {scaled(range.inner), scaled(range.outer)};
}

} // namespace

template <std::size_t D>
Range_enclosure exact_range(const Polynomial<Rational, D>& f, const Rational_box<D>& box, const Rational& tolerance,
                            const Run_options& run)
{
  const Checkpoint checkpoint = checkpoint_of(run, "exact range");
  if (tolerance <= 0)
    throw Invalid_input("exact range: the tolerance is " + to_string(tolerance) + "; expected a positive number");
  if constexpr (D == 1)
    return univariate_range(f, box[0], tolerance, checkpoint);
  else {
    auto part = whole_box(f, box);
    const auto [high, high_bound] = maximum(part, tolerance, checkpoint);
    for (Integer& c : part.form.values) c = -c;
    const auto [low, low_bound] = maximum(std::move(part), tolerance, checkpoint);
    return {{Rational(-low), high}, {Rational(-low_bound), high_bound}};
  }
}

template Range_enclosure exact_range(const Polynomial<Rational, 1>&, const Rational_box<1>&, const Rational&,
                                     const Run_options&);
template Range_enclosure exact_range(const Polynomial<Rational, 2>&, const Rational_box<2>&, const Rational&,
                                     const Run_options&);
template Range_enclosure exact_range(const Polynomial<Rational, 3>&, const Rational_box<3>&, const Rational&,
                                     const Run_options&);

} // namespace corral
