// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_ALGEBRA_BERNSTEIN_FORM_H
#define CORRAL_SRC_ALGEBRA_BERNSTEIN_FORM_H

#include <corral/errors.h>
#include <corral/number/Rational.h>
#include <corral/polynomial/Polynomial.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

/// \file
/// Polynomials on the unit box in the power basis and in the Bernstein basis, over the integers: additions and signs
/// only. Two types, so that the coefficients of one are never read as those of the other.
namespace corral::exact {

/// A number for each multi-index up to the degrees, last axis fastest.
template <std::size_t D>
struct Dense_coefficients
{
  std::array<std::size_t, D> size{}; ///< degree + 1 for each axis
  std::vector<Integer> values{};

  /// The distance in `values` between neighbours along `axis`.
  [[nodiscard]] std::size_t stride(std::size_t axis) const
  {
    std::size_t result = 1;
    for (std::size_t k = axis + 1; k < D; ++k) result *= size[k];
    return result;
  }
};

/// A polynomial by a positive multiple of the coefficients of its monomials.
template <std::size_t D>
struct Power_form : Dense_coefficients<D>
{
};

/// \brief A polynomial on [0,1]^D by a positive multiple of its Bernstein coefficients.
///
/// The polynomial lies in the convex hull of the coefficients; those whose indices are all 0 or the degree are its
/// values at the corners (times the multiple).
template <std::size_t D>
struct Bernstein_form : Dense_coefficients<D>
{
  /// The coefficient at a corner; bit k of `corner` chooses the upper end of axis k.
  [[nodiscard]] const Integer& corner(unsigned corner) const
  {
    std::size_t index = 0;
    for (std::size_t k = 0; k < D; ++k)
      index = index * this->size[k] + ((corner >> k & 1) != 0 ? this->size[k] - 1 : 0);
    return this->values[index];
  }
};

/// Calls `function(first, stride)` for every line of an array along `axis`: the index of its first value and the
/// distance between neighbours.
template <std::size_t D, class Function>
void for_each_line(const std::array<std::size_t, D>& size, std::size_t axis, const Function& function)
{
  std::size_t stride = 1;
  for (std::size_t k = axis + 1; k < D; ++k) stride *= size[k];
  std::size_t count = stride;
  for (std::size_t k = 0; k <= axis; ++k) count *= size[k];
  for (std::size_t outer = 0; outer < count; outer += stride * size[axis])
    for (std::size_t first = outer; first < outer + stride; ++first) function(first, stride);
}

/// Calls `function(first)` with the index of the first value of every line along `axis`.
template <std::size_t D, class Function>
void for_each_line(const Dense_coefficients<D>& form, std::size_t axis, const Function& function)
{
  for_each_line(form.size, axis, [&](std::size_t first, std::size_t) { function(first); });
}

/// The number of coefficients of a dense polynomial of the degrees of `g`.
template <class NT, std::size_t D>
[[nodiscard]] std::size_t dense_count(const Polynomial<NT, D>& g)
{
  static_assert(D <= 3, "at most 2^48");
  std::size_t count = 1;
  for (std::size_t k = 0; k < D; ++k) count *= g.degree(k) + std::size_t{1};
  return count;
}

/// The same. \throw Budget_exceeded if there are more than 2^25 of them.
template <class NT, std::size_t D>
std::size_t dense_size(const Polynomial<NT, D>& g)
{
  const std::size_t count = dense_count(g);
  constexpr std::size_t most = std::size_t{1} << 25;
  if (count > most)
    throw Budget_exceeded("exact decision: a polynomial has " + std::to_string(count)
                          + " coefficients, zeros included; expected at most " + std::to_string(most));
  return count;
}

/// The coefficients of `g`, zeros included. \throw Budget_exceeded as `dense_size`.
template <std::size_t D>
[[nodiscard]] Power_form<D> power_form(const Polynomial<Integer, D>& g)
{
  Power_form<D> form;
  form.values.resize(dense_size(g));
  for (std::size_t k = 0; k < D; ++k) form.size[k] = g.degree(k) + 1;
  for (const auto& term : g.terms()) {
    std::size_t index = 0;
    for (std::size_t k = 0; k < D; ++k) index = index * form.size[k] + term.exponents[k];
    form.values[index] = term.coefficient;
  }
  return form;
}

/// Replaces p(x) by p(x + offset) along one axis.
template <std::size_t D>
void shift(Power_form<D>& form, std::size_t axis, unsigned long offset)
{
  if (offset == 0) return;
  const std::size_t stride = form.stride(axis);
  const std::size_t n = form.size[axis] - 1;
  for_each_line(form, axis, [&](std::size_t first) {
    Integer* c = &form.values[first];
    std::size_t top = n; // degree of the line
    while (top > 0 && c[top * stride] == 0) --top;
    for (std::size_t i = 0; i < top; ++i)
      for (std::size_t j = top; j-- > i;)
        mpz_addmul_ui(c[j * stride].get_mpz_t(), c[(j + 1) * stride].get_mpz_t(), offset);
  });
}

/// L / C(n, k) for k = 0, ..., n, with the smallest L that makes them integers.
[[nodiscard]] std::vector<Integer> bernstein_weights(std::size_t n);

/// The polynomial on [0,1]^D in the Bernstein basis.
template <std::size_t D>
[[nodiscard]] Bernstein_form<D> to_bernstein(Power_form<D> power)
{
  Bernstein_form<D> form{{power.size, std::move(power.values)}};
  for (std::size_t axis = 0; axis < D; ++axis) {
    const std::size_t stride = form.stride(axis);
    const std::size_t n = form.size[axis] - 1;
    if (n == 0) continue;
    const auto weights = bernstein_weights(n);
    for_each_line(form, axis, [&](std::size_t first) {
      Integer* c = &form.values[first];
      std::size_t top = n; // degree of the line
      while (top > 0 && c[top * stride] == 0) --top;
      if (top == 0) { // constant, as most lines are where terms are few
        if (c[0] == 0) return;
        c[0] *= weights[0];
        for (std::size_t k = 1; k <= n; ++k) c[k * stride] = c[0];
        return;
      }
      // Reversed, shifted by 1 and reversed again: C(n, k) b_k.
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 1; j + i <= n; ++j) c[j * stride] += c[(j - 1) * stride];
      for (std::size_t k = 0; k <= n; ++k)
        if (weights[k] != 1) c[k * stride] *= weights[k];
    });
  }
  return form;
}

