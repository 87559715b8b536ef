// SPDX-License-Identifier: LGPL-3.0-or-later
// Compiled with CORRAL_CHECK_PRECONDITIONS: what Debug builds check.
#include <corral/bounders/all.h>
#include <corral/errors.h>
#include <corral/internal/localization/Subdivision.h>
#include <corral/number/all.h>

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>
#include <thread>

namespace {

using namespace corral;

/// The complaint of what is done, or "" if there is none.
std::string complaint(const std::function<void()>& action)
{
  try {
    action();
  } catch (const Invalid_input& error) {
    return error.what();
  }
  return "";
}

bool is_one_line_of(const std::string& text, const std::string& word)
{
  return text.find(word) != std::string::npos && text.find('\n') == std::string::npos;
}

void sum_of_tenths()
{
  const auto tenth = enclose<Cgal_interval>(Rational(1, 10));
  (void)(Cgal_interval(1) + Cgal_interval(50) * tenth);
}

TEST(Preconditions, find_a_forgotten_scope_on_every_thread)
{
  EXPECT_TRUE(is_one_line_of(complaint(sum_of_tenths), "Arithmetic_scope"));
  std::thread([] { EXPECT_TRUE(is_one_line_of(complaint(sum_of_tenths), "Arithmetic_scope")); }).join();
  std::thread([] {
    const Arithmetic_scope<Cgal_interval> scope;
    EXPECT_EQ(complaint(sum_of_tenths), "");
  }).join();
  EXPECT_NE(complaint(sum_of_tenths), ""); // the other thread's scope is not this one's
  EXPECT_NE(complaint([] { (void)square(Cgal_interval(2)); }), "");
  EXPECT_NE(complaint([] { (void)(Counted<Cgal_interval>(2) - Counted<Cgal_interval>(1)); }), "");
}

TEST(Preconditions, know_what_a_scope_inside_cgals_protection_does)
{
  {
    const CGAL::Protect_FPU_rounding<true> upward; // the mode that Cgal_interval needs
    EXPECT_EQ(complaint(sum_of_tenths), "");
    {
      const Arithmetic_scope<Cgal_interval> scope;
      EXPECT_EQ(complaint(sum_of_tenths), "");
    }
    EXPECT_EQ(complaint(sum_of_tenths), "");                                          // it was restored
    EXPECT_THROW(const Arithmetic_scope<Outward_interval> scope, Unsafe_environment); // needs another mode
    EXPECT_NE(complaint([] { (void)(Outward_interval(1) + Outward_interval(2)); }), "");
  }
  const Arithmetic_scope<Cgal_interval> scope;
  const CGAL::Protect_FPU_rounding<true> nearest(CGAL_FE_TONEAREST); // takes the scope's mode away
  EXPECT_NE(complaint(sum_of_tenths), "");
}

TEST(Preconditions, look_at_the_range_of_mpfr)
{
  const auto least = mpfr_get_emin();
  mpfr_set_emin(-1073);
  const auto text = complaint([] { (void)(Mpfr_interval(1) + Mpfr_interval(2)); });
  mpfr_set_emin(least);
  EXPECT_TRUE(is_one_line_of(text, "Arithmetic_scope"));
  EXPECT_EQ(complaint([] { (void)(Mpfr_interval(1) + Mpfr_interval(2)); }), "");
}

TEST(Preconditions, of_enclosures_boxes_and_polynomials)
{
  using I = Outward_interval;
  EXPECT_NE(complaint([] { (void)enclose<I>(Rational(1), Rational(0)); }), "");
  const Box<I, 1> half_line = {I(0, std::numeric_limits<double>::infinity())};
  const Polynomial<I, 1> f({{{1}, I(1)}, {{3}, I(2)}});
  Bounders::for_each<I, 1>([&](auto bounder) {
    using B = typename decltype(bounder)::type;
    const B b(f);
    const bool expands = B::name != "horner"; // which computes with infinities as they come
    EXPECT_EQ(is_one_line_of(complaint([&] { (void)b.bound(half_line); }), "infinite"), expands) << B::name;
  });
  EXPECT_NE(complaint([] { (void)Polynomial<I, 1>(Sorted_terms(), {{{2}, I(1)}, {{1}, I(1)}}); }), "");
  EXPECT_NE(complaint([] { (void)transform<Rational>(variable<Rational, 1>(0), [](const Rational&) { return 0; }); }),
            "");
  const Subdivision_tree<2> tree({4, 4});
  EXPECT_NE(complaint([&] { (void)tree.children({0, {1, 1}}); }), "");
}

} // namespace
