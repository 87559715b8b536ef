// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/geometry/solve.h>

#include "Point_representation.h"

#include "../algebra/multivariate.h"

#include <corral/errors.h>
#include <corral/polynomial/arithmetic.h>
#include <corral/polynomial/square_free.h>

#include <algorithm>
#include <utility>

namespace corral {

namespace {

using Zeros = std::vector<exact::Projected_zero>;

/// The zeros along the first direction that tells them apart. \pre f and g are coprime.
Zeros common_zeros(const Polynomial<Integer, 2>& f, const Polynomial<Integer, 2>& g,
                   const std::optional<Rational_box<2>>& box, const Checkpoint& checkpoint)
{
  for (const long shear : exact::shears)
    if (auto found = exact::projected_zeros(f, g, shear, box, 1, checkpoint)) return std::move(found->zeros);
  throw Budget_exceeded("solve: " + std::to_string(exact::shears.size())
                        + " directions were tried, and none tells the zeros apart");
}

bool meet(const Rational_box<2>& a, const Rational_box<2>& b)
{
  for (std::size_t k = 0; k < 2; ++k)
    if (a[k].upper() < b[k].lower() || b[k].upper() < a[k].lower()) return false;
  return true;
}

/// Boxes that do not meet.
void isolate(std::vector<std::shared_ptr<Algebraic_point::Representation>>& points)
{
  for (auto& point : points) point->box = point->zero.box(Rational(1, 1024));
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      while (meet(points[i]->box, points[j]->box))
        for (auto& point : {points[i], points[j]}) {
          const Rational width = std::max<Rational>(point->box[0].upper() - point->box[0].lower(),
                                                    point->box[1].upper() - point->box[1].lower());
          if (width > 0) point->box = point->zero.box(width / 1024);
        }
}

std::vector<Algebraic_point> points(Zeros zeros, const Polynomial<Integer, 2>& f, const Polynomial<Integer, 2>& g)
{
  const auto pair = std::make_shared<geometry::Plane_pair>(f, g);
  std::vector<std::shared_ptr<Algebraic_point::Representation>> list;
  for (auto& zero : zeros) list.push_back(std::make_shared<Algebraic_point::Representation>(std::move(zero), pair));
  isolate(list);
  std::vector<Algebraic_point> result;
  for (auto& representation : list) {
    result.emplace_back(std::move(representation));
    (void)result.back().rational();
  }
  std::sort(result.begin(), result.end());
  return result;
}

Rational rational(const Integer& c) { return c; }

/// The least order of a partial derivative that does not vanish at a point.
unsigned order_at(const Algebraic_point& point, const Polynomial<Integer, 2>& f)
{
  std::vector<Polynomial<Rational, 2>> partials{transform<Rational>(f, rational)};
  for (unsigned order = 0;; ++order) {
    if (std::any_of(partials.begin(), partials.end(), [&](const auto& p) { return point.sign_of(p) != 0; }))
      return order;
    std::vector<Polynomial<Rational, 2>> next{derivative(partials[0], 0)};
    for (const auto& p : partials) next.push_back(derivative(p, 1));
    partials = std::move(next);
  }
}

Polynomial<Integer, 2> square_free(const Polynomial<Rational, 2>& f, const char* who)
{
  if (f.is_zero()) throw Invalid_input(std::string(who) + ": the polynomial is zero; expected one that is not");
  return square_free_part(f);
}

} // namespace

Plane_zeros solve(const Polynomial<Rational, 2>& f, const Polynomial<Rational, 2>& g,
                  const std::optional<Rational_box<2>>& box, const Run_options& run)
{
  if (f.is_zero() || g.is_zero())
    throw Invalid_input(
        "solve: a polynomial is zero, so that the zeros are those of the other one; expected two that are not");
  auto parts = exact::common_factor(integer_primitive(f), integer_primitive(g));
  auto zeros = common_zeros(parts.f, parts.g, box, checkpoint_of(run, "solve"));
  if (!parts.divisor.is_constant())
    std::erase_if(zeros, [&](exact::Projected_zero& zero) { return zero.sign_of(parts.divisor) == 0; });
  return {points(std::move(zeros), parts.f, parts.g), parts.divisor};
}

std::vector<Real_root> solve(const Polynomial<Rational, 1>& f, const std::optional<Rational_interval>& interval,
                             const Run_options& run)
{
  const auto p = integer_polynomial(f);
  return interval ? isolate_real_roots(p, *interval, checkpoint_of(run, "solve"))
                  : isolate_real_roots(p, checkpoint_of(run, "solve"));
}

std::vector<Singular_point> singular_points(const Polynomial<Rational, 2>& f, const std::optional<Rational_box<2>>& box,
                                            const Run_options& run)
{
  const auto curve = square_free(f, "singular_points");
  std::vector<Singular_point> result;
  for (const long shear : exact::shears) {
    const auto slope = derivative(curve, 1) - Integer(shear) * derivative(curve, 0);
    if (curve.is_constant() || slope.is_constant()) return result;
    auto found = exact::projected_zeros(curve, slope, shear, box, 2, checkpoint_of(run, "solve"));
    if (!found) continue;
    std::erase_if(found->zeros, [](const auto& zero) { return zero.multiplicity() <= zero.fibre_degree(); });
    for (auto& point : points(std::move(found->zeros), curve, slope)) {
      const unsigned order = order_at(point, curve);
      result.push_back({std::move(point), order});
    }
    return result;
  }
  throw Budget_exceeded("singular_points: no direction tells them apart");
}

std::vector<Algebraic_point> tangent_points(const Polynomial<Rational, 2>& f, std::size_t axis,
                                            const std::optional<Rational_box<2>>& box, const Run_options& run)
{
  const auto curve = transform<Rational>(square_free(f, "tangent_points"), rational);
  const auto along = derivative(curve, axis);
  if (curve.is_constant() || along.is_zero()) return {};
  auto found = solve(curve, along, box, run).points;
  const auto across = derivative(curve, 1 - axis);
  std::erase_if(found, [&](const Algebraic_point& point) { return point.sign_of(across) == 0; });
  return found;
}

} // namespace corral
