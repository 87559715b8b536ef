// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Fast_plan.h"

#include "Exact_limits.h"

#include <corral/errors.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>
#include <utility>

namespace corral::fast {

namespace {

template <std::size_t D>
std::array<unsigned, D> padded_exponents(const Resolution<D>& resolution)
{
  std::array<unsigned, D> result;
  for (std::size_t axis = 0; axis < D; ++axis)
    result[axis] = static_cast<unsigned>(std::bit_width(resolution[axis] - 1));
  return result;
}

} // namespace

Rounding proved_rounding(std::size_t dimension, unsigned degree)
{
  constexpr double unit = 0x1p-53;
  const double additions = static_cast<double>(dimension) * (degree + 1.0);
  Rounding rounding;
  rounding.split = (additions + 1) * unit;
  rounding.evaluate = (2 * additions + 2) * unit;
  rounding.underflow = std::ldexp(1.0, std::max(-1000, static_cast<int>(degree) + 24 - 1074));
  rounding.sum = 1 + 0x1p-30;
  rounding.step = 1 + 0x1p-48;
  rounding.dropped = rounding.sum;
  return rounding;
}

template <std::size_t D>
Plan<D>::Plan(Monomial_shape<D> monomials, const Grid<D>& grid)
    : shape(std::move(monomials)), tree(grid.resolution()), resolution(grid.resolution()),
      cells_log2(padded_exponents(resolution)), root_level(*std::max_element(cells_log2.begin(), cells_log2.end())),
      leaf_level(std::min(root_level, static_cast<unsigned>(std::countr_zero(block_side<D>)))),
      rough_level(std::min(leaf_level + 1, root_level)), rounding(proved_rounding(D, shape.degree()))
{
  power_of_half.resize(shape.degree() + std::size_t{1});
  for (std::size_t d = 0; d < power_of_half.size(); ++d) power_of_half[d] = std::ldexp(1.0, -static_cast<int>(d));
  for (unsigned level = 0; level <= root_level; ++level)
    cell_share.push_back(std::ldexp(1.0, -static_cast<int>(level)));
  constexpr std::uint32_t most_cells = block_side<D> * std::uint32_t{leaf_blocks}; // of a leaf, along one axis
  static_assert(most_cells == 2U << corner_bits, "coordinates of corners are multiples of 2^-corner_bits");
  static_assert(most_cells * probe_pieces <= 2U << probe_bits, "those of probes, of 2^-probe_bits");
  for (std::size_t axis = 0; axis < D; ++axis) {
    linear[axis] = shape.pure_power(axis, 1);
    square[axis] = shape.pure_power(axis, 2);
    for (std::size_t k = 1; k < shape.size(); ++k)
      if (const double e = shape.exponents()[k][axis]; e > 0 && k != linear[axis])
        weights[axis].push_back({static_cast<std::uint32_t>(k), e, e * (e - 1)});
    const bool doubled = leaf_blocks == 2 && axis + 1 == D && root_level > leaf_level;
    leaf_cells[axis] = tree.span(leaf_level + (doubled ? 1 : 0), axis);
    for (std::size_t line = 0; line < lattice[axis].size(); ++line)
      lattice[axis][line] = std::min(1.0, -1.0 + 2.0 * static_cast<double>(line) / leaf_cells[axis]);
    sag[axis] = 0.5 / (leaf_cells[axis] * leaf_cells[axis]);
  }
  for (const auto& exponents : shape.exponents()) {
    int halvings = 0;
    for (std::size_t axis = 0; axis < D; ++axis)
      if (halves(leaf_level + 1, axis)) halvings += exponents[axis];
    leaf_scale.push_back(std::ldexp(1.0, -halvings));
  }
}

void throw_over_budget(std::uint64_t budget)
{
  throw Budget_exceeded("localize_fast: more than " + std::to_string(budget)
                        + " cells to plot; expected at most this budget");
}

template struct Plan<2>;
template struct Plan<3>;

} // namespace corral::fast
