// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_ALGEBRA_EXACT_RANGE_H
#define CORRAL_ALGEBRA_EXACT_RANGE_H

#include <corral/algebra/real_roots.h>
#include <corral/polynomial/Box.h>
#include <corral/polynomial/Polynomial.h>

#include <cstddef>

namespace corral {

/// The range of a polynomial on a box, between two intervals: `inner` is part of it, `outer` contains it.
struct Range_enclosure
{
  Rational_interval inner;
  Rational_interval outer;
};

/// \brief The range of f on a box, exactly up to `tolerance` at each end.
///
/// Both ends of `inner` are values of f in the box; `outer` exceeds them by at most `tolerance`. In one variable the
/// extreme values are those at the ends and at the roots of the derivative, which are refined; in two and three the box
/// is cut, where the bound is worst, until the Bernstein coefficients of every part are close enough. All arithmetic is
/// exact. A side of the box may be a point. \throw Invalid_input if it is not; Budget_exceeded if
/// more than 200000 parts are needed;
///      Cancelled if it is stopped.
/// \par Complexity  The parts needed grow like log(1/tolerance) around isolated extreme points, and like a root of
///      1/tolerance where an extreme value is taken along a curve.
template <std::size_t D>
[[nodiscard]] Range_enclosure exact_range(const Polynomial<Rational, D>& f, const Rational_box<D>& box,
                                          const Rational& tolerance, const Run_options& run = {});

/// Higher dimensions do not compile: the number of parts would be out of reach.
template <std::size_t D>
  requires(D > 3)
[[nodiscard]] Range_enclosure exact_range(const Polynomial<Rational, D>&, const Rational_box<D>&, const Rational&,
                                          const Run_options& = {}) = delete;

} // namespace corral

#endif
