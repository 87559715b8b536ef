// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_LOCALIZATION_LOCALIZE_H
#define CORRAL_LOCALIZATION_LOCALIZE_H

#include <corral/Run_options.h>
#include <corral/localization/Raster.h>
#include <corral/polynomial/Polynomial.h>

#include <cstddef>
#include <vector>

namespace corral {

/// \brief The cells of a grid through which the zero set of a polynomial may pass, by subdividing a Taylor form.
///
/// The polynomial is mapped exactly onto the grid and then kept, for every node of the 2^D-tree, in the node's own
/// coordinates as doubles with a bound of every rounding error so far. Blocks of cells are decided together from the
/// values at their corners. Where there are few terms of high degree, nodes are bounded by the terms instead; repeated
/// factors are taken out where that matters. `empty` and `hit` are proved, whatever the coefficients; all else is
/// `unknown`. The cells are the same, bit for bit, for every instruction set and number of threads. Of the counters,
/// `bounds` tells the nodes of the tree and `seconds` the time. A run that is stopped keeps the parts of the tree that
/// are decided by then.
///
/// \throw Invalid_input for the zero polynomial; Budget_exceeded if there are more plotted cells than
///        `run.cell_budget`, where it is given, or the polynomial has too many coefficients; Unsafe_environment.
/// \par Complexity  Time and memory proportional to the plotted cells; a node costs O(n^(D+1)) for degree n where n
///      falls to 2 towards the cells. Proofs: doc/taylor_form.md.
template <std::size_t D>
[[nodiscard]] Raster<D> localize(const Polynomial<Rational, D>& f, const Grid<D>& grid, const Run_options& run = {});

/// \brief The same for a system: a cell is plotted unless one of the polynomials has no zero in it.
///
/// All polynomials are subdivided together, so that a node which one of them drops is dropped for all. With several
/// polynomials no cell is a `hit`.
/// \throw As above; Invalid_input if `system` is empty.
/// \par Complexity  Time and memory proportional to the cells plotted in the end, those of a space curve, not of the
/// surfaces.
template <std::size_t D>
[[nodiscard]] Raster<D> localize(const std::vector<Polynomial<Rational, D>>& system, const Grid<D>& grid,
                                 const Run_options& run = {});

namespace detail {

template <std::size_t D>
struct Fast_engine
{
  static_assert(D == 2 || D == 3,
                "localize works in two and three dimensions: its blocks of cells are 8 x 8 pixels "
                "and 4 x 4 x 4 voxels. With a bounder (localize_with_bounder.h) it takes any dimension");
  [[noreturn]] static Raster<D> refuse();
};

} // namespace detail

/// Other dimensions do not compile, and `Fast_engine` says why.
template <std::size_t D>
  requires(D != 2 && D != 3)
[[nodiscard]] Raster<D> localize(const Polynomial<Rational, D>&, const Grid<D>&, const Run_options& = {})
{
  return detail::Fast_engine<D>::refuse();
}
template <std::size_t D>
  requires(D != 2 && D != 3)
[[nodiscard]] Raster<D> localize(const std::vector<Polynomial<Rational, D>>&, const Grid<D>&, const Run_options& = {})
{
  return detail::Fast_engine<D>::refuse();
}

extern template Raster<2> localize<2>(const Polynomial<Rational, 2>&, const Grid<2>&, const Run_options&);
extern template Raster<3> localize<3>(const Polynomial<Rational, 3>&, const Grid<3>&, const Run_options&);
extern template Raster<2> localize<2>(const std::vector<Polynomial<Rational, 2>>&, const Grid<2>&, const Run_options&);
extern template Raster<3> localize<3>(const std::vector<Polynomial<Rational, 3>>&, const Grid<3>&, const Run_options&);

} // namespace corral

#endif
