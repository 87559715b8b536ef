// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_TEST_LOCALIZATION_RANDOM_CASES_H
#define CORRAL_TEST_LOCALIZATION_RANDOM_CASES_H

#include <corral/audit/Trouble_source.h>
#include <corral/localization/Grid.h>
#include <corral/polynomial/arithmetic.h>

/// \file
/// Polynomials and grids whose coefficients and sides fill the mantissa.
namespace corral::test {

template <std::size_t D>
Polynomial<Rational, D> random_polynomial(Trouble_source& random, unsigned degree)
{
  std::vector<typename Polynomial<Rational, D>::Term> terms;
  for (int count = static_cast<int>(random.integer(2, 14)); count > 0; --count) {
    Exponents<D> exponents{};
    for (auto left = static_cast<long>(degree); auto& e : exponents) {
      e = static_cast<std::uint16_t>(random.integer(0, left));
      left -= e;
    }
    terms.push_back({exponents, random.full_mantissa()});
  }
  auto f = collect<Rational, D>(std::move(terms));
  return f.is_zero() ? constant<Rational, D>(1) : f;
}

template <std::size_t D>
Grid<D> random_grid(Trouble_source& random, long most_cells)
{
  Rational_box<D> box;
  Resolution<D> resolution;
  for (std::size_t axis = 0; axis < D; ++axis) {
    const Rational lower = -abs(random.full_mantissa());
    const Rational least(1, random.integer(3, 99)); // drawn first by every compiler
    const Rational width = abs(random.full_mantissa()) + least;
    box[axis] = Rational_interval(lower, lower + width);
    resolution[axis] = static_cast<std::uint32_t>(random.integer(1, most_cells));
  }
  return {box, resolution};
}

template <std::size_t D, class Function>
void for_each_cell(const Resolution<D>& resolution, const Function& function)
{
  Cell<D> cell{};
  for (;;) {
    function(cell);
    std::size_t axis = 0;
    while (axis < D && ++cell[axis] == resolution[axis]) cell[axis++] = 0;
    if (axis == D) return;
  }
}

} // namespace corral::test

#endif