/// Divides all values by the power of two that they share.
template <std::size_t D>
void drop_twos(Bernstein_form<D>& form)
{
  mp_bitcnt_t twos = ~mp_bitcnt_t{0};
  for (const Integer& c : form.values)
    if (c != 0) {
      twos = std::min(twos, mpz_scan1(c.get_mpz_t(), 0));
      if (twos == 0) return;
    }
  if (twos == ~mp_bitcnt_t{0}) return;
  for (Integer& c : form.values) mpz_tdiv_q_2exp(c.get_mpz_t(), c.get_mpz_t(), twos);
}

/// de Casteljau at 1/2 along one axis: `form` becomes the upper half, the lower half is returned. Both are multiplied
/// by 2^n for the degree n along the axis.
template <std::size_t D>
[[nodiscard]] Bernstein_form<D> halve_exactly(Bernstein_form<D>& form, std::size_t axis)
{
  Bernstein_form<D> lower;
  lower.size = form.size;
  lower.values.resize(form.values.size());
  const std::size_t stride = form.stride(axis);
  const std::size_t n = form.size[axis] - 1;
  for_each_line(form, axis, [&](std::size_t first) {
    Integer* c = &form.values[first];
    for (std::size_t k = 0; k <= n; ++k) {
      mpz_mul_2exp(lower.values[first + k * stride].get_mpz_t(), c[0].get_mpz_t(), n - k);
      for (std::size_t i = 0; i + k < n; ++i) c[i * stride] += c[(i + 1) * stride];
      mpz_mul_2exp(c[(n - k) * stride].get_mpz_t(), c[(n - k) * stride].get_mpz_t(), n - k);
    }
  });
  return lower;
}

