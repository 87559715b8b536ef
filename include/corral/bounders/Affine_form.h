// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_BOUNDERS_AFFINE_FORM_H
#define CORRAL_BOUNDERS_AFFINE_FORM_H

#include <corral/number/Interval_number.h>

#include <array>
#include <cstddef>
#include <utility>

namespace corral {

/// \brief A quantity a + b_1 e_1 + ... + b_D e_D + d, where every e_i in [-1, 1] is shared by all
/// forms of one computation, and d is any number of a symmetric interval, private to the form.
///
/// The numbers a and b_i are only known as elements of intervals over I, so that rounding needs no
/// bookkeeping of its own: the interval number does it.
///
/// \par Reference  Comba, Stolfi 1993; every quadratic term of a product goes into d.
template <IntervalNumber I, std::size_t D>
class Affine_form
{
public:
  Affine_form() = default;
  template <MachineNumber T>
  Affine_form(T value) : centre_(value)
  {}
  explicit Affine_form(I value) : centre_(std::move(value)) {}

  /// centre + radius * e_axis.
  static Affine_form side(std::size_t axis, I centre, I radius)
  {
    Affine_form form(std::move(centre));
    form.slopes_[axis] = std::move(radius);
    return form;
  }

  /// An interval that contains every value of the form.
  [[nodiscard]] I range() const { return centre_ + spread(); }

  Affine_form& operator+=(const Affine_form& b)
  {
    centre_ += b.centre_;
    for (std::size_t axis = 0; axis < D; ++axis) slopes_[axis] += b.slopes_[axis];
    error_ += b.error_;
    return *this;
  }

  friend Affine_form operator*(const Affine_form& a, const Affine_form& b)
  {
    Affine_form product(I(a.centre_ * b.centre_));
    for (std::size_t axis = 0; axis < D; ++axis)
      product.slopes_[axis] = a.centre_ * b.slopes_[axis] + b.centre_ * a.slopes_[axis];
    product.error_ = symmetric_hull(I(a.centre_ * b.error_)) + symmetric_hull(I(b.centre_ * a.error_))
                     + symmetric_hull(I(a.spread() * b.spread()));
    return product;
  }
  Affine_form& operator*=(const Affine_form& b) { return *this = *this * b; }

private:
  /// Everything but the centre: a symmetric interval.
  [[nodiscard]] I spread() const
  {
    I sum = error_;
    for (const I& slope : slopes_) sum += symmetric_hull(slope);
    return sum;
  }

  I centre_ = I(0);
  std::array<I, D> slopes_{};
  I error_ = I(0);
};

} // namespace corral

#endif
