// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/polynomial/arithmetic.h>
#include <corral/polynomial/cgal_polynomial.h>

#include "random_polynomial.h"

#include <gtest/gtest.h>

namespace {

using namespace corral;
using namespace corral::test;

// CGAL's ring operations are an independent way to the same result.
template <std::size_t D>
void check_against_cgal(std::uint64_t seed)
{
  Generator generator(seed);
  for (int round = 0; round < 10; ++round) {
    const auto f = random_polynomial<D>(generator, 12, 5);
    const auto g = random_polynomial<D>(generator, 12, 5);
    const auto from = [](const auto& h) { return from_cgal<Rational, D>(h); };
    EXPECT_EQ(from(to_cgal(f)), f);
    EXPECT_EQ(from(to_cgal(f) + to_cgal(g)), f + g);
    EXPECT_EQ(from(to_cgal(f) - to_cgal(g)), f - g);
    EXPECT_EQ(from(to_cgal(f) * to_cgal(g)), f * g);
    if (!f.is_zero()) {
      EXPECT_NE(from(to_cgal(f) + to_cgal(g)), g);
    }
  }
}

TEST(Cgal_polynomial, agrees_in_every_dimension)
{
  check_against_cgal<1>(1);
  check_against_cgal<2>(2);
  check_against_cgal<3>(3);
}

TEST(Cgal_polynomial, variable_0_is_innermost)
{
  const auto x = to_cgal(variable<Integer, 2>(0));
  EXPECT_EQ(x.degree(), 0); // in CGAL's outermost variable, which is y
  EXPECT_EQ(to_cgal(variable<Integer, 2>(1)).degree(), 1);
}

} // namespace
