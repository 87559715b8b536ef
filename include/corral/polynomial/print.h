// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_POLYNOMIAL_PRINT_H
#define CORRAL_POLYNOMIAL_PRINT_H

#include <corral/polynomial/Polynomial.h>

#include <array>
#include <cstddef>
#include <string>

namespace corral {

/// \brief The polynomial as text, the highest power of variable 0 first, such as `x^2 - 15/4*x*y + 1`.
///
/// Over `Rational` and `Integer`, `parse_polynomial` gives the same polynomial back.
template <class NT, std::size_t D>
[[nodiscard]] std::string to_string(const Polynomial<NT, D>& f, const std::array<std::string, D>& variables)
{
  if (f.is_zero()) return "0";
  std::string text;
  for (auto term = f.terms().rbegin(); term != f.terms().rend(); ++term) {
    const NT magnitude = abs(term->coefficient);
    const bool is_negative = term->coefficient < 0;
    if (!text.empty())
      text += is_negative ? " - " : " + ";
    else if (is_negative)
      text += '-';
    std::string factors;
    if (magnitude != 1 || term->exponents == Exponents<D>{}) factors = magnitude.get_str();
    for (std::size_t axis = 0; axis < D; ++axis)
      if (const unsigned exponent = term->exponents[axis]; exponent > 0) {
        if (!factors.empty()) factors += '*';
        factors += variables[axis];
        if (exponent > 1) factors += '^' + std::to_string(exponent);
      }
    text += factors;
  }
  return text;
}

} // namespace corral

#endif
