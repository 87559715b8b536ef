// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_BOUNDERS_INTERSECTION_BOUNDER_H
#define CORRAL_BOUNDERS_INTERSECTION_BOUNDER_H

#include <corral/bounders/Range_bounder.h>

#include <cstddef>
#include <string_view>
#include <tuple>

namespace corral {

/// \brief The intersection of two intervals, where they are known to share an element.
///
/// Two intervals without a common element, as rounding to nearest may give, yield the gap between them.
template <IntervalNumber I>
[[nodiscard]] I intersection(const I& a, const I& b)
{
  const auto a_low = exact_lower(a);
  const auto b_low = exact_lower(b);
  const auto a_high = exact_upper(a);
  const auto b_high = exact_upper(b);
  const bool a_is_above = a_low && (!b_low || *a_low >= *b_low);
  const bool a_is_below = a_high && (!b_high || *a_high <= *b_high);
  if (!a_low && !b_low) return a_is_below ? a : b;
  if (!a_high && !b_high) return a_is_above ? a : b;
  if (a_is_above && a_is_below) return a;
  if (!a_is_above && !a_is_below) return b;
  return a_is_above ? hull(lower(a), upper(b)) : hull(lower(b), upper(a));
}

/// \brief Model of `RangeBounder`: the intersection of the bounds of several methods.
/// \par Complexity  That of all of them together.
template <RangeBounder First, RangeBounder... Others>
class Intersection_bounder
{
public:
  using Interval = typename First::Interval;
  using Polynomial = typename First::Polynomial;
  using Box = typename First::Box;
  static constexpr std::size_t dimension = First::dimension;
  static constexpr std::string_view name = "intersection";

  explicit Intersection_bounder(const Polynomial& f) : first_(f), others_(Others(f)...) {}

  [[nodiscard]] Interval bound(const Box& box) const
  {
    Interval common = first_.bound(box);
    std::apply([&](const Others&... other) { ((common = intersection(common, other.bound(box))), ...); }, others_);
    return common;
  }

private:
  First first_;
  std::tuple<Others...> others_;
};

} // namespace corral

#endif