/// The same up to a positive factor for each half, which keeps the numbers small.
template <std::size_t D>
[[nodiscard]] Bernstein_form<D> halve(Bernstein_form<D>& form, std::size_t axis)
{
  auto lower = halve_exactly(form, axis);
  drop_twos(lower);
  drop_twos(form);
  return lower;
}

/// The restriction to the lower or the upper facet of one axis.
template <std::size_t D>
[[nodiscard]] Bernstein_form<D - 1> facet(const Bernstein_form<D>& form, std::size_t axis, bool upper)
{
  Bernstein_form<D - 1> result;
  for (std::size_t k = 0, to = 0; k < D; ++k)
    if (k != axis) result.size[to++] = form.size[k];
  result.values.reserve(form.values.size() / form.size[axis]);
  const std::size_t offset = upper ? form.stride(axis) * (form.size[axis] - 1) : 0;
  for_each_line(form, axis, [&](std::size_t first) { result.values.push_back(form.values[first + offset]); });
  return result;
}

/// A positive multiple of the derivative along one axis. \pre The degree along it is positive.
template <std::size_t D>
[[nodiscard]] Bernstein_form<D> derivative(const Bernstein_form<D>& form, std::size_t axis)
{
  Bernstein_form<D> result;
  result.size = form.size;
  --result.size[axis];
  result.values.resize(form.values.size() / form.size[axis] * result.size[axis]);
  const std::size_t stride = form.stride(axis);
  std::size_t line = 0;
  const std::size_t inner = stride;
  for_each_line(form, axis, [&](std::size_t first) {
    const std::size_t target = line / inner * inner * result.size[axis] + line % inner;
    for (std::size_t k = 0; k < result.size[axis]; ++k)
      result.values[target + k * stride] = form.values[first + (k + 1) * stride] - form.values[first + k * stride];
    ++line;
  });
  return result;
}

/// What the signs of the coefficients say of the polynomial on the box.
struct Sign_pattern
{
  int hull = 0;         ///< 1 or -1 if no coefficient has the other sign and not all are zero, else 0
  int corners = 0;      ///< 1 or -1 if all corners have that strict sign; 0 else
  bool crosses = false; ///< a corner is zero or two corners have opposite signs

  /// The strict sign on the closed box, 0 if not proved. Basis functions are not negative, and at every point of the
  /// box one that belongs to a corner is positive.
  [[nodiscard]] int closed() const { return hull == corners ? hull : 0; }
};

template <std::size_t D>
[[nodiscard]] Sign_pattern sign_pattern(const Bernstein_form<D>& form)
{
  Sign_pattern result;
  bool positive = false;
  bool negative = false;
  for (unsigned corner = 0; corner < 1U << D; ++corner) {
    const int sign = sgn(form.corner(corner));
    positive = positive || sign > 0;
    negative = negative || sign < 0;
    result.crosses = result.crosses || sign == 0;
  }
  result.crosses = result.crosses || (positive && negative);
  if (result.crosses) return result;
  result.corners = positive ? 1 : -1;
  const auto opposite = [&](const Integer& c) { return sgn(c) == -result.corners; };
  if (std::none_of(form.values.begin(), form.values.end(), opposite)) result.hull = result.corners;
  return result;
}

/// Whether the polynomial has one strict sign in the open box (no coefficient of the other sign, not all zero).
template <std::size_t D>
[[nodiscard]] bool one_sign_inside(const Bernstein_form<D>& form)
{
  bool positive = false;
  bool negative = false;
  for (const Integer& c : form.values) {
    positive = positive || c > 0;
    negative = negative || c < 0;
    if (positive && negative) return false;
  }
  return positive || negative;
}

} // namespace corral::exact

#endif
