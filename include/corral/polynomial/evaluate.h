// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_POLYNOMIAL_EVALUATE_H
#define CORRAL_POLYNOMIAL_EVALUATE_H

#include <corral/number/Interval_number.h>
#include <corral/polynomial/Polynomial.h>

#include <array>
#include <cstddef>
#include <span>

namespace corral {
namespace detail {

/// `x` to the power `n` >= 1 in any ring.
template <class NT>
NT ring_power(const NT& x, unsigned n)
{
  // Not `IntervalNumber<NT>`: g++ 12 has been seen to take that for true of `Rational`.
  if constexpr (requires { Interval_traits<NT>::name; }) {
    return power(x, n);
  } else {
    if (n == 1) return x;
    const NT root = ring_power(x, n / 2);
    NT result = root * root;
    if (n % 2 != 0) result *= x;
    return result;
  }
}

/// Horner's rule in variables `axis` to D-1 for terms that share all earlier exponents.
template <std::size_t axis, class NT, std::size_t D>
NT horner(std::span<const typename Polynomial<NT, D>::Term> terms, const std::array<NT, D>& point)
{
  if constexpr (axis == D) {
    return terms.front().coefficient;
  } else {
    const auto cut_last_power = [&] { // takes the terms of the highest power of this variable away
      const auto exponent = terms.back().exponents[axis];
      std::size_t rest = terms.size() - 1;
      while (rest > 0 && terms[rest - 1].exponents[axis] == exponent) --rest;
      const auto cut = terms.subspan(rest);
      terms = terms.first(rest);
      return cut;
    };
    unsigned exponent = terms.back().exponents[axis];
    NT sum = horner<axis + 1, NT, D>(cut_last_power(), point);
    while (!terms.empty()) {
      const unsigned next = terms.back().exponents[axis];
      sum *= ring_power(point[axis], exponent - next);
      sum += horner<axis + 1, NT, D>(cut_last_power(), point);
      exponent = next;
    }
    if (exponent > 0) sum *= ring_power(point[axis], exponent);
    return sum;
  }
}

} // namespace detail

/// \brief The value of `f` at `point` by Horner's rule, variable by variable.
///
/// Missing powers cost a power by repeated squaring, absent ones nothing. Over an interval number
/// the coordinates may be intervals: the result then contains f(x) for every x in the box.
/// \par Complexity  Terms - 1 additions, and at most one multiplication for each power of each
///      variable between terms, where gaps of k powers cost 2 log2(k).
template <class NT, std::size_t D>
[[nodiscard]] NT evaluate(const Polynomial<NT, D>& f, const std::array<NT, D>& point)
{
  if (f.is_zero()) return NT(0);
  return detail::horner<0, NT, D>(std::span(f.terms()), point);
}

} // namespace corral

#endif
