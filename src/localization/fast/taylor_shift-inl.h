// SPDX-License-Identifier: LGPL-3.0-or-later
// Included once for each instruction set, by fast_engine.cpp.
#if defined(CORRAL_SRC_FAST_TAYLOR_SHIFT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CORRAL_SRC_FAST_TAYLOR_SHIFT_INL_H
#undef CORRAL_SRC_FAST_TAYLOR_SHIFT_INL_H
#else
#define CORRAL_SRC_FAST_TAYLOR_SHIFT_INL_H
#endif

#include "Monomial_shape.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace corral::fast::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Vectors of at most eight doubles; a batch of eight lanes is processed in chunks of this size.
using Tag = hn::CappedTag<double, 8>;
using Vector = hn::Vec<Tag>;
inline constexpr std::size_t batch = 8;

/// c(u) -> c(u + 1) or c(u - 1) on one line of `degree + 1` coefficients kept in registers: Horner's triangle.
template <bool upwards, std::size_t degree>
HWY_INLINE void shift_short_line(const double* from, double* to, const std::uint32_t* index)
{
  const Tag tag;
  Vector c[degree + 1];
  for (std::size_t k = 0; k <= degree; ++k) c[k] = hn::Load(tag, from + index[k] * batch);
  for (std::size_t low = 0; low < degree; ++low)
    for (std::size_t k = degree; k-- > low;) c[k] = upwards ? hn::Add(c[k], c[k + 1]) : hn::Sub(c[k], c[k + 1]);
  for (std::size_t k = 0; k <= degree; ++k) hn::Store(c[k], tag, to + index[k] * batch);
}

/// The same for a line of any degree, in memory.
template <bool upwards>
void shift_long_line(const double* from, double* to, const std::uint32_t* index, std::size_t degree)
{
  const Tag tag;
  for (std::size_t k = 0; k <= degree; ++k)
    hn::Store(hn::Load(tag, from + index[k] * batch), tag, to + index[k] * batch);
  for (std::size_t low = 0; low < degree; ++low) {
    Vector carry = hn::Load(tag, to + index[degree] * batch);
    for (std::size_t k = degree; k-- > low;) {
      const Vector c = hn::Load(tag, to + index[k] * batch);
      carry = upwards ? hn::Add(c, carry) : hn::Sub(c, carry);
      hn::Store(carry, tag, to + index[k] * batch);
    }
  }
}

/// Shifts all lines of one axis, for one chunk of lanes.
template <bool upwards, class Lines>
void shift_lines(const Lines& lines, const double* from, double* to)
{
  for (const auto& line : lines.lines) {
    const std::uint32_t* const index = lines.index.data() + line.first;
    switch (line.degree) {
    case 0:
      shift_short_line<upwards, 0>(from, to, index);
      break;
    case 1:
      shift_short_line<upwards, 1>(from, to, index);
      break;
    case 2:
      shift_short_line<upwards, 2>(from, to, index);
      break;
    case 3:
      shift_short_line<upwards, 3>(from, to, index);
      break;
    case 4:
      shift_short_line<upwards, 4>(from, to, index);
      break;
    default:
      shift_long_line<upwards>(from, to, index, line.degree);
    }
  }
}

} // namespace corral::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
