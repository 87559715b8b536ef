// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Term_search.h"

#include "../algebra/Bernstein_form.h"
#include "corners.h"

#include <corral/polynomial/arithmetic.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace corral::exact {

namespace {

using Side = Rational_interval;

template <std::size_t D>
Polynomial<Side, D> over_intervals(const Polynomial<Integer, D>& f)
{
  return transform<Side>(f, [](const Integer& c) { return Side(Rational(c)); });
}

template <std::size_t D, std::size_t... Axes>
std::array<Natural_bounder<Side, D>, D> slopes_of(const Polynomial<Integer, D>& f, std::index_sequence<Axes...>)
{
  return {Natural_bounder<Side, D>(over_intervals(derivative(f, Axes)))...};
}

bool is_free(const Side& side) { return side.lower() != side.upper(); }

/// Halves the box along the axis on which it has the greatest part of `whole`; it becomes the upper half.
/// \pre Some side is no point.
template <std::size_t D>
Rational_box<D> cut(Rational_box<D>& box, const Rational_box<D>& whole)
{
  std::size_t widest = 0;
  Rational most = 0;
  for (std::size_t k = 0; k < D; ++k)
    if (is_free(box[k]))
      if (Rational part = (box[k].upper() - box[k].lower()) / (whole[k].upper() - whole[k].lower()); part > most) {
        widest = k;
        most = std::move(part);
      }
  const Side side = box[widest];
  const Rational middle = (side.lower() + side.upper()) / 2;
  auto lower = box;
  lower[widest] = Side(side.lower(), middle);
  box[widest] = Side(middle, side.upper());
  return lower;
}

template <std::size_t D>
Rational_box<D> point_box(const Rational_point<D>& point)
{
  Rational_box<D> box;
  for (std::size_t k = 0; k < D; ++k) box[k] = Side(point[k]);
  return box;
}

template <std::size_t D>
Rational_point<D> centre(const Rational_box<D>& box)
{
  Rational_point<D> point;
  for (std::size_t k = 0; k < D; ++k) point[k] = (box[k].lower() + box[k].upper()) / 2;
  return point;
}

} // namespace

template <std::size_t D>
Term_search<D>::Term_search(const Polynomial<Integer, D>& f)
    : value_(over_intervals(f)), slopes_(slopes_of(f, std::make_index_sequence<D>())),
      most_boxes_(std::clamp<std::size_t>(dense_count(f) / (8 * f.terms().size()), 1, 256))
{}

/// A part of the box on which sign * f has its least value: where a partial derivative has one sign, zeros allowed, one
/// facet does for the box.
template <std::size_t D>
Rational_box<D> Term_search<D>::lowest_part(Rational_box<D> box, int sign) const
{
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t k = 0; k < D; ++k) {
      if (!is_free(box[k])) continue;
      const Side slope = slopes_[k].bound(box);
      const bool rises = sgn(slope.lower()) >= 0;
      if (!rises && sgn(slope.upper()) > 0) continue;
      box[k] = Side(rises == (sign > 0) ? box[k].lower() : box[k].upper());
      changed = true;
    }
  }
  return box;
}

template <std::size_t D>
std::optional<Cell_decision<D>> Term_search<D>::decide(const Rational_box<D>& box, int sign) const
{
  const auto bounded_away = [sign](const Side& values) {
    return sgn(sign > 0 ? values.lower() : values.upper()) == sign;
  };
  std::vector<Rational_box<D>> open{box};
  for (std::size_t boxes = 0; !open.empty(); ++boxes) {
    if (boxes == most_boxes_) return std::nullopt;
    auto part = lowest_part(std::move(open.back()), sign);
    open.pop_back();
    if (bounded_away(value_.bound(part))) continue;
    const auto point = centre(part);
    if (const Side value = value_.bound(point_box<D>(point)); sgn(value.lower()) != sign) {
      const auto first = sgn(value.lower()) == 0 ? point : corner_of(box, 0);
      return Cell_decision<D>{Verdict::hit, Rung::integers, Sign_change<D>{first, point}, {}};
    }
    open.push_back(cut(part, box));
    open.push_back(std::move(part));
  }
  return Cell_decision<D>{Verdict::empty, Rung::integers, Bounded_away{}, {}};
}

template class Term_search<1>;
template class Term_search<2>;
template class Term_search<3>;

} // namespace corral::exact
