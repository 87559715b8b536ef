// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Singular_points.h"

#include "Side_zeros.h"

#include "../algebra/multivariate.h"
#include "../algebra/restriction.h"

#include <corral/errors.h>
#include <corral/number/Double_bracket.h>
#include <corral/polynomial/arithmetic.h>

#include <algorithm>
#include <utility>

namespace corral::geometry {

namespace {

/// The derivative along the lines x + shear * y = const.
Polynomial<Integer, 2> slope_along(const Polynomial<Integer, 2>& f, long shear)
{
  return derivative(f, 1) - Integer(shear) * derivative(f, 0);
}

void append(std::vector<exact::Projected_zero>& zeros, std::vector<exact::Projected_zero> more)
{
  for (auto& zero : more)
    if (std::none_of(zeros.begin(), zeros.end(), [&](auto& known) { return known.equals(zero); }))
      zeros.push_back(std::move(zero));
}

/// The singular points of the product of distinct irreducible polynomials, in one direction.
std::optional<exact::Projection_result> singular_zeros(const std::vector<Polynomial<Integer, 2>>& factors,
                                                       const Rational_box<2>& box, long shear,
                                                       const Checkpoint& checkpoint)
{
  exact::Projection_result all;
  const auto add = [&](std::optional<exact::Projection_result> more) {
    if (!more) return false;
    append(all.zeros, std::move(more->zeros));
    all.factors.insert(all.factors.end(), more->factors.begin(), more->factors.end());
    return true;
  };
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const auto& f = factors[i];
    if (f.total_degree() > 1) {
      auto own = exact::projected_zeros(f, slope_along(f, shear), shear, box, 2, checkpoint);
      if (own) std::erase_if(own->zeros, [](const auto& zero) { return zero.multiplicity() <= zero.fibre_degree(); });
      if (!add(std::move(own))) return std::nullopt;
    }
    for (std::size_t j = 0; j < i; ++j)
      if (!add(exact::projected_zeros(f, factors[j], shear, box, 1, checkpoint))) return std::nullopt;
  }
  return all;
}

/// The interval of doubles around the image of the part of x in a side, in [0, 1]; an exact 0 or 1 stays.
Range unit_range(const Rational_interval& x, const Rational_interval& side)
{
  const Rational width = side.upper() - side.lower();
  return {std::max(0.0, bracket((x.lower() - side.lower()) / width).below),
          std::min(1.0, bracket((x.upper() - side.lower()) / width).above)};
}

} // namespace

Singular_points::Singular_points(Polynomial<Integer, 2> f, Rational_box<2> box, Checkpoint checkpoint)
    : f_(std::move(f)), box_(std::move(box)), checkpoint_(std::move(checkpoint))
{}

std::array<Range, 2> Singular_points::to_unit(const Rational_box<2>& box) const
{
  return {unit_range(box[0], box_[0]), unit_range(box[1], box_[1])};
}

bool Singular_points::is_known(const Rational_point<2>& point) const
{
  return std::any_of(points_.begin(), points_.end(), [&](const Point& known) {
    return !known.zero && known.box[0].lower() == point[0] && known.box[1].lower() == point[1];
  });
}

bool Singular_points::guess(const std::array<Range, 2>& part)
{
  Rational_point<2> point;
  for (std::size_t k = 0; k < 2; ++k) {
    const Rational width = box_[k].upper() - box_[k].lower();
    point[k] = simplest_rational(
        {box_[k].lower() + width * Rational(part[k].low), box_[k].lower() + width * Rational(part[k].high)});
  }
  if (is_known(point) || !exact::vanishes_at(f_, point) || !exact::vanishes_at(derivative(f_, 0), point)
      || !exact::vanishes_at(derivative(f_, 1), point))
    return false;
  const Rational_box<2> box{Rational_interval(point[0]), Rational_interval(point[1])};
  points_.push_back({box, to_unit(box), std::nullopt});
  return true;
}

