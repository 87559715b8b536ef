// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Interval_archetype.h"

#include <corral/audit/audit_bounder.h>
#include <corral/bounders/Any_bounder.h>
#include <corral/localization/localize_with_bounder.h>

#include <gtest/gtest.h>

namespace {

using namespace corral;
using test::Interval_archetype;

TEST(Concepts, every_bounder_computes_with_a_number_that_offers_no_more)
{
  const auto f = collect<Rational, 2>({{{2, 0}, 1}, {{0, 3}, 2}, {{1, 1}, -1}, {{0, 0}, Rational(-1, 3)}});
  const Grid grid({{-1, 1}, {-1, 1}}, 8);
  Bounders::for_each<Interval_archetype, 2>([&](auto bounder) {
    using B = typename decltype(bounder)::type;
    using Same = Any_bounder<Rational_interval, 2>;
    const Cell_options options{.sample = true, .refine_depth = 1};
    const auto found = localize<B>(f, grid, {}, options);
    const auto expected = localize<Rational_interval, 2>(
        {f}, grid, {}, options, [&](const Polynomial<Rational_interval, 2>& g) { return Same(B::name, g); });
    EXPECT_EQ(found, expected) << B::name;
    EXPECT_EQ(audit_bounder<B>({.cases = 20}).escapes, 0U) << B::name;
  });
}

} // namespace
