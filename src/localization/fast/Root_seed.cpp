// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Root_seed.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace corral::fast {

namespace {

/// x = (offset + scale * u) / denominator.
struct Integer_map
{
  Integer offset;
  Integer scale;
  Integer denominator;
};

template <std::size_t D>
Integer_map integer_map(const Grid<D>& grid, std::size_t axis, unsigned cells_log2)
{
  Rational half = grid.step(axis);
  if (cells_log2 > 0)
    mpq_mul_2exp(half.get_mpq_t(), half.get_mpq_t(), cells_log2 - 1);
  else
    half /= 2;
  const Rational centre = grid.box()[axis].lower() + half;
  Integer_map map;
  mpz_lcm(map.denominator.get_mpz_t(), centre.get_den_mpz_t(), half.get_den_mpz_t());
  map.offset = centre.get_num() * (map.denominator / centre.get_den());
  map.scale = half.get_num() * (map.denominator / half.get_den());
  return map;
}

std::vector<Integer> powers(const Integer& base, unsigned highest)
{
  std::vector<Integer> result(highest + std::size_t{1}, 1);
  for (std::size_t e = 1; e < result.size(); ++e) result[e] = result[e - 1] * base;
  return result;
}

template <std::size_t D>
std::vector<Integer> integer_coefficients(const Polynomial<Rational, D>& f, const Monomial_shape<D>& shape)
{
  Integer common = 1;
  for (const auto& term : f.terms())
    if (mpz_divisible_p(common.get_mpz_t(), term.coefficient.get_den_mpz_t()) == 0)
      mpz_lcm(common.get_mpz_t(), common.get_mpz_t(), term.coefficient.get_den_mpz_t());
  std::vector<Integer> result(shape.size());
  for (const auto& term : f.terms()) {
    Integer& target = result[shape.position(term.exponents)];
    mpz_divexact(target.get_mpz_t(), common.get_mpz_t(), term.coefficient.get_den_mpz_t());
    target *= term.coefficient.get_num();
  }
  return result;
}

/// Replaces x by x + offset along one axis, by Horner's triangle on every line.
template <std::size_t D>
void shift(std::vector<Integer>& c, const Monomial_shape<D>& shape, std::size_t axis, const Integer& offset,
           Pulse& pulse)
{
  if (offset == 0) return;
  const auto& lines = shape.classes().front().lines[axis];
  for (const auto& line : lines.lines)
    for (std::uint32_t low = 0; low < line.degree; ++low) {
      if (low % 64 == 0) pulse.ask();
      for (std::uint32_t k = line.degree; k-- > low;) {
        Integer& to = c[lines.index[line.first + k]];
        const Integer& from = c[lines.index[line.first + k + 1]];
        if (offset == 1)
          to += from;
        else
          mpz_addmul(to.get_mpz_t(), from.get_mpz_t(), offset.get_mpz_t());
      }
    }
}

/// The coefficients of the root, divided by a power of two above the largest and rounded.
template <std::size_t D>
Seed<D> rounded(const std::vector<Integer>& c, const Rounding& rounding)
{
  std::size_t bits = 0;
  std::size_t trailing_zeros = ~std::size_t{0};
  for (const Integer& value : c)
    if (value != 0) {
      bits = std::max(bits, mpz_sizeinbase(value.get_mpz_t(), 2));
      trailing_zeros = std::min(trailing_zeros, mpz_scan1(value.get_mpz_t(), 0));
    }
  Seed<D> seed;
  seed.coefficients.reserve(c.size());
  double error = 0;
  double norm = 0;
  for (const Integer& value : c) {
    long exponent = 0;
    const double mantissa = mpz_get_d_2exp(&exponent, value.get_mpz_t()); // truncated, in [1/2, 1)
    const double nearby = std::ldexp(mantissa, static_cast<int>(std::max(exponent - static_cast<long>(bits), -5000L)));
    const bool exact = value == 0 || mpz_sizeinbase(value.get_mpz_t(), 2) - mpz_scan1(value.get_mpz_t(), 0) <= 53;
    if (!exact) error += std::abs(nearby) * 0x1p-51;
    if (value != 0 && std::abs(nearby) < 0x1p-960) error += 0x1p-1020; // ldexp may have rounded
    norm += std::abs(nearby);
    seed.coefficients.push_back(nearby);
  }
  seed.remainder = error * (1 + 0x1p-30);
  seed.norm = norm * rounding.sum;
  if (error == 0) seed.quantum = std::ldexp(1.0, -static_cast<int>(bits - trailing_zeros)); // 2^-1013 or more
  return seed;
}

} // namespace

template <std::size_t D>
Seed<D> root_seed(const Plan<D>& plan, const Polynomial<Rational, D>& f, const Grid<D>& grid, Pulse& pulse)
{
  const Monomial_shape<D>& shape = plan.shape;
  std::vector<Integer> c = integer_coefficients(f, shape);
  for (std::size_t axis = 0; axis < D; ++axis) {
    const Integer_map map = integer_map(grid, axis, plan.cells_log2[axis]);
    const unsigned degree = f.degree(axis);
    if (map.denominator != 1) { // f times denominator^degree, so that everything stays an integer
      const auto factor = powers(map.denominator, degree);
      for (std::size_t k = 0; k < c.size(); ++k)
        if (c[k] != 0) c[k] *= factor[degree - shape.exponents()[k][axis]];
    }
    shift(c, shape, axis, map.offset, pulse);
    pulse.ask();
    if (map.scale != 1) {
      const auto factor = powers(map.scale, degree);
      for (std::size_t k = 0; k < c.size(); ++k)
        if (c[k] != 0) c[k] *= factor[shape.exponents()[k][axis]];
    }
  }
  return rounded<D>(c, plan.rounding);
}

template Seed<2> root_seed<2>(const Plan<2>&, const Polynomial<Rational, 2>&, const Grid<2>&, Pulse&);
template Seed<3> root_seed<3>(const Plan<3>&, const Polynomial<Rational, 3>&, const Grid<3>&, Pulse&);

} // namespace corral::fast
