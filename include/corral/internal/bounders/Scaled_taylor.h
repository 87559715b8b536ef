// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_INTERNAL_BOUNDERS_SCALED_TAYLOR_H
#define CORRAL_INTERNAL_BOUNDERS_SCALED_TAYLOR_H

#include <corral/bounders/Range_bounder.h>
#include <corral/errors.h>
#include <corral/polynomial/Box.h>
#include <corral/polynomial/Polynomial.h>

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace corral {

/// \brief A polynomial in the coordinates of a box: f(c + r u) with c the centre, r the half-widths and u in
/// [-1, 1]^D. The Taylor coefficients stand apart from the powers of r, so that a sum over them can be taken by
/// Horner's rule in r.
template <IntervalNumber I, std::size_t D>
struct Centred_polynomial
{
  Polynomial<I, D> taylor; ///< f(c + v) as a polynomial in v
  std::array<I, D> radius; ///< points
};

/// \brief Expands one fixed polynomial about the centres of many boxes.
///
/// The Taylor coefficients come by synthetic division, variable by variable, so that all derivatives share their
/// work: a polynomial of degree n costs about n^2/2 multiplications a line, where evaluating each derivative by
/// itself costs one for each power of each of its terms. Coefficients that vanish identically are never computed.
///
/// \tparam I  model of `IntervalNumber`. It does all the rounding; this class does none.
template <IntervalNumber I, std::size_t D>
class Scaled_taylor
{
public:
  static constexpr std::size_t max_coefficients = std::size_t{1} << 22;

  /// \throw Budget_exceeded if f has more than `max_coefficients` monomials up to its degrees.
  explicit Scaled_taylor(const Polynomial<I, D>& f)
  {
    double count = 1;
    for (std::size_t axis = 0; axis < D; ++axis) count *= static_cast<double>(size_[axis] = f.degree(axis) + 1);
    if (count > static_cast<double>(max_coefficients))
      throw Budget_exceeded("Taylor expansion: " + std::to_string(static_cast<std::size_t>(count))
                            + " monomials up to the degrees; expected at most " + std::to_string(max_coefficients));
    std::size_t stride = 1;
    for (std::size_t axis = D; axis-- > 0; stride *= size_[axis]) stride_[axis] = stride;
    coefficients_.assign(stride, I(0));
    std::vector<bool> is_present(stride);
    for (const auto& term : f.terms()) {
      std::size_t place = 0;
      for (std::size_t axis = 0; axis < D; ++axis) place += term.exponents[axis] * stride_[axis];
      coefficients_[place] = term.coefficient;
      is_present[place] = true;
    }
    for (std::size_t axis = D; axis-- > 0;) plan(axis, is_present);
    list_monomials(is_present);
  }

  /// The exponents that an expansion has, sorted; with each come all that it dominates.
  [[nodiscard]] std::vector<Exponents<D>> exponents() const
  {
    std::vector<Exponents<D>> result;
    for (const auto& monomial : monomials_) result.push_back(monomial.first);
    return result;
  }

  /// \pre The sides of `box` are finite.
  [[nodiscard]] Centred_polynomial<I, D> expand(const Box<I, D>& box) const
  {
    Centred_polynomial<I, D> result;
    auto values = coefficients_;
    for (std::size_t axis = D; axis-- > 0;) {
      const I centre = midpoint(box[axis]);
      result.radius[axis] = radius(box[axis], centre);
      for (const Line& line : lines_[axis]) shift(values, line, stride_[axis], centre);
    }
    std::vector<typename Polynomial<I, D>::Term> terms;
    terms.reserve(monomials_.size());
    for (const auto& [exponents, place] : monomials_) terms.push_back({exponents, std::move(values[place])});
    result.taylor = Polynomial<I, D>(Sorted_terms(), std::move(terms));
    return result;
  }

private:
  /// A univariate polynomial among the coefficients, to be shifted.
  struct Line
  {
    std::size_t start;
    std::vector<bool> is_present; // up to the highest power
  };

  /// Lists the lines along `axis` and what their shift makes present.
  void plan(std::size_t axis, std::vector<bool>& is_present)
  {
    for (std::size_t start = 0; start < is_present.size(); ++start) {
      if (start / stride_[axis] % size_[axis] != 0) continue;
      Line line{start, {}};
      for (std::size_t k = size_[axis]; k-- > 0;) {
        const std::size_t place = start + k * stride_[axis];
        if (line.is_present.empty() && is_present[place]) line.is_present.resize(k + 1);
        if (line.is_present.empty()) continue;
        line.is_present[k] = is_present[place];
        is_present[place] = true;
      }
      if (line.is_present.size() > 1) lines_[axis].push_back(std::move(line));
    }
  }

  void list_monomials(const std::vector<bool>& is_present)
  {
    for (std::size_t place = 0; place < is_present.size(); ++place) {
      if (!is_present[place]) continue;
      Exponents<D> exponents;
      for (std::size_t axis = 0; axis < D; ++axis)
        exponents[axis] = static_cast<std::uint16_t>(place / stride_[axis] % size_[axis]);
      monomials_.emplace_back(exponents, place);
    }
  }

  /// Replaces p(x) by p(centre + v). The first pass of the synthetic division fills the gaps.
  static void shift(std::vector<I>& values, const Line& line, std::size_t stride, const I& centre)
  {
    const std::size_t top = line.is_present.size() - 1;
    const auto at = [&](std::size_t k) -> I& { return values[line.start + k * stride]; };
    for (std::size_t first = 0; first < top; ++first)
      for (std::size_t k = top; k-- > first;) {
        I carried = at(k + 1) * centre;
        if (first > 0 || line.is_present[k])
          at(k) += carried;
        else
          at(k) = std::move(carried);
      }
  }

  std::array<std::size_t, D> size_;
  std::array<std::size_t, D> stride_;
  std::vector<I> coefficients_; // of every monomial up to the degrees, the last exponent fastest
  std::array<std::vector<Line>, D> lines_;
  std::vector<std::pair<Exponents<D>, std::size_t>> monomials_; // of the expansion, sorted, with their places
};

} // namespace corral

#endif
