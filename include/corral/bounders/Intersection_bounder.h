// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_BOUNDERS_INTERSECTION_BOUNDER_H
#define CORRAL_BOUNDERS_INTERSECTION_BOUNDER_H

#include <corral/bounders/Range_bounder.h>

#include <cstddef>
#include <string_view>
#include <tuple>

namespace corral {

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
