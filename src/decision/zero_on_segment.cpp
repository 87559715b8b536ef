// SPDX-License-Identifier: LGPL-3.0-or-later
#include "zero_on_segment.h"

#include "../polynomial/to_exponent.h"

#include <corral/algebra/real_roots.h>
#include <corral/polynomial/arithmetic.h>

#include <algorithm>
#include <array>
#include <utility>

namespace corral::exact {

namespace {

/// The line x_k = offset_k + slope_k x_axis through two points that differ in x_axis.
template <std::size_t D>
struct Line
{
  std::size_t axis;
  std::array<Rational, D> offset;
  std::array<Rational, D> slope;

  Line(std::size_t main, const Sign_change<D>& ends) : axis(main)
  {
    for (std::size_t k = 0; k < D; ++k) {
      slope[k] = (ends.second[k] - ends.first[k]) / (ends.second[axis] - ends.first[axis]);
      offset[k] = ends.first[k] - slope[k] * ends.first[axis];
    }
  }
  [[nodiscard]] Rational at(std::size_t k, const Rational& x) const { return offset[k] + slope[k] * x; }
};

template <std::size_t D>
Integer_polynomial on_line(const Polynomial<Integer, D>& h, const Line<D>& line)
{
  auto sum = constant<Rational, 1>(0);
  for (const auto& term : h.terms()) {
    auto product = constant<Rational, 1>(term.coefficient);
    for (std::size_t k = 0; k < D; ++k)
      product = product
                * power(constant<Rational, 1>(line.offset[k])
                            + constant<Rational, 1>(line.slope[k]) * variable<Rational, 1>(0),
                        term.exponents[k]);
    sum = sum + product;
  }
  return integer_polynomial(sum);
}

template <std::size_t D>
Polynomial<Rational, D> monic(const Integer_polynomial& p, std::size_t axis)
{
  std::vector<typename Polynomial<Rational, D>::Term> terms;
  for (std::size_t i = 0; i < p.size(); ++i) {
    Exponents<D> exponents{};
    exponents[axis] = detail::to_exponent(i);
    terms.push_back({exponents, Rational(p[i]) / p.lead()});
  }
  return collect<Rational, D>(std::move(terms));
}

/// Between the end of a side and the value there.
Rational_interval widened(const Rational& a, const Rational& b, const Rational& first, const Rational& second)
{
  return {(std::min(a, b) + std::min(first, second)) / 2, (std::max(a, b) + std::max(first, second)) / 2};
}

} // namespace

template <std::size_t D>
Witness<D> zero_on_segment(const Polynomial<Integer, D>& h, const Sign_change<D>& change)
{
  std::size_t axis = 0;
  while (change.first[axis] == change.second[axis]) ++axis;
  const Line<D> line(axis, change);
  const auto [low, high] = std::minmax(change.first[axis], change.second[axis]);
  auto root = isolate_real_roots(on_line(h, line), {low, high}).front();
  while (!root.is_point() && (root.lower() == low || root.upper() == high)) root.refine();
  if (root.is_point()) {
    Rational_point<D> point;
    for (std::size_t k = 0; k < D; ++k) point[k] = line.at(k, root.lower());
    return Sign_change<D>{point, point};
  }
  Triangular_zero<D> zero;
  zero.order[0] = axis;
  zero.chain[0] = monic<D>(root.polynomial(), axis);
  zero.box[axis] = root.interval();
  for (std::size_t k = 0, next = 1; k < D; ++k) {
    if (k == axis) continue;
    zero.order[next] = k;
    zero.chain[next++] = variable<Rational, D>(k) - constant<Rational, D>(line.offset[k])
                         - constant<Rational, D>(line.slope[k]) * variable<Rational, D>(axis);
    // Strictly inside the segment's side, so that the element has a strict sign at both ends of its own.
    zero.box[k] = widened(line.at(k, root.lower()), line.at(k, root.upper()), change.first[k], change.second[k]);
  }
  return zero;
}

template Witness<2> zero_on_segment(const Polynomial<Integer, 2>&, const Sign_change<2>&);
template Witness<3> zero_on_segment(const Polynomial<Integer, 3>&, const Sign_change<3>&);

} // namespace corral::exact
