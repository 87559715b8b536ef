// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_TEST_LOCALIZATION_CLOSE_CASES_H
#define CORRAL_TEST_LOCALIZATION_CLOSE_CASES_H

#include "random_cases.h"

#include <corral/audit/Trouble_source.h>
#include <corral/polynomial/arithmetic.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

/// \file
/// Curves and surfaces through grid points, or past them by some units in the last place of their coefficients.
namespace corral::test {

/// To 53 bits at most, or fewer.
inline Rational rounded(const Rational& x, int bits = 53)
{
  if (x == 0) return 0;
  const long exponent =
      static_cast<long>(mpz_sizeinbase(x.get_num_mpz_t(), 2)) - static_cast<long>(mpz_sizeinbase(x.get_den_mpz_t(), 2));
  const Rational scaled = x * Trouble_source::scaled(1, bits - 1 - exponent);
  return Trouble_source::scaled(Integer(scaled.get_num() / scaled.get_den()), exponent - bits + 1);
}

template <std::size_t D>
Polynomial<Rational, D> rounded(const Polynomial<Rational, D>& f, int bits)
{
  return transform<Rational>(f, [&](const Rational& c) { return rounded(c, bits); });
}

template <std::size_t D>
Polynomial<Rational, D> monomial(const Rational& c, const Exponents<D>& exponents)
{
  return collect<Rational, D>({{exponents, c}});
}

/// A positive number of so many bits.
inline Rational random_number(Trouble_source& random, int bits) { return rounded(abs(random.full_mantissa()), bits); }

/// \brief A line or plane that passes grid points in great number: its slopes are small fractions but for a few units
/// in the last place, and it passes through some grid point, or so.
template <std::size_t D>
Polynomial<Rational, D> close_plane(Trouble_source& random, const Grid<D>& grid, int bits)
{
  const Rational scale = random_number(random, bits);
  const auto moved = [&](const Rational& x) { // by up to two units, in half of the cases
    const Rational unit = abs(x) * Trouble_source::scaled(1, 1 - bits);
    return random.chance(2) ? x : rounded(x + unit * random.integer(-2, 2), bits);
  };
  Polynomial<Rational, D> f;
  Rational value = 0;
  for (std::size_t axis = 0; axis < D; ++axis) {
    Exponents<D> exponents{};
    exponents[axis] = 1;
    const Rational slope = moved(rounded(scale * random.integer(1, 3) * (random.chance(2) ? -1 : 1), bits));
    f = f + monomial<D>(slope, exponents);
    value += slope * grid.line(axis, static_cast<std::uint32_t>(random.integer(0, grid.resolution()[axis])));
  }
  return f - constant<Rational, D>(moved(random.chance(2) ? value : rounded(value, bits)));
}

/// A box with dyadic ends as a rule.
template <std::size_t D>
Grid<D> close_grid(Trouble_source& random, std::uint32_t cells)
{
  const bool symmetric = random.chance(2);
  const Rational width = Trouble_source::scaled(1, random.integer(-4, 1));
  Rational_box<D> box;
  Resolution<D> resolution;
  for (std::size_t axis = 0; axis < D; ++axis) {
    Rational lower = symmetric ? Rational(-width) : Rational(width * random.integer(-3, 3) / 4);
    if (random.chance(8)) lower += Rational(1, 3);
    box[axis] = Rational_interval(lower, lower + 2 * width);
    resolution[axis] = random.chance(8) ? static_cast<std::uint32_t>(random.integer(1, long{cells})) : cells;
  }
  return {box, resolution};
}

/// All monomials of low degree, with coefficients of full mantissas times 2^exponent.
template <std::size_t D>
Polynomial<Rational, D> small_terms(Trouble_source& random, unsigned degree, long exponent)
{
  return random_polynomial<D>(random, degree) * constant<Rational, D>(Trouble_source::scaled(1, exponent));
}

/// A product of planes that are close to the same grid points, each other, or nothing; some have small extra terms.
template <std::size_t D>
Polynomial<Rational, D> close_product(Trouble_source& random, const Grid<D>& grid, unsigned factors)
{
  const int bits = random.chance(2) ? 53 : static_cast<int>(random.integer(3, 53));
  const auto plane = close_plane<D>(random, grid, bits);
  auto f = plane;
  for (unsigned k = 1; k < factors; ++k) f = f * (random.chance(2) ? plane : close_plane<D>(random, grid, bits));
  if (random.chance(2)) f = f * (constant<Rational, D>(1) + small_terms<D>(random, 2, -4));
  f = rounded(f, random.chance(2) ? bits : 53);
  return random.chance(3) ? f + small_terms<D>(random, 3, -random.integer(50, 70)) : f;
}

/// A plane and one term of so high a degree that the few terms are taken for themselves.
template <std::size_t D>
Polynomial<Rational, D> close_and_sparse(Trouble_source& random, const Grid<D>& grid)
{
  Exponents<D> high;
  for (auto& e : high) e = static_cast<std::uint16_t>(D == 2 ? random.integer(10, 16) : random.integer(8, 14));
  const Rational size = random.chance(2) ? Rational(1) : random.full_mantissa();
  return close_plane<D>(random, grid, 53) + monomial<D>(size, high);
}

/// A difference of powers that are equal, or nearly so, at points of the diagonal.
template <std::size_t D>
Polynomial<Rational, D> close_powers(Trouble_source& random)
{
  const auto degree = static_cast<std::uint16_t>(random.integer(16, 26));
  const Rational size = random_number(random, 53);
  Polynomial<Rational, D> f;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    Exponents<D> exponents{};
    exponents[axis] = degree;
    if (D == 3) exponents[2] = degree; // so that there are many divisors
    const Rational moved = size + Trouble_source::scaled(random.chance(2) ? 0 : random.integer(-2, 2), -54);
    f = f + monomial<D>(axis == 0 ? moved : Rational(-moved), exponents);
  }
  return f;
}

/// A plane beside terms that are huge in the rest of the box. \pre The origin is a corner of the box.
template <std::size_t D>
Polynomial<Rational, D> close_and_hidden(Trouble_source& random, const Grid<D>& grid)
{
  constexpr long low = D == 2 ? 12 : 8;
  Polynomial<Rational, D> huge;
  Resolution<D> powers;
  powers.fill(D == 2 ? 3 : 1);
  for_each_cell<D>(powers, [&](const Cell<D>& at) {
    Exponents<D> exponents;
    for (std::size_t axis = 0; axis < D; ++axis) exponents[axis] = static_cast<std::uint16_t>(low + at[axis]);
    huge = huge + monomial<D>(random.full_mantissa(), exponents);
  });
  const auto f = close_plane<D>(random, grid, 53) * (constant<Rational, D>(1) + small_terms<D>(random, 2, -8));
  return f
         + huge
               * constant<Rational, D>(
                   Trouble_source::scaled(1, D == 2 ? random.integer(50, 90) : random.integer(46, 60)));
}

} // namespace corral::test

#endif
