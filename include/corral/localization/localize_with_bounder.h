// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_LOCALIZATION_LOCALIZE_WITH_BOUNDER_H
#define CORRAL_LOCALIZATION_LOCALIZE_WITH_BOUNDER_H

#include <corral/errors.h>
#include <corral/internal/localization/Bounder_form.h>
#include <corral/internal/polynomial/integer_form.h>
#include <corral/number/Counted.h>

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

namespace detail {

/// Subdivides under the scopes that are alive.
template <RangeBounder B, class F>
[[nodiscard]] Raster<B::dimension> subdivide_with(std::vector<F> system, std::vector<B> bounders,
                                                  const Grid<B::dimension>& grid, const Run_options& run,
                                                  const Cell_options& options, const Counting_scope& counting)
{
  const auto start = std::chrono::steady_clock::now();
  Bounder_form<B, F> form(std::move(system), std::move(bounders), grid, run, options);
  subdivide(Subdivision_tree<B::dimension>(grid.resolution()), form);
  Work_counters counters = form.counters();
  counters.additions = counting.counts().additions;
  counters.multiplications = counting.counts().multiplications;
  counters.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return form.take().finish(grid, is_guaranteed<typename B::Interval>, counters);
}

} // namespace detail

/// \brief `localize` by subdivision, each box bounded afresh from the polynomials, as the paper does; any dimension.
///
/// No cell that holds a common zero is lost if the bounder's number type is guaranteed; the result says whether it is.
/// Memory is proportional to the cells found.
///
/// \tparam I    model of `IntervalNumber`.
/// \param  make turns a `Polynomial<I, D>` into a model of `RangeBounder`.
/// \throw Invalid_input if there is no polynomial or one is zero (every point is a zero); Budget_exceeded if there are
///        more plotted cells than `run.cell_budget`, 50 million by default; Unsafe_environment.
/// \par Complexity  2^D bounds a polynomial for each box that is cut, in one thread.
/// \par Reference  Suffern, "Quadtree algorithms for contouring functions of two variables", The Computer Journal 33
///      (1990); Shou et al. (2005), see `Recursive_taylor_bounder`.
template <IntervalNumber I, std::size_t D, class Make>
[[nodiscard]] Raster<D> localize(const std::vector<Polynomial<Rational, D>>& system, const Grid<D>& grid,
                                 const Run_options& run, const Cell_options& options, const Make& make)
{
  using Bounder = decltype(make(std::declval<const Polynomial<I, D>&>()));
  if (system.empty()) throw Invalid_input("localize: given no polynomial; expected at least one");
  const Arithmetic_scope<I> scope;
  const Counting_scope counting;
  std::vector<Polynomial<I, D>> enclosed;
  std::vector<Bounder> bounders;
  for (const auto& f : system) {
    if (f.is_zero()) throw Invalid_input("localize: given the zero polynomial, of which every point is a zero");
    enclosed.push_back(enclosure_for_localization<I>(f));
    bounders.push_back(make(enclosed.back()));
  }
  return detail::subdivide_with(std::move(enclosed), std::move(bounders), grid, run, options, counting);
}

/// \brief The same with one kind of bounder: `localize<Recursive_taylor_bounder<Outward_interval, 2>>(f, grid)`.
template <RangeBounder B>
[[nodiscard]] Raster<B::dimension> localize(const std::vector<Polynomial<Rational, B::dimension>>& system,
                                            const Grid<B::dimension>& grid, const Run_options& run = {},
                                            const Cell_options& options = {})
{
  return localize<typename B::Interval, B::dimension>(system, grid, run, options,
                                                      [](const typename B::Polynomial& f) { return B(f); });
}
template <RangeBounder B>
[[nodiscard]] Raster<B::dimension> localize(const Polynomial<Rational, B::dimension>& f, const Grid<B::dimension>& grid,
                                            const Run_options& run = {}, const Cell_options& options = {})
{
  return localize<B>(std::vector{f}, grid, run, options);
}

/// \brief The same for what a bounder bounds, which need not be known otherwise. Sampling asks the bounder for the
/// values at corners, so that an exact zero there may be missed.
template <RangeBounder B>
[[nodiscard]] Raster<B::dimension> localize(const B& bounder, const Grid<B::dimension>& grid,
                                            const Run_options& run = {}, const Cell_options& options = {})
{
  const Arithmetic_scope<typename B::Interval> scope;
  const Counting_scope counting;
  return detail::subdivide_with(std::vector{bounder}, std::vector{bounder}, grid, run, options, counting);
}

} // namespace corral

#endif
