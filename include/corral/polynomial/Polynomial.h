// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_POLYNOMIAL_POLYNOMIAL_H
#define CORRAL_POLYNOMIAL_POLYNOMIAL_H

#include <corral/errors.h>
#include <corral/number/Rational.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace corral {

/// The exponent of each variable in one term.
template <std::size_t D>
using Exponents = std::array<std::uint16_t, D>;

/// Says of a list of terms that it is what a `Polynomial` holds, so that only Debug builds look.
struct Sorted_terms
{
  explicit Sorted_terms() = default;
};

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

  /// \brief The polynomial of these terms; for terms in any order see `collect`.
  /// \throw Invalid_input unless they are sorted by exponents, without repetition, and over `Rational` and `Integer`
  ///        without a coefficient 0. \par Complexity  One comparison a term.
  explicit Polynomial(std::vector<Term> terms) : terms_(std::move(terms))
  {
    if (!is_well_formed()) detail::refuse_input(complaint);
  }
  /// \brief The same for terms of which this is known. \pre As there.
  Polynomial(Sorted_terms, std::vector<Term> terms) : terms_(std::move(terms))
  {
    CORRAL_PRECONDITION(is_well_formed(), complaint);
  }

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
  static constexpr const char* complaint =
      "Polynomial: given terms out of order, twice or with coefficient 0; expected what collect() makes of them";

  [[nodiscard]] bool is_well_formed() const
  {
    const auto is_out_of_order = [](const Term& a, const Term& b) { return a.exponents >= b.exponents; };
    if constexpr (std::same_as<NT, Rational> || std::same_as<NT, Integer>)
      if (std::any_of(terms_.begin(), terms_.end(), [](const Term& term) { return sgn(term.coefficient) == 0; }))
        return false;
    return std::adjacent_find(terms_.begin(), terms_.end(), is_out_of_order) == terms_.end();
  }

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
  return Polynomial<NT, D>(Sorted_terms(), std::move(sums));
}

/// The constant polynomial `value`.
template <class NT, std::size_t D>
[[nodiscard]] Polynomial<NT, D> constant(const NT& value)
{
  return collect<NT, D>({{Exponents<D>{}, value}});
}

/// The polynomial x_axis. \throw Invalid_input unless axis < D.
template <class NT, std::size_t D>
[[nodiscard]] Polynomial<NT, D> variable(std::size_t axis)
{
  if (axis >= D) detail::refuse_input("variable: given an axis that there is not; expected one below the dimension");
  Exponents<D> exponents{};
  exponents[axis] = 1;
  return Polynomial<NT, D>({{exponents, NT(1)}});
}

/// Applies `function` to every coefficient, such as `enclose<I>`. \pre Over an exact `To` it gives no zero.
template <class To, class NT, std::size_t D, class Function>
[[nodiscard]] Polynomial<To, D> transform(const Polynomial<NT, D>& f, const Function& function)
{
  std::vector<typename Polynomial<To, D>::Term> terms;
  terms.reserve(f.terms().size());
  for (const auto& term : f.terms()) terms.push_back({term.exponents, function(term.coefficient)});
  return Polynomial<To, D>(Sorted_terms(), std::move(terms));
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
  return Polynomial<NT, D>(Sorted_terms(), std::move(terms)); // lowering one exponent everywhere keeps the order
}

} // namespace corral

#endif
