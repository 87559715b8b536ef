// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_CERTIFICATE_COUNTED_FORM_H
#define CORRAL_SRC_CERTIFICATE_COUNTED_FORM_H

#include "../algebra/Bernstein_form.h"
#include "../algebra/on_box.h"
#include "Checking_cost.h"

#include <corral/polynomial/Box.h>

#include <algorithm>
#include <cstddef>

namespace corral::certificate {

/// A Bernstein form on a box, of which some sides may be flat, with the bits that a checker counts for it.
template <std::size_t D>
struct Counted_form
{
  exact::Bernstein_form<D> form;
  double bit_bound = 0;

  [[nodiscard]] double size() const { return static_cast<double>(form.values.size()); }
  [[nodiscard]] double held() const { return (D + 1) * size() * (words(bit_bound) + 5); }
  [[nodiscard]] bool is_free(std::size_t axis) const { return form.size[axis] > 1; }
  [[nodiscard]] std::size_t free_axes() const
  {
    return static_cast<std::size_t>(std::count_if(form.size.begin(), form.size.end(), [](auto n) { return n > 1; }));
  }
};

/// The bits of a side of a box that a checker counts.
inline double side_bits(const Rational& lower, const Rational& upper)
{
  const Integer common = lcm(lower.get_den(), upper.get_den());
  return std::max({bits(Integer(lower.get_num() * Integer(common / lower.get_den()))),
                   bits(Integer(upper.get_num() * Integer(common / upper.get_den()))), bits(common)});
}

/// f on a box; an upper bound of what that costs is added to `work`. A form with one value, 0, if f is zero there.
template <std::size_t D>
[[nodiscard]] Counted_form<D> counted_form(const Polynomial<Integer, D>& f, const Rational_box<D>& box, double& work)
{
  double coefficient_bits = 1;
  for (const auto& term : f.terms()) coefficient_bits = std::max(coefficient_bits, bits(term.coefficient));
  const auto terms = static_cast<double>(f.terms().size());
  Counted_form<D> result{exact::bernstein_form(f, box), coefficient_bits + 2 * std::log2(terms + 1) + 3};
  if (result.form.values.empty()) result.form.values.resize(1);
  double flat_words = 0;
  for (std::size_t axis = 0; axis < D; ++axis)
    if (box[axis].lower() == box[axis].upper()) {
      const double b = side_bits(box[axis].lower(), box[axis].upper());
      result.bit_bound += 2 * f.degree(axis) * (b + 1);
      flat_words += 2 * f.degree(axis) * words(b);
    }
  work += (D + 2) * 2 * terms * fraction_cost(words(result.bit_bound) + flat_words);
  for (std::size_t axis = 0; axis < D; ++axis) {
    if (!result.is_free(axis)) continue;
    const auto n = static_cast<double>(result.form.size[axis] - 1);
    const double b = side_bits(box[axis].lower(), box[axis].upper());
    result.bit_bound += n * (b + 3);
    work += result.size() * (n + 1) * words(result.bit_bound) * words(b);
  }
  exact::drop_twos(result.form);
  return result;
}

/// `form` becomes the upper half, the lower one is returned.
template <std::size_t D>
[[nodiscard]] Counted_form<D> halve(Counted_form<D>& form, std::size_t axis, double& work)
{
  const auto n = static_cast<double>(form.form.size[axis] - 1);
  form.bit_bound += n;
  work += form.size() * (n + 1) * words(form.bit_bound);
  auto lower = exact::halve(form.form, axis);
  return {std::move(lower), form.bit_bound};
}

/// The form on a facet of the box, which stays a form in all variables.
template <std::size_t D>
[[nodiscard]] Counted_form<D> facet(const Counted_form<D>& form, std::size_t axis, bool upper, double& work)
{
  Counted_form<D> result{{form.form.size, {}}, form.bit_bound};
  work += form.size();
  const std::size_t offset = upper ? form.form.stride(axis) * (form.form.size[axis] - 1) : 0;
  exact::for_each_line(form.form, axis,
                       [&](std::size_t first) { result.form.values.push_back(form.form.values[first + offset]); });
  result.form.size[axis] = 1;
  return result;
}

} // namespace corral::certificate

#endif
