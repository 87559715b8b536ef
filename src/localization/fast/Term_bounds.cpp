// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Term_bounds.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace corral::fast {
namespace {

constexpr double covers_sum = 1 + 0x1p-30; // of a few terms of one sign

double magnitude(const Outward_interval& x) { return std::max(std::abs(x.lower()), std::abs(x.upper())); }

/// The range of x^exponent between two points that have these powers.
Outward_interval between(const Outward_interval& lower, const Outward_interval& upper, unsigned exponent, bool has_zero)
{
  const auto both = hull(lower, upper);
  return has_zero && exponent > 0 && exponent % 2 == 0 ? hull_with_zero(both) : both;
}

} // namespace

template <std::size_t D>
bool Low_form<D>::excludes_zero() const
{
  return std::abs(coefficients.front()) > (spread * covers_sum + remainder) * covers_sum;
}

template <std::size_t D>
bool Low_form<D>::is_clear() const
{
  constexpr double share = 0.25;
  return norm > 0x1p-900 && norm < 0x1p900 && remainder <= share * gradient * width;
}

template <std::size_t D>
Seed<D> Low_form<D>::seed(const Cell<D>& corner, const Rounding& rounding) const
{
  const double unit = std::ldexp(1.0, -std::ilogb(norm) - 1);
  Seed<D> seed; // of no known quantum
  // What falls among the subnormals errs by less than 2^-1074 a coefficient, which `underflow` covers.
  seed.remainder = (remainder * unit + rounding.underflow) * rounding.step;
  seed.norm = norm * unit;
  seed.corner = corner;
  for (const double c : coefficients) seed.coefficients.push_back(c * unit);
  return seed;
}

template <std::size_t D>
auto Term_bounds<D>::corner_of(const Node& node) -> Place
{
  Place place;
  for (std::size_t axis = 0; axis < D; ++axis) place[axis] = 2 * std::uint64_t{node.corner[axis]};
  return place;
}

template <std::size_t D>
auto Term_bounds<D>::coordinate(std::size_t axis, std::uint64_t half_cells) const -> Interval
{
  return lines_.origin[axis] + lines_.step[axis] * Interval(0.5 * static_cast<double>(half_cells));
}

template <std::size_t D>
auto Term_bounds<D>::on_line(std::size_t axis, std::uint64_t half_cells) -> const Powers&
{
  Powers& result = known_[axis][half_cells];
  if (!result.empty()) return result;
  const Interval x = coordinate(axis, half_cells);
  unsigned before = 0;
  Interval power_before(1);
  for (const unsigned exponent : form_.powers(axis)) {
    if (exponent > before) power_before *= power(x, exponent - before);
    before = exponent;
    result.push_back(power_before);
  }
  return result;
}

template <std::size_t D>
void Term_bounds<D>::enter_box(const Place& corner, const Place& size)
{
  for (std::size_t axis = 0; axis < D; ++axis) {
    const std::uint64_t first = corner[axis];
    const std::uint64_t last = first + size[axis];
    const Powers& lower = on_line(axis, first);
    const Powers& upper = on_line(axis, last); // does not move `lower`
    const bool has_zero = coordinate(axis, first).lower() <= 0 && coordinate(axis, last).upper() >= 0;
    const auto& exponents = form_.powers(axis);
    box_[axis].resize(exponents.size());
    for (std::size_t k = 0; k < exponents.size(); ++k)
      box_[axis][k] = between(lower[k], upper[k], exponents[k], has_zero);
  }
}

template <std::size_t D>
void Term_bounds<D>::enter_box(const Node& node)
{
  Place size;
  for (std::size_t axis = 0; axis < D; ++axis) size[axis] = 2 * std::uint64_t{tree_.span(node.level, axis)};
  enter_box(corner_of(node), size);
}

template <std::size_t D>
auto Term_bounds<D>::sum(const Terms& terms, const std::array<const Powers*, D>& powers) -> Interval
{
  Interval sum(0);
  for (const auto& term : terms) {
    Interval product = term.coefficient;
    for (std::size_t axis = 0; axis < D; ++axis)
      if (const auto k = term.power[axis]; k > 0) product *= (*powers[axis])[k];
    sum += product;
  }
  return sum;
}

