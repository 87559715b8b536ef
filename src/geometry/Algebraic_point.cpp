// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Point_representation.h"

#include <corral/internal/polynomial/integer_form.h>

#include <utility>

namespace corral {

namespace geometry {

const std::shared_ptr<const Integer_polynomial>& Plane_pair::projection(std::size_t axis)
{
  auto& result = projections_[axis];
  if (result) return result;
  const auto f = exact::bivariate(f_, 1 - axis);
  const auto g = exact::bivariate(g_, 1 - axis);
  // Where one does not depend on the other variable, it is such a polynomial itself.
  auto p = f.size() == 1 ? f[0] : g.size() == 1 ? g[0] : exact::eliminate(f, g).resultant;
  result = std::make_shared<const Integer_polynomial>(square_free_part(p));
  return result;
}

} // namespace geometry

Algebraic_point::Algebraic_point(std::shared_ptr<Representation> representation)
    : representation_(std::move(representation))
{}

const Rational_box<2>& Algebraic_point::box() const { return representation_->box; }

void Algebraic_point::refine_to(const Rational& width)
{
  auto& r = *representation_;
  if (r.box[0].upper() - r.box[0].lower() > width || r.box[1].upper() - r.box[1].lower() > width)
    r.box = r.zero.box(width);
}

unsigned Algebraic_point::multiplicity() const { return representation_->zero.multiplicity(); }

std::optional<Rational_point<2>> Algebraic_point::rational() const
{
  auto& r = *representation_;
  auto point = r.zero.rational();
  if (point) r.box = {Rational_interval((*point)[0]), Rational_interval((*point)[1])};
  return point;
}

int Algebraic_point::sign_of(const Polynomial<Rational, 2>& q) const
{
  return representation_->zero.sign_of(integer_primitive(q));
}

Real_root Algebraic_point::coordinate(std::size_t axis) const
{
  auto& r = *representation_;
  if (r.coordinates[axis]) return *r.coordinates[axis];
  const auto& p = r.pair->projection(axis);
  for (Rational width = r.box[axis].upper() - r.box[axis].lower();;) {
    const auto roots = isolate_simple_roots(p, r.box[axis]);
    if (roots.size() == 1) return *(r.coordinates[axis] = Real_root(p, roots.front().interval(), 1));
    width /= 1024;
    r.box = r.zero.box(width);
  }
}

std::strong_ordering operator<=>(const Algebraic_point& a, const Algebraic_point& b)
{
  for (const std::size_t axis : {0U, 1U}) {
    const auto& p = a.box()[axis];
    const auto& q = b.box()[axis];
    if (p.upper() < q.lower()) return std::strong_ordering::less;
    if (q.upper() < p.lower()) return std::strong_ordering::greater;
    Real_root x = a.coordinate(axis);
    Real_root y = b.coordinate(axis);
    if (exact::same(x, y)) continue;
    while (x.upper() >= y.lower() && y.upper() >= x.lower()) {
      x.refine();
      y.refine();
    }
    return x.upper() < y.lower() ? std::strong_ordering::less : std::strong_ordering::greater;
  }
  return std::strong_ordering::equal;
}

} // namespace corral
