// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_LOCALIZATION_LOCALIZE_H
#define CORRAL_LOCALIZATION_LOCALIZE_H

#include <corral/errors.h>
#include <corral/localization/Bounder_form.h>
#include <corral/number/Counted.h>
#include <corral/polynomial/integer_form.h>

#include <algorithm>
#include <chrono>
#include <concepts>
#include <cstddef>
#include <utility>
#include <vector>

namespace corral {

/// \brief The polynomial over I that `localize` bounds in place of f: with the same zeros, and without rounding
/// where f times a positive integer has coefficients that doubles hold exactly, so that exact zeros at grid points can
/// be certified. A number type without guarantee gets f as it is, as the paper's programs did.
template <IntervalNumber I, std::size_t D>
[[nodiscard]] Polynomial<I, D> enclosure_for_localization(const Polynomial<Rational, D>& f)
{
  if constexpr (is_guaranteed<I>) {
    const auto primitive = integer_primitive(f);
    const auto is_small = [](const auto& term) { return mpz_sizeinbase(term.coefficient.get_mpz_t(), 2) <= 53; };
    if (std::all_of(primitive.terms().begin(), primitive.terms().end(), is_small))
      return transform<I>(primitive, [](const Integer& c) { return enclose<I>(Rational(c)); });
  }
  return transform<I>(f, [](const Rational& c) { return enclose<I>(c); });
}

/// \brief Finds the cells of a grid through which the common zero set of polynomials may pass, by subdivision.
///
/// No cell that holds a common zero is lost if the bounder's number type is guaranteed; the result says whether it is.
/// Memory is proportional to the cells found.
///
/// \tparam I    model of `IntervalNumber`.
/// \param  make turns a `Polynomial<I, D>` into a model of `RangeBounder`.
/// \throw Invalid_input if there is no polynomial or one is zero (every point is a zero); Budget_exceeded;
///        Cancelled; Unsafe_environment.
/// \par Complexity  2^D bounds a polynomial for each box that is cut.
/// \par Reference  Suffern, "Quadtree algorithms for contouring functions of two variables", The Computer Journal 33
///      (1990); Shou et al. (2005), see `Recursive_taylor_bounder`.
template <IntervalNumber I, std::size_t D, class Make>
[[nodiscard]] Localization<D> localize(const std::vector<Polynomial<Rational, D>>& system, const Grid<D>& grid,
                                       const Localization_options& options, const Make& make)
{
  using Bounder = decltype(make(std::declval<const Polynomial<I, D>&>()));
  if (system.empty()) throw Invalid_input("localize: given no polynomial; expected at least one");
  const auto start = std::chrono::steady_clock::now();
  const Arithmetic_scope<I> scope;
  const Counting_scope counting;
  std::vector<Polynomial<I, D>> enclosed;
  std::vector<Bounder> bounders;
  for (const auto& f : system) {
    if (f.is_zero()) throw Invalid_input("localize: given the zero polynomial, of which every point is a zero");
    enclosed.push_back(enclosure_for_localization<I>(f));
    bounders.push_back(make(enclosed.back()));
  }
  Bounder_form<Bounder> form(std::move(enclosed), std::move(bounders), grid, options);
  subdivide(Subdivision_tree<D>(grid.resolution()), form);
  Localization<D> result = form.take();
  result.is_guaranteed = is_guaranteed<I>;
  result.counters.additions = counting.counts().additions;
  result.counters.multiplications = counting.counts().multiplications;
  result.counters.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

/// \brief `localize` with one bounder, such as `localize<Recursive_taylor_bounder<Outward_interval, 2>>({f}, grid)`.
template <RangeBounder B>
[[nodiscard]] Localization<B::dimension> localize(const std::vector<Polynomial<Rational, B::dimension>>& system,
                                                  const Grid<B::dimension>& grid,
                                                  const Localization_options& options = {})
{
  return localize<typename B::Interval, B::dimension>(system, grid, options,
                                                      [](const typename B::Polynomial& f) { return B(f); });
}

} // namespace corral

#endif
