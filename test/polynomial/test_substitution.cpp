// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/polynomial/arithmetic.h>
#include <corral/polynomial/substitution.h>

#include "random_polynomial.h"

#include <gtest/gtest.h>

namespace {

using namespace corral;
using namespace corral::test;

template <std::size_t D>
void check_substitution(std::uint64_t seed)
{
  Generator generator(seed);
  for (int round = 0; round < 60; ++round) {
    const auto f = random_polynomial<D>(generator, 15, 7);
    const auto offset = random_point<D>(generator);
    const auto scale = random_point<D>(generator);
    const auto u = random_point<D>(generator);
    std::array<Rational, D> x;
    std::array<Rational, D> shifted;
    for (std::size_t axis = 0; axis < D; ++axis) {
      x[axis] = offset[axis] + scale[axis] * u[axis];
      shifted[axis] = offset[axis] + u[axis];
    }
    const auto g = affine_substitution(f, offset, scale);
    EXPECT_TRUE(is_canonical(g));
    EXPECT_EQ(value_by_definition(g, u), value_by_definition(f, x));
    EXPECT_EQ(value_by_definition(taylor_shift(f, offset), u), value_by_definition(f, shifted));
    if (f.total_degree() > 0) { // negative control: another shift is told apart
      EXPECT_NE(taylor_shift(f, u), taylor_shift(f, offset));
    }
  }
}

TEST(Substitution, agrees_with_values_in_every_dimension)
{
  check_substitution<1>(1);
  check_substitution<2>(2);
  check_substitution<3>(3);
  check_substitution<4>(4);
}

TEST(Substitution, gives_the_taylor_coefficients)
{
  Generator generator(5);
  const auto f = random_polynomial<2>(generator, 30, 5);
  const auto c = random_point<2>(generator);
  const auto shifted = taylor_shift(f, c);
  for (const auto& term : shifted.terms()) {
    auto g = f;
    Rational factorials = 1;
    for (std::size_t axis = 0; axis < 2; ++axis)
      for (unsigned k = 1; k <= term.exponents[axis]; ++k) {
        g = derivative(g, axis);
        factorials *= k;
      }
    EXPECT_EQ(term.coefficient * factorials, value_by_definition(g, c));
  }
}

TEST(Substitution, undoes_itself)
{
  Generator generator(6);
  for (int round = 0; round < 20; ++round) {
    const auto f = random_polynomial<3>(generator, 30, 8);
    const std::array<Rational, 3> c = {random_rational(generator), random_rational(generator), 0};
    EXPECT_EQ(taylor_shift(taylor_shift(f, c), {-c[0], -c[1], -c[2]}), f);
  }
}

TEST(Substitution, stays_sane_at_degree_100)
{
  auto f = constant<Rational, 2>(1) + variable<Rational, 2>(0) + variable<Rational, 2>(1);
  f = power(f, 100);
  const std::array<Rational, 2> c = {Rational(1, 3), Rational(-7, 10)};
  const std::array<Rational, 2> scale = {Rational(1, 512), Rational(1, 512)};
  const auto g = affine_substitution(f, c, scale);
  auto h = constant<Rational, 2>(1 + c[0] + c[1]) + scale[0] * variable<Rational, 2>(0)
           + scale[1] * variable<Rational, 2>(1);
  EXPECT_EQ(g, power(h, 100));
}

} // namespace
