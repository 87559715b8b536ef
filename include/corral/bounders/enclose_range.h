// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_BOUNDERS_ENCLOSE_RANGE_H
#define CORRAL_BOUNDERS_ENCLOSE_RANGE_H

#include <corral/bounders/Recursive_taylor_bounder.h>
#include <corral/number/Outward_interval.h>

#include <cstddef>

namespace corral {

/// \brief An interval that contains every value of f on a box, by one bounder:
/// `enclose_range<Bernstein_bounder<Mpfr_interval, 2>>(f, {{{-1, 1}, {0, 1}}})`.
///
/// It is proved if the bounder's number type is guaranteed. A side of the box may be a point.
/// \throw Unsafe_environment as the scope of the number type.
/// \par Complexity  That of making the bounder and of one bound. To bound many boxes, make a bounder once.
template <RangeBounder B>
[[nodiscard]] typename B::Interval enclose_range(const Polynomial<Rational, B::dimension>& f,
                                                 const Rational_box<B::dimension>& box)
{
  using I = typename B::Interval;
  const Arithmetic_scope<I> scope;
  return B(transform<I>(f, [](const Rational& c) { return enclose<I>(c); })).bound(enclose<I>(box));
}

/// The same by recursive Taylor expansion over doubles that are rounded outwards.
template <std::size_t D>
[[nodiscard]] Outward_interval enclose_range(const Polynomial<Rational, D>& f, const Rational_box<D>& box)
{
  return enclose_range<Recursive_taylor_bounder<Outward_interval, D>>(f, box);
}

} // namespace corral

#endif
