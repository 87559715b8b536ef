// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_DECISION_INTERVAL_JET_H
#define CORRAL_SRC_DECISION_INTERVAL_JET_H

#include "../algebra/Bernstein_form.h"

#include <corral/number/Interval_number.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

/// \file
/// A polynomial and its gradient on the unit box by Bernstein coefficients over an interval number.
namespace corral::exact {

/// \brief Bernstein coefficients, last axis fastest, of a polynomial and of its derivative along each axis, all of the
/// same degrees. What is dropped of a high degree is part of the intervals.
///
/// Each is times one positive number. Derivatives are along the sides of the box.
template <IntervalNumber I, std::size_t D>
struct Interval_jet
{
  std::array<std::size_t, D> size{};          ///< degree + 1 for each axis
  std::array<std::vector<I>, D + 1> values{}; ///< of the polynomial, then of each derivative

  /// The value of the polynomial at a corner; bit k of `corner` chooses the upper end of axis k.
  [[nodiscard]] const I& corner(unsigned corner) const
  {
    std::size_t index = 0;
    for (std::size_t k = 0; k < D; ++k) index = index * size[k] + ((corner >> k & 1) != 0 ? size[k] - 1 : 0);
    return values[0][index];
  }
};

/// The strict sign that all values share, or 0.
template <IntervalNumber I>
[[nodiscard]] int common_sign(const std::vector<I>& values)
{
  const int sign = strict_sign(values.front());
  if (sign == 0) return 0;
  return std::all_of(values.begin(), values.end(), [&](const I& value) { return strict_sign(value) == sign; }) ? sign
                                                                                                               : 0;
}

/// The reciprocals of binomial coefficients as intervals, kept.
template <IntervalNumber I>
class Reciprocal_binomials
{
public:
  /// 1 / C(n, k) for k = 0, ..., n.
  [[nodiscard]] const std::vector<I>& operator()(std::size_t n)
  {
    if (rows_.size() <= n) rows_.resize(n + 1);
    auto& row = rows_[n];
    Integer binomial = 1;
    for (std::size_t k = row.size(); k <= n; binomial = binomial * (n - k) / (k + 1), ++k)
      row.push_back(enclose<I>(Rational(1, binomial)));
    return row;
  }

private:
  std::vector<std::vector<I>> rows_;
};

/// Makes intervals of integers and of their derivatives, without the terms that are too small to matter.
template <IntervalNumber I, std::size_t D>
class Jet_maker
{
public:
  /// \param power  on [0,1]^D. The maker keeps references to its arguments.
  /// \param precision  terms smaller by this power of two than the largest are dropped.
  Jet_maker(const Power_form<D>& power, Reciprocal_binomials<I>& binomials, long precision)
      : power_(power), binomials_(binomials)
  {
    std::array<long, D + 1> most{}; // bits of the largest coefficient
    for_each_term([&](const Integer& c, const std::array<std::size_t, D>& exponents) {
      for (std::size_t part = 0; part <= D; ++part)
        if (part == 0 || exponents[part - 1] > 0) most[part] = std::max(most[part], bits(c, exponents, part));
    });
    exponent_ = most[0];
    size_.fill(1);
    for_each_term([&](const Integer& c, const std::array<std::size_t, D>& exponents) {
      for (std::size_t part = 0; part <= D; ++part)
        if ((part == 0 || exponents[part - 1] > 0) && bits(c, exponents, part) + precision > most[part])
          for (std::size_t k = 0; k < D; ++k) size_[k] = std::max(size_[k], exponents[k] + 1);
    });
  }

  /// The polynomial alone (part 0) or its derivative along axis part - 1.
  [[nodiscard]] std::vector<I> make(std::size_t part) const
  {
    std::size_t count = 1;
    for (const std::size_t n : size_) count *= n;
    std::vector<I> values(count, I(0));
    unsigned long dropped = 0;
    long most = 0; // bits of the largest dropped term
    for_each_term([&](const Integer& c, std::array<std::size_t, D> exponents) {
      if (part > 0 && exponents[part - 1] == 0) return;
      for (std::size_t k = 0; k < D; ++k)
        if (exponents[k] >= size_[k]) {
          ++dropped;
          most = std::max(most, bits(c, exponents, part));
          return;
        }
      I value = scaled(c);
      if (part > 0) value *= I(exponents[part - 1]--);
      std::size_t index = 0;
      for (std::size_t k = 0; k < D; ++k) index = index * size_[k] + exponents[k];
      values[index] = value;
    });
    if (dropped > 0) {
      const I largest = scaled(Integer(1) << static_cast<mp_bitcnt_t>(most));
      values.front() += symmetric_hull(largest * I(dropped));
    }
    to_bernstein(values);
    return values;
  }

  [[nodiscard]] const std::array<std::size_t, D>& size() const { return size_; }

private:
  template <class Function>
  void for_each_term(const Function& function) const
  {
    std::array<std::size_t, D> exponents{};
    for (const Integer& c : power_.values) {
      if (c != 0) function(c, exponents);
      for (std::size_t k = D; k-- > 0;) {
        if (++exponents[k] < power_.size[k]) break;
        exponents[k] = 0;
      }
    }
  }

  /// The bits of a term of the polynomial (part 0) or of a derivative, rounded up.
  static long bits(const Integer& c, const std::array<std::size_t, D>& exponents, std::size_t part)
  {
    long factor = 0;
    if (part > 0)
      for (std::size_t e = exponents[part - 1]; e > 0; e >>= 1) ++factor;
    return static_cast<long>(mpz_sizeinbase(c.get_mpz_t(), 2)) + factor;
  }

  /// An interval around c * 2^-exponent_.
  [[nodiscard]] I scaled(const Integer& c) const { return enclose<I>(c, -exponent_); }

  /// Power coefficients become Bernstein coefficients.
  void to_bernstein(std::vector<I>& values) const
  {
    for (std::size_t axis = 0; axis < D; ++axis) {
      const std::size_t n = size_[axis] - 1;
      const auto& weights = binomials_(n);
      for_each_line(size_, axis, [&](std::size_t first, std::size_t stride) {
        I* c = &values[first];
        for (std::size_t i = 1; i <= n; ++i) // times 1 + x, a term more each time: no sum waits for the one before it
          for (std::size_t j = i; j > 0; --j) c[j * stride] += c[(j - 1) * stride];
        for (std::size_t j = 1; j < n; ++j) c[j * stride] *= weights[j];
      });
    }
  }

  const Power_form<D>& power_;
  Reciprocal_binomials<I>& binomials_;
  long exponent_ = 0;
  std::array<std::size_t, D> size_{};
};

} // namespace corral::exact

#endif
