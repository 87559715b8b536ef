// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_BOUNDERS_BERNSTEIN_BOUNDER_H
#define CORRAL_BOUNDERS_BERNSTEIN_BOUNDER_H

#include <corral/bounders/Range_bounder.h>
#include <corral/internal/bounders/Scaled_taylor.h>
#include <corral/polynomial/Box.h>

#include <array>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

namespace corral {

/// \brief Model of `RangeBounder`: the hull of the Bernstein coefficients of f on the box.
///
/// On the box f is a convex combination of them, and those at the corners are values of f, so that
/// the bound is exact where its ends come from corners. It is never wider than the centred form.
///
/// The coefficients come straight from the scaled Taylor form: the i-th Bernstein coefficient of
/// degree n of u^k on [-1, 1] is e_k(i ones, n - i minus ones) / binomial(n, k), a number between
/// -1 and 1 (e_k is the elementary symmetric polynomial; this is the polar form of u^k). No
/// subtraction of large binomials takes place at run time.
///
/// \tparam I  model of `IntervalNumber`. It does all the rounding; this class does none.
/// \par Complexity  The scaled Taylor coefficients, and N (n_1 + ... + n_D + D) multiplications for
///      degrees n_i and N = (n_1 + 1) ... (n_D + 1).
/// \par Reference  Garloff, "The Bernstein algorithm", Interval Computations 2 (1993); Farouki,
///      Rajan, "On the numerical condition of polynomials in Bernstein form", 1987; Ramshaw,
///      "Blossoms are polar forms", 1989.
template <IntervalNumber I, std::size_t D>
class Bernstein_bounder
{
public:
  using Interval = I;
  using Polynomial = corral::Polynomial<I, D>;
  using Box = corral::Box<I, D>;
  static constexpr std::size_t dimension = D;
  static constexpr std::string_view name = "bernstein";

  /// \throw Budget_exceeded as `Scaled_taylor`.
  explicit Bernstein_bounder(const Polynomial& f) : taylor_(f)
  {
    for (std::size_t axis = 0; axis < D; ++axis) conversion_[axis] = conversion(f.degree(axis));
  }

  /// \pre The sides of `box` are finite.
  [[nodiscard]] I bound(const Box& box) const
  {
    auto coefficients = dense(taylor_.expand(box));
    std::size_t stride = 1;
    for (std::size_t axis = D; axis-- > 0; stride *= conversion_[axis].size()) convert(coefficients, axis, stride);
    I range = coefficients.front();
    for (const I& b : coefficients) range = hull(range, b);
    return range;
  }

private:
  using Matrix = std::vector<std::vector<I>>; // one row for each Bernstein coefficient

  /// The Bernstein coefficients of u^0 ... u^n, column by column. Row i is made of the expansion
  /// of (1 + t)^i (1 - t)^(n - i), whose k-th coefficient is that symmetric polynomial.
  static Matrix conversion(unsigned n)
  {
    Matrix rows(n + 1);
    for (unsigned i = 0; i <= n; ++i) {
      std::vector<Integer> symmetric(n + 1, 0);
      symmetric[0] = 1;
      for (unsigned factor = 0; factor < n; ++factor)
        for (unsigned k = factor + 1; k > 0; --k) {
          if (factor < i)
            symmetric[k] += symmetric[k - 1];
          else
            symmetric[k] -= symmetric[k - 1];
        }
      for (unsigned k = 0; k <= n; ++k) {
        Integer binomial;
        mpz_bin_uiui(binomial.get_mpz_t(), n, k);
        Rational entry(symmetric[k], binomial);
        entry.canonicalize();
        rows[i].push_back(enclose<I>(entry));
      }
    }
    return rows;
  }

  /// The coefficient of every monomial in u up to the degrees, the last exponent fastest.
  [[nodiscard]] std::vector<I> dense(const Centred_polynomial<I, D>& f) const
  {
    std::size_t count = 1;
    std::array<std::vector<I>, D> powers;
    for (std::size_t axis = 0; axis < D; ++axis) {
      count *= conversion_[axis].size();
      powers[axis].assign(conversion_[axis].size(), f.radius[axis]);
      for (std::size_t k = 2; k < powers[axis].size(); ++k) powers[axis][k] = powers[axis][k - 1] * f.radius[axis];
    }
    std::vector<I> coefficients(count, I(0));
    for (const auto& term : f.taylor.terms()) {
      std::size_t place = 0;
      I scaled = term.coefficient;
      for (std::size_t axis = 0; axis < D; ++axis) {
        const std::size_t k = term.exponents[axis];
        place = place * conversion_[axis].size() + k;
        if (k > 0) scaled *= powers[axis][k];
      }
      coefficients[place] = std::move(scaled);
    }
    return coefficients;
  }

  /// Multiplies every line of coefficients along `axis` by the matrix of that axis.
  void convert(std::vector<I>& coefficients, std::size_t axis, std::size_t stride) const
  {
    const Matrix& matrix = conversion_[axis];
    const std::size_t size = matrix.size();
    std::vector<I> line(size);
    for (std::size_t start = 0; start < coefficients.size(); ++start) {
      if (start / stride % size != 0) continue;
      for (std::size_t k = 0; k < size; ++k) line[k] = coefficients[start + k * stride];
      for (std::size_t i = 0; i < size; ++i) {
        I sum = line[0]; // u^0 has only ones
        for (std::size_t k = 1; k < size; ++k) sum += matrix[i][k] * line[k];
        coefficients[start + i * stride] = std::move(sum);
      }
    }
  }

  Scaled_taylor<I, D> taylor_;
  std::array<Matrix, D> conversion_;
};

} // namespace corral

#endif
