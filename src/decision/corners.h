// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_DECISION_CORNERS_H
#define CORRAL_SRC_DECISION_CORNERS_H

#include "../algebra/Bernstein_form.h"

#include <corral/decision/Witness.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace corral::exact {

/// The signs of a polynomial at the corners of a box; bit k of the index chooses the upper end of axis k.
template <std::size_t D>
struct Corner_signs
{
  std::array<int, 1U << D> signs{};

  /// The strict sign that all corners share, or 0: then one is a zero or two have opposite signs.
  [[nodiscard]] int common() const
  {
    const bool same = std::all_of(signs.begin(), signs.end(), [&](int sign) { return sign == signs.front(); });
    return same ? signs.front() : 0;
  }
};

/// On [0,1]^D.
template <std::size_t D>
[[nodiscard]] Corner_signs<D> corner_signs(const Power_form<D>& power)
{
  std::array<Integer, 1U << D> sums; // of the coefficients of all terms with just these variables
  std::array<std::size_t, D> exponents{};
  for (const Integer& c : power.values) {
    unsigned variables = 0;
    for (std::size_t k = 0; k < D; ++k) variables |= exponents[k] > 0 ? 1U << k : 0U;
    if (c != 0) sums[variables] += c;
    for (std::size_t k = D; k-- > 0;) {
      if (++exponents[k] < power.size[k]) break;
      exponents[k] = 0;
    }
  }
  Corner_signs<D> result;
  for (unsigned corner = 0; corner < 1U << D; ++corner) {
    Integer value = 0;
    for (unsigned variables = 0; variables < 1U << D; ++variables)
      if ((variables & ~corner) == 0) value += sums[variables];
    result.signs[corner] = sgn(value);
  }
  return result;
}

/// numerator^e denominator^(degree - e) for each exponent e of the axis that occurs, 0 for others: powers of the value,
/// times one positive number.
template <std::size_t D>
[[nodiscard]] std::vector<Integer> powers_that_occur(const Polynomial<Integer, D>& f, std::size_t axis,
                                                     const Rational& value)
{
  const unsigned degree = f.degree(axis);
  std::vector<Integer> powers(degree + std::size_t{1});
  Integer denominator_power;
  for (const auto& term : f.terms()) {
    const unsigned e = term.exponents[axis];
    if (powers[e] != 0) continue;
    mpz_pow_ui(powers[e].get_mpz_t(), value.get_num_mpz_t(), e);
    mpz_pow_ui(denominator_power.get_mpz_t(), value.get_den_mpz_t(), degree - e);
    powers[e] *= denominator_power;
  }
  return powers;
}

/// \brief Of a polynomial with few terms, on a box.
/// \par Complexity  2^D D products and 2 D powers for each term.
template <std::size_t D>
[[nodiscard]] Corner_signs<D> corner_signs_of_terms(const Polynomial<Integer, D>& f, const Rational_box<D>& box)
{
  std::array<std::array<std::vector<Integer>, 2>, D> powers; // of both ends of each side, times one positive number
  for (std::size_t k = 0; k < D; ++k)
    for (const bool upper : {false, true})
      powers[k][upper ? 1 : 0] = powers_that_occur(f, k, upper ? box[k].upper() : box[k].lower());
  Corner_signs<D> result;
  for (unsigned corner = 0; corner < 1U << D; ++corner) {
    Integer sum = 0;
    for (const auto& term : f.terms()) {
      Integer product = term.coefficient;
      for (std::size_t k = 0; k < D; ++k) product *= powers[k][corner >> k & 1][term.exponents[k]];
      sum += product;
    }
    result.signs[corner] = sgn(sum);
  }
  return result;
}

template <std::size_t D>
[[nodiscard]] Corner_signs<D> corner_signs(const Bernstein_form<D>& form)
{
  Corner_signs<D> result;
  for (unsigned corner = 0; corner < 1U << D; ++corner) result.signs[corner] = sgn(form.corner(corner));
  return result;
}

template <std::size_t D>
[[nodiscard]] Rational_point<D> corner_of(const Rational_box<D>& box, unsigned corner)
{
  Rational_point<D> point;
  for (std::size_t k = 0; k < D; ++k) point[k] = (corner >> k & 1) != 0 ? box[k].upper() : box[k].lower();
  return point;
}

/// A corner that is a zero, or else two with opposite signs. \pre The signs have nothing in common.
template <std::size_t D>
[[nodiscard]] Sign_change<D> corner_witness(const Corner_signs<D>& corners, const Rational_box<D>& box)
{
  const auto at = [&](auto found) { return corner_of(box, static_cast<unsigned>(found - corners.signs.begin())); };
  const auto zero = std::find(corners.signs.begin(), corners.signs.end(), 0);
  if (zero != corners.signs.end()) return {at(zero), at(zero)};
  const auto other = std::find(corners.signs.begin(), corners.signs.end(), -corners.signs.front());
  return {at(corners.signs.begin()), at(other)};
}

} // namespace corral::exact

#endif