template <std::size_t D>
auto Term_bounds<D>::over_box(const Terms& terms) const -> Interval
{
  std::array<const Powers*, D> powers;
  for (std::size_t axis = 0; axis < D; ++axis) powers[axis] = &box_[axis];
  return sum(terms, powers);
}

template <std::size_t D>
auto Term_bounds<D>::at(const Terms& terms, const Place& place) -> Interval
{
  std::array<const Powers*, D> powers;
  for (std::size_t axis = 0; axis < D; ++axis) powers[axis] = &on_line(axis, place[axis]);
  return sum(terms, powers);
}

template <std::size_t D>
bool Term_bounds<D>::box_excludes_zero() const
{
  const Interval value = over_box(form_.low().front().terms);
  return value.lower() > 0 || value.upper() < 0;
}

template <std::size_t D>
bool Term_bounds<D>::excludes_zero(const Node& node)
{
  enter_box(node);
  return box_excludes_zero();
}

template <std::size_t D>
bool Term_bounds<D>::excludes_zero_in_pieces(const Cell<D>& cell)
{
  Place half;
  half.fill(1);
  for (unsigned piece = 0; piece < 1U << D; ++piece) {
    Place corner = corner_of({0, cell});
    for (std::size_t axis = 0; axis < D; ++axis) corner[axis] += piece >> axis & 1;
    enter_box(corner, half);
    if (!box_excludes_zero()) return false;
  }
  return true;
}

template <std::size_t D>
bool Term_bounds<D>::changes_sign(const Cell<D>& cell)
{
  bool positive = false; // or zero
  bool negative = false;
  for (unsigned corner = 0; corner < 1U << D && !(positive && negative); ++corner) {
    Place place = corner_of({0, cell});
    for (std::size_t axis = 0; axis < D; ++axis) place[axis] += 2 * (corner >> axis & 1);
    const Interval value = at(form_.low().front().terms, place);
    positive = positive || value.lower() >= 0;
    negative = negative || value.upper() <= 0;
  }
  return positive && negative;
}

/// The power product of the half sides of a node.
template <std::size_t D>
auto Term_bounds<D>::half_sides(const Exponents<D>& exponents, const Node& node) const -> Interval
{
  Interval product(1);
  for (std::size_t axis = 0; axis < D; ++axis)
    for (unsigned k = 0; k < exponents[axis]; ++k)
      product *= lines_.step[axis] * Interval(0.5 * tree_.span(node.level, axis));
  return product;
}

template <std::size_t D>
Low_form<D> Term_bounds<D>::low_form(const Node& node)
{
  enter_box(node);
  Place centre = corner_of(node);
  for (std::size_t axis = 0; axis < D; ++axis) centre[axis] += tree_.span(node.level, axis);
  Interval remainder(0);
  for (const auto& next : form_.next())
    remainder += Interval(magnitude(over_box(next.terms) * half_sides(next.orders, node)));
  Low_form<D> form;
  form.width = std::ldexp(1.0, -static_cast<int>(node.level));
  for (const auto& low : form_.low()) {
    const Interval value = at(low.terms, centre) * half_sides(low.orders, node);
    const double middle = 0.5 * value.lower() + 0.5 * value.upper();
    remainder += Interval(magnitude(value - Interval(middle)));
    form.coefficients.push_back(middle);
    form.norm += std::abs(middle);
    const unsigned degree = std::accumulate(low.orders.begin(), low.orders.end(), 0U);
    if (degree == 0) continue;
    form.gradient += degree == 1 ? std::abs(middle) : -static_cast<double>(degree) * std::abs(middle);
    const bool is_even = std::all_of(low.orders.begin(), low.orders.end(), [](auto e) { return e % 2 == 0; });
    const bool helps = std::signbit(middle) == std::signbit(form.coefficients.front());
    if (!is_even || !helps) form.spread += std::abs(middle);
  }
  form.norm *= covers_sum;
  form.remainder = remainder.upper();
  return form;
}

template struct Low_form<2>;
template struct Low_form<3>;
template class Term_bounds<2>;
template class Term_bounds<3>;

} // namespace corral::fast
