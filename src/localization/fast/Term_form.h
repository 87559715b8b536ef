// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_LOCALIZATION_FAST_TERM_FORM_H
#define CORRAL_SRC_LOCALIZATION_FAST_TERM_FORM_H

#include <corral/localization/Grid.h>
#include <corral/number/Outward_interval.h>
#include <corral/polynomial/Polynomial.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace corral::fast {

/// \brief A polynomial with few terms and high degree, and its Taylor coefficients of low order, as sums of terms.
///
/// A Taylor form in the coordinates of a node has as many coefficients as the terms have divisors, and at the root it
/// is much larger than the polynomial near its zeros. The terms have neither fault: they can be bounded in every node
/// anew, see `Term_bounds`.
template <std::size_t D>
class Term_form
{
public:
  using Interval = Outward_interval;

  /// The degree of the forms of small nodes.
  static constexpr unsigned model_degree = D == 2 ? 3 : 2;

  /// Whether the terms are few beside the coefficients of a dense form.
  [[nodiscard]] static bool has_few_terms(const Polynomial<Rational, D>& f);

  /// Whether to do without a dense form on this grid: the terms are few and, it seems, less work.
  [[nodiscard]] static bool suits(const Polynomial<Rational, D>& f, const Grid<D>& grid);

  /// All monomials up to `model_degree`.
  [[nodiscard]] static std::vector<Exponents<D>> model_monomials();

  /// A product of a coefficient and one power of each coordinate, by its place in the list of powers.
  struct Term
  {
    Interval coefficient;
    std::array<std::uint32_t, D> power;
  };
  /// A partial derivative over the factorials of its orders: what Taylor's formula multiplies by a power product.
  struct Coefficient
  {
    Exponents<D> orders;
    std::vector<Term> terms;
  };

  /// \param low_orders  those up to `model_degree`, 0 first, in any order.
  Term_form(const Polynomial<Rational, D>& f, const std::vector<Exponents<D>>& low_orders);

  /// The Taylor coefficients up to `model_degree`, in the order given; the first is f itself.
  [[nodiscard]] const std::vector<Coefficient>& low() const { return low_; }
  /// The Taylor coefficients of degree `model_degree` + 1.
  [[nodiscard]] const std::vector<Coefficient>& next() const { return next_; }
  /// The exponents of one coordinate that occur, and 0, in increasing order.
  [[nodiscard]] const std::vector<unsigned>& powers(std::size_t axis) const { return powers_[axis]; }

private:
  void collect_powers(const Polynomial<Rational, D>& f);
  [[nodiscard]] Coefficient coefficient(const Polynomial<Rational, D>& f, const Exponents<D>& orders) const;

  std::array<std::vector<unsigned>, D> powers_;
  std::vector<Coefficient> low_;
  std::vector<Coefficient> next_;
};

extern template class Term_form<2>;
extern template class Term_form<3>;

} // namespace corral::fast

#endif
