// SPDX-License-Identifier: LGPL-3.0-or-later
/// \file
/// A bounding method of one's own, wrong at first: the audit shows a polynomial, a box and a point where it fails.
#include <corral/audit/audit_bounder.h>
#include <corral/number/Outward_interval.h>
#include <corral/polynomial/evaluate.h>

#include <iostream>

using namespace corral;
using I = Outward_interval;

/// f(c) plus the slope times the distance from the centre c. The slope must be that of the whole box, by the mean value
/// theorem; at c alone, as for a tangent plane, it says nothing about the curvature.
template <bool slope_of_whole_box>
class My_bounder
{
public:
  explicit My_bounder(Polynomial<I, 2> f) : f_(std::move(f)) {}

  I bound(const Box<I, 2>& box) const
  {
    const std::array<I, 2> centre = {midpoint(box[0]), midpoint(box[1])};
    const Box<I, 2> around = {hull(box[0], centre[0]), hull(box[1], centre[1])}; // rounding may move c out of the box
    I sum = evaluate(f_, centre);
    for (std::size_t axis = 0; axis < 2; ++axis)
      sum += evaluate(derivative(f_, axis), slope_of_whole_box ? around : centre) * (box[axis] - centre[axis]);
    return sum;
  }

private:
  Polynomial<I, 2> f_;
};

template <class Bounder>
void report(const char* name)
{
  const auto audit = audit_bounder<I, 2>([](const Polynomial<I, 2>& f) { return Bounder(f); }, {.cases = 2000});
  std::cout << name << ": " << audit.escapes << " bounds lost a value; " << audit.checks
            << " exact values looked for\n";
  if (audit.first_escape) std::cout << to_string(*audit.first_escape) << '\n';
}

int main()
{
  report<My_bounder<false>>("slope at the centre");
  report<My_bounder<true>>("slope of the box");
}
