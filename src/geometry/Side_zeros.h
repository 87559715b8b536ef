// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_GEOMETRY_SIDE_ZEROS_H
#define CORRAL_SRC_GEOMETRY_SIDE_ZEROS_H

#include "Cell_form.h"

#include <optional>
#include <vector>

namespace corral::geometry {

/// A side of a cell in the unit box: coordinate `normal` is `at`, the other one runs from `low` to `high`.
struct Segment
{
  std::size_t normal;
  double at;
  double low;
  double high;
};

/// \brief The zeros of a polynomial inside a side, without its ends.
struct Side_zeros
{
  /// Each interval holds one zero, in increasing order; two share at most an end, which is no zero.
  std::vector<Range> zeros;
  /// The signs before, between and after the zeros: one more.
  std::vector<int> signs;
  /// False if two intervals overlap, because no double lies between two zeros. They are in order nevertheless.
  bool are_apart = true;
};

/// \brief The zeros by doubles; nothing if these cannot tell.
/// \param error  of the Bernstein coefficients on the side.
/// \param ends  the exact signs at its ends.
/// \param width  the greatest length of an interval.
[[nodiscard]] std::optional<Side_zeros> isolate(std::vector<double> coefficients, double error,
                                                const std::array<int, 2>& ends, const Segment& side, double width);

/// \brief The same from the exact polynomial on the side: by doubles again, else by integers.
/// \throw Not_generic if the polynomial vanishes on the whole side.
[[nodiscard]] Side_zeros isolate_exactly(const Polynomial<Integer, 2>& f, const std::array<int, 2>& ends,
                                         const Segment& side, double width);

/// Bounds, on the part [low, high] of [0, 1], of the polynomial with Bernstein coefficients no further than `error`
/// from these.
[[nodiscard]] Range range_on_part(std::vector<double> coefficients, double error, const Range& part);

/// The exact sign of f at a point of the unit box.
[[nodiscard]] int sign_at(const Polynomial<Integer, 2>& f, double x, double y);

/// The strict sign of f on a part of a side, by exact intervals; 0 if it does not show.
[[nodiscard]] int sign_on_side(const Polynomial<Integer, 2>& f, std::size_t normal, double at, const Range& part);

/// A line of our own meets what it must not meet; another choice will do.
struct Not_generic
{
};

} // namespace corral::geometry

#endif
