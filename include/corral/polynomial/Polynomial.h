// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_POLYNOMIAL_POLYNOMIAL_H
#define CORRAL_POLYNOMIAL_POLYNOMIAL_H

#include <corral/number/Rational.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace corral {

/// The exponent of each variable in one term.
template <std::size_t D>
using Exponents = std::array<std::uint16_t, D>;

/// \brief A polynomial in D variables over the number type NT, as a list of terms.
///
/// The terms are sorted by exponents, lexicographically from variable 0, and no two share them.
/// Over an exact type no coefficient is zero; over an interval type a coefficient is dropped
/// only where the exact polynomial has none.
///
/// \tparam NT  a commutative ring: exact (`Rational`, `Integer`) or a model of `IntervalNumber`.
/// \tparam D   number of variables, at least 1.
template <class NT, std::size_t D>
class Polynomial
{
  static_assert(D >= 1, "corral::Polynomial needs at least one variable");

public:
  struct Term
  {
    Exponents<D> exponents{};
    NT coefficient{};
    friend bool operator==(const Term&, const Term&) = default;
  };
  using Coefficient = NT;
  static constexpr std::size_t dimension = D;

  /// The zero polynomial.
  Polynomial() = default;

  /// \pre `terms` is sorted by exponents, without repetition.
  explicit Polynomial(std::vector<Term> terms) : terms_(std::move(terms)) {}

  [[nodiscard]] const std::vector<Term>& terms() const { return terms_; }
  [[nodiscard]] bool is_zero() const { return terms_.empty(); }

  /// The highest exponent of variable `axis`; 0 for the zero polynomial.
  [[nodiscard]] unsigned degree(std::size_t axis) const
  {
    unsigned highest = 0;
    for (const Term& term : terms_) highest = std::max<unsigned>(highest, term.exponents[axis]);
    return highest;
  }

  /// The highest sum of exponents; 0 for the zero polynomial.
  [[nodiscard]] unsigned total_degree() const
  {
    unsigned highest = 0;
    for (const Term& term : terms_)
      highest = std::max(highest, std::accumulate(term.exponents.begin(), term.exponents.end(), 0U));
    return highest;
  }

  [[nodiscard]] bool is_constant() const { return total_degree() == 0; }

  friend bool operator==(const Polynomial&, const Polynomial&) = default;

private:
  std::vector<Term> terms_;
};

/// \brief The polynomial that has these terms, in any order; equal exponents are added up and
/// vanishing sums dropped.
/// \par Complexity  n log n comparisons for n terms.
template <class NT, std::size_t D>
[[nodiscard]] Polynomial<NT, D> collect(std::vector<typename Polynomial<NT, D>::Term> terms)
{
  std::sort(terms.begin(), terms.end(), [](const auto& a, const auto& b) { return a.exponents < b.exponents; });
  std::vector<typename Polynomial<NT, D>::Term> sums;
  for (auto& term : terms) {
    if (!sums.empty() && sums.back().exponents == term.exponents)
      sums.back().coefficient += term.coefficient;
    else {
      if (!sums.empty() && sums.back().coefficient == 0) sums.pop_back();
      sums.push_back(std::move(term));
    }
  }
  if (!sums.empty() && sums.back().coefficient == 0) sums.pop_back();
  return Polynomial<NT, D>(std::move(sums));
}

/// The constant polynomial `value`.
template <class NT, std::size_t D>
[[nodiscard]] Polynomial<NT, D> constant(const NT& value)
{
  return collect<NT, D>({{Exponents<D>{}, value}});
}

/// The polynomial x_axis.
template <class NT, std::size_t D>
[[nodiscard]] Polynomial<NT, D> variable(std::size_t axis)
{
  Exponents<D> exponents{};
  exponents[axis] = 1;
  return Polynomial<NT, D>({{exponents, NT(1)}});
}

/// Applies `function` to every coefficient, such as `enclose<I>`.
template <class To, class NT, std::size_t D, class Function>
[[nodiscard]] Polynomial<To, D> transform(const Polynomial<NT, D>& f, const Function& function)
{
  std::vector<typename Polynomial<To, D>::Term> terms;
  terms.reserve(f.terms().size());
  for (const auto& term : f.terms()) terms.push_back({term.exponents, function(term.coefficient)});
  return Polynomial<To, D>(std::move(terms));
}

/// The partial derivative with respect to variable `axis`. \par Complexity  one multiplication a term.
template <class NT, std::size_t D>
[[nodiscard]] Polynomial<NT, D> derivative(const Polynomial<NT, D>& f, std::size_t axis)
{
  std::vector<typename Polynomial<NT, D>::Term> terms;
  for (const auto& term : f.terms())
    if (const int exponent = term.exponents[axis]; exponent > 0) {
      auto lowered = term.exponents;
      --lowered[axis];
      terms.push_back({lowered, NT(term.coefficient * NT(exponent))});
    }
  return Polynomial<NT, D>(std::move(terms)); // lowering one exponent everywhere keeps the order
}

} // namespace corral

#endif
