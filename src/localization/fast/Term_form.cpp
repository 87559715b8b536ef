// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Term_form.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace corral::fast {
namespace {

/// All exponents of one total degree.
template <std::size_t D>
std::vector<Exponents<D>> exponents_of_degree(unsigned degree)
{
  std::vector<Exponents<D>> result;
  Exponents<D> e{};
  const auto choose = [&](const auto& self, std::size_t axis, unsigned left) -> void {
    e[axis] = static_cast<std::uint16_t>(left);
    if (axis + 1 == D) return result.push_back(e);
    for (unsigned k = 0; k <= left; ++k) {
      e[axis] = static_cast<std::uint16_t>(k);
      self(self, axis + 1, left - k);
    }
  };
  choose(choose, 0, degree);
  return result;
}

/// A power of two times the polynomial, with coefficients of at most 2.
template <std::size_t D>
Polynomial<Rational, D> reduced(const Polynomial<Rational, D>& f)
{
  long exponent = std::numeric_limits<long>::min();
  for (const auto& term : f.terms())
    exponent = std::max(exponent, static_cast<long>(mpz_sizeinbase(term.coefficient.get_num_mpz_t(), 2))
                                      - static_cast<long>(mpz_sizeinbase(term.coefficient.get_den_mpz_t(), 2)));
  const auto shift = static_cast<mp_bitcnt_t>(std::abs(exponent));
  return transform<Rational>(f, [&](const Rational& c) {
    Rational result;
    (exponent > 0 ? mpq_div_2exp : mpq_mul_2exp)(result.get_mpq_t(), c.get_mpq_t(), shift);
    return result;
  });
}

/// The number of divisors of the term that has most of them.
template <std::size_t D>
double most_divisors(const Polynomial<Rational, D>& f)
{
  double most = 0;
  for (const auto& term : f.terms()) {
    double divisors = 1;
    for (const auto e : term.exponents) divisors *= e + 1.0;
    most = std::max(most, divisors);
  }
  return most;
}

/// The logarithm of the largest power product of a term on the padded grid, if that is more than 1.
template <std::size_t D>
double range_bits(const Polynomial<Rational, D>& f, const Grid<D>& grid)
{
  std::array<double, D> reach;
  for (std::size_t axis = 0; axis < D; ++axis) {
    const Rational& lower = grid.box()[axis].lower();
    const Rational upper = lower + grid.step(axis) * std::bit_ceil(grid.resolution()[axis]);
    reach[axis] = std::max({1.0, std::abs(lower.get_d()), std::abs(upper.get_d())});
  }
  double most = 0;
  for (const auto& term : f.terms()) {
    double bits = 0;
    for (std::size_t axis = 0; axis < D; ++axis) bits += term.exponents[axis] * std::log2(reach[axis]);
    most = std::max(most, bits);
  }
  return most;
}

} // namespace

template <std::size_t D>
bool Term_form<D>::has_few_terms(const Polynomial<Rational, D>& f)
{
  return 4 * static_cast<double>(f.terms().size()) <= most_divisors(f);
}

template <std::size_t D>
bool Term_form<D>::suits(const Polynomial<Rational, D>& f, const Grid<D>& grid)
{
  if (!has_few_terms(f)) return false;
  const double bits = range_bits(f, grid);
  // Values beyond doubles cannot be told from each other; but a dense form of such a size would be no help, either.
  constexpr double most_coefficients = 1 << 16;
  if (bits > 900) return most_divisors(f) > most_coefficients;
  // In nanoseconds, from measurements. A dense form has to be made anew in many nodes if rounding at the root hides f.
  const double roots = bits > 40 ? 50 : 1;
  const double dense = 16 * most_divisors(f) * f.total_degree() * roots;
  const double side = *std::max_element(grid.resolution().begin(), grid.resolution().end());
  const double sparse = (D == 2 ? 500 : 2500) * static_cast<double>(f.terms().size()) * std::pow(side, D - 1.0);
  return dense >= sparse;
}

template <std::size_t D>
std::vector<Exponents<D>> Term_form<D>::model_monomials()
{
  std::vector<Exponents<D>> result;
  for (unsigned d = 0; d <= model_degree; ++d)
    for (const auto& exponents : exponents_of_degree<D>(d)) result.push_back(exponents);
  return result;
}

template <std::size_t D>
Term_form<D>::Term_form(const Polynomial<Rational, D>& given, const std::vector<Exponents<D>>& low_orders)
{
  const auto f = reduced(given);
  collect_powers(f);
  for (const auto& orders : low_orders) low_.push_back(coefficient(f, orders));
  for (const auto& orders : exponents_of_degree<D>(model_degree + 1)) next_.push_back(coefficient(f, orders));
}

template <std::size_t D>
void Term_form<D>::collect_powers(const Polynomial<Rational, D>& f)
{
  for (std::size_t axis = 0; axis < D; ++axis) {
    std::set<unsigned> powers{0};
    for (const auto& term : f.terms())
      for (unsigned order = 0; order <= model_degree + 1; ++order)
        if (const unsigned e = term.exponents[axis]; e >= order) powers.insert(e - order);
    powers_[axis].assign(powers.begin(), powers.end());
  }
}

template <std::size_t D>
auto Term_form<D>::coefficient(const Polynomial<Rational, D>& f, const Exponents<D>& orders) const -> Coefficient
{
  Coefficient result{orders, {}};
  for (const auto& term : f.terms()) {
    Integer binomials = 1;
    Term lowered;
    for (std::size_t axis = 0; axis < D && binomials != 0; ++axis) {
      Integer binomial; // 0 if the exponent is below the order
      mpz_bin_uiui(binomial.get_mpz_t(), term.exponents[axis], orders[axis]);
      binomials *= binomial;
      if (binomial == 0) break;
      const auto& powers = powers_[axis];
      const unsigned exponent = term.exponents[axis] - unsigned{orders[axis]};
      const auto place = std::lower_bound(powers.begin(), powers.end(), exponent) - powers.begin();
      lowered.power[axis] = static_cast<std::uint32_t>(place);
    }
    if (binomials == 0) continue;
    lowered.coefficient = enclose<Interval>(Rational(term.coefficient * binomials));
    result.terms.push_back(lowered);
  }
  return result;
}

template class Term_form<2>;
template class Term_form<3>;

} // namespace corral::fast
