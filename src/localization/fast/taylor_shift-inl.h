// SPDX-License-Identifier: LGPL-3.0-or-later
// Included once for each instruction set, by fast_engine.cpp.
#if defined(CORRAL_SRC_FAST_TAYLOR_SHIFT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CORRAL_SRC_FAST_TAYLOR_SHIFT_INL_H
#undef CORRAL_SRC_FAST_TAYLOR_SHIFT_INL_H
#else
#define CORRAL_SRC_FAST_TAYLOR_SHIFT_INL_H
#endif

#include "arithmetic-inl.h"

HWY_BEFORE_NAMESPACE();
namespace corral::fast::HWY_NAMESPACE {

/// c(u) -> c(u + 1) or c(u - 1) on one line of `degree + 1` coefficients kept in registers: Horner's triangle.
template <bool upwards, std::size_t degree>
HWY_INLINE void shift_short_line(const Arithmetic& with, const double* from, double* to, const std::uint32_t* index)
{
  Octet c[degree + 1];
  for (std::size_t k = 0; k <= degree; ++k) c[k] = load(from + index[k] * batch);
  for (std::size_t low = 0; low < degree; ++low)
    for (std::size_t k = degree; k-- > low;)
      c[k] = upwards ? with.sum(c[k], c[k + 1]) : with.difference(c[k], c[k + 1]);
  for (std::size_t k = 0; k <= degree; ++k) store(c[k], to + index[k] * batch);
}

/// The same for a line of any degree, in memory.
template <bool upwards>
void shift_long_line(const Arithmetic& with, const double* from, double* to, const std::uint32_t* index,
                     std::size_t degree)
{
  for (std::size_t k = 0; k <= degree; ++k) store(load(from + index[k] * batch), to + index[k] * batch);
  for (std::size_t low = 0; low < degree; ++low) {
    Octet carry = load(to + index[degree] * batch);
    for (std::size_t k = degree; k-- > low;) {
      const Octet c = load(to + index[k] * batch);
      carry = upwards ? with.sum(c, carry) : with.difference(c, carry);
      store(carry, to + index[k] * batch);
    }
  }
}

/// Shifts all lines of one axis. \param with  the arithmetic that knows which lanes round nothing.
template <bool upwards, class Lines>
void shift_lines(const Arithmetic& with, const Lines& lines, const double* from, double* to)
{
  for (const auto& line : lines.lines) {
    const std::uint32_t* const index = lines.index.data() + line.first;
    switch (line.degree) {
    case 0:
      shift_short_line<upwards, 0>(with, from, to, index);
      break;
    case 1:
      shift_short_line<upwards, 1>(with, from, to, index);
      break;
    case 2:
      shift_short_line<upwards, 2>(with, from, to, index);
      break;
    case 3:
      shift_short_line<upwards, 3>(with, from, to, index);
      break;
    case 4:
      shift_short_line<upwards, 4>(with, from, to, index);
      break;
    default:
      shift_long_line<upwards>(with, from, to, index, line.degree);
    }
  }
}

} // namespace corral::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
