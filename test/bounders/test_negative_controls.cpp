// SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformance_of_all.h"

#include <corral/number/Nearest_interval.h>
#include <corral/number/Rational_interval.h>

namespace {

using namespace corral;
using namespace corral::test;

// False bounders. The suite that the true ones pass must catch each of them.

/// Takes a thousandth of its width off each end of a true bound.
template <IntervalNumber I, std::size_t D>
struct Shrinking_bounder : Natural_bounder<I, D>
{
  using Natural_bounder<I, D>::Natural_bounder;
  static constexpr std::string_view name = "shrinking";
  [[nodiscard]] I bound(const Box<I, D>& box) const
  {
    const I b = Natural_bounder<I, D>::bound(box);
    const I margin = (upper(b) - lower(b)) * enclose<I>(Rational(1, 1000));
    return hull(I(lower(b) + margin), I(upper(b) - margin));
  }
};

/// Forgets the last term.
template <IntervalNumber I, std::size_t D>
struct Forgetful_bounder : Modified_affine_bounder<I, D>
{
  static constexpr std::string_view name = "forgetful";
  explicit Forgetful_bounder(const Polynomial<I, D>& f) : Modified_affine_bounder<I, D>(without_last(f)) {}
  static Polynomial<I, D> without_last(const Polynomial<I, D>& f)
  {
    auto terms = f.terms();
    if (terms.size() > 1) terms.pop_back();
    return Polynomial<I, D>(std::move(terms));
  }
};

template <class B>
bool is_caught()
{
  return audit_bounder<B>({.cases = 64}).escapes > 0;
}

template <std::size_t D>
void expect_false_bounders_caught()
{
  using I = Rational_interval;
  EXPECT_TRUE((is_caught<Shrinking_bounder<I, D>>()));
  EXPECT_TRUE((is_caught<Forgetful_bounder<I, D>>()));
}

TEST(Bounder_conformance, catches_false_bounders)
{
  expect_false_bounders_caught<1>();
  expect_false_bounders_caught<2>();
  expect_false_bounders_caught<3>();
  expect_false_bounders_caught<4>();
}

template <std::size_t D>
void expect_missing_rounding_caught()
{
  audit_all_bounders<Nearest_interval, D>(1, 64, [](const Bounder_audit<D>& audit) {
    EXPECT_GT(audit.escapes, 0U) << audit.bounder << " in dimension " << D;
  });
}

TEST(Bounder_conformance, catches_every_bounder_without_outward_rounding)
{
  expect_missing_rounding_caught<1>();
  expect_missing_rounding_caught<2>();
  expect_missing_rounding_caught<3>();
  expect_missing_rounding_caught<4>();
}

} // namespace