void Singular_points::complete()
{
  if (complete_) return;
  const auto factors = exact::irreducible_factors(f_);
  std::optional<exact::Projection_result> found;
  for (const long shear : exact::shears) {
    shear_ = shear;
    if ((found = singular_zeros(factors, box_, shear, checkpoint_))) break;
  }
  if (!found) throw Budget_exceeded("mesh_curve: no direction tells the singular points apart");
  for (auto& zero : found->zeros) {
    const auto known = std::find_if(points_.begin(), points_.end(), [&](const Point& p) {
      return !p.zero && zero.equals(Rational_point<2>{p.box[0].lower(), p.box[1].lower()});
    });
    if (known != points_.end()) {
      known->zero = std::move(zero);
      continue;
    }
    Point point{{}, {}, std::move(zero)};
    refine(point);
    points_.push_back(std::move(point));
  }
  critical_polynomials_ = std::move(found->factors);
  complete_ = true;
}

/// A box that doubles hardly tell from the point, exact where it can be.
void Singular_points::refine(Point& point) const
{
  if (const auto exact = point.zero->rational())
    point.box = {Rational_interval((*exact)[0]), Rational_interval((*exact)[1])};
  else {
    const Rational shortest = std::min(box_[0].upper() - box_[0].lower(), box_[1].upper() - box_[1].lower());
    point.box = point.zero->box(shortest / Rational(Integer(Integer(1) << 56)));
    for (std::size_t k = 0; k < 2; ++k)
      for (const Rational& end : {box_[k].lower(), box_[k].upper()})
        if (contains(point.box[k], end) && point.zero->sign_of_linear(k == 0 ? 1 : 0, k == 0 ? 0 : 1, -end) == 0)
          point.box[k] = Rational_interval(end);
  }
  point.unit_box = to_unit(point.box);
}

Rational_interval Singular_points::from_unit(const Range& range, std::size_t axis) const
{
  const Rational width = box_[axis].upper() - box_[axis].lower();
  return {box_[axis].lower() + width * Rational(range.low), box_[axis].lower() + width * Rational(range.high)};
}

void Singular_points::isolate_critical_values()
{
  critical_values_.emplace();
  const auto range = box_[0] + Rational_interval(Rational(shear_)) * box_[1];
  for (const auto& p : critical_polynomials_)
    for (auto& root : isolate_simple_roots(p, range, checkpoint_)) critical_values_->push_back(std::move(root));
}

bool Singular_points::is_regular(const std::array<Range, 2>& part, std::optional<std::size_t> but)
{
  if (!critical_values_) isolate_critical_values();
  const auto range = from_unit(part[0], 0) + Rational_interval(Rational(shear_)) * from_unit(part[1], 1);
  for (auto& value : *critical_values_) {
    if (value.upper() < range.lower() || value.lower() > range.upper()) continue;
    if (value.compare(range.lower()) < 0 || value.compare(range.upper()) > 0) continue;
    if (!but || !exact::same(value, points_[*but].zero->u())) return false;
  }
  return true;
}

unsigned Singular_points::order_along(std::size_t index)
{
  Point& point = points_[index];
  if (point.order > 0) return point.order;
  auto f = slope_along(f_, shear_);
  for (point.order = 2;; ++point.order) {
    f = slope_along(f, shear_);
    if (point.is_rational() ? !exact::vanishes_at(f, {point.box[0].lower(), point.box[1].lower()})
                            : point.zero->sign_of(f) != 0)
      return point.order;
  }
}

std::vector<std::size_t> Singular_points::in(const std::array<Range, 2>& part)
{
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    bool inside = true;
    for (std::size_t k = 0; k < 2; ++k) {
      const Range& p = points_[i].unit_box[k];
      if (p.high < part[k].low || p.low > part[k].high) {
        inside = false;
        break;
      }
      const auto straddles = [&](double line) { return line > 0 && line < 1 && p.low <= line && line <= p.high; };
      if (straddles(part[k].low) || straddles(part[k].high)) throw Not_generic{};
    }
    if (inside) result.push_back(i);
  }
  return result;
}

} // namespace corral::geometry
