// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_BOUNDERS_AFFINE_BOUNDER_H
#define CORRAL_BOUNDERS_AFFINE_BOUNDER_H

#include <corral/bounders/Affine_form.h>
#include <corral/bounders/Range_bounder.h>
#include <corral/polynomial/Box.h>
#include <corral/polynomial/evaluate.h>

#include <array>
#include <cstddef>
#include <string_view>

namespace corral {

/// \brief Model of `RangeBounder`: standard affine arithmetic on the Horner form.
///
/// Every side of the box is an affine form c + r e with a noise symbol e in [-1, 1] of its own, and
/// the polynomial is evaluated with `Affine_form`s. Linear dependence is kept, products lose theirs
/// to one accumulated error.
///
/// \tparam I  model of `IntervalNumber`. It does all the rounding; this class does none.
/// \par Complexity  4D + 4 multiplications for each multiplication of `evaluate`.
/// \par Reference  Comba, Stolfi, "Affine arithmetic and its applications to computer graphics", 1993.
template <IntervalNumber I, std::size_t D>
class Affine_bounder
{
public:
  using Interval = I;
  using Polynomial = corral::Polynomial<I, D>;
  using Box = corral::Box<I, D>;
  static constexpr std::size_t dimension = D;
  static constexpr std::string_view name = "affine";

  explicit Affine_bounder(const Polynomial& f) : f_(transform<Form>(f, [](const I& c) { return Form(c); })) {}

  /// \pre The sides of `box` are finite.
  [[nodiscard]] I bound(const Box& box) const
  {
    std::array<Form, D> point;
    for (std::size_t axis = 0; axis < D; ++axis) {
      const I centre = midpoint(box[axis]);
      point[axis] = Form::side(axis, centre, radius(box[axis], centre));
    }
    return evaluate(f_, point).range();
  }

private:
  using Form = Affine_form<I, D>;

  corral::Polynomial<Form, D> f_;
};

} // namespace corral

#endif
