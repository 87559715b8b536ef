// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algebra/Bivariate.h>
#include <algebra/definite.h>
#include <algebra/multivariate.h>
#include <polynomial/square_free.h>

#include <corral/errors.h>
#include <corral/polynomial/parse.h>

#include <gtest/gtest.h>

#include <utility>
#include <vector>

/// \file
/// FLINT's answers are verified: somebody who gives wrong ones in its place is found out, whatever the error.
namespace {

using namespace corral;
using detail::Flint_functions;
using detail::Flint_ring;

Polynomial<Integer, 2> plane(const std::string& text)
{
  return integer_primitive(parse_polynomial<2>(text, {"x", "y"}));
}
Polynomial<Integer, 3> space(const std::string& text)
{
  return integer_primitive(parse_polynomial<3>(text, {"x", "y", "z"}));
}

using Out = fmpz_mpoly_struct*;
using In = const fmpz_mpoly_struct*;
using Context = const fmpz_mpoly_ctx_struct*;

// Wrong answers.
int gcd_is_one(Out g, In, In, Context context)
{
  fmpz_mpoly_one(g, context);
  return 1;
}
int gcd_is_first(Out g, In a, In, Context context) // too large: with simple factors
{
  fmpz_mpoly_set(g, a, context);
  return 1;
}
int gcd_plus_one(Out g, In a, In b, Context context)
{
  const int done = fmpz_mpoly_gcd(g, a, b, context);
  fmpz_mpoly_add_ui(g, g, 1, context);
  return done;
}
int gives_no_quotient(Out q, In, In, Context context)
{
  fmpz_mpoly_zero(q, context);
  return 0;
}
int quotient_plus_one(Out q, In a, In b, Context context)
{
  const int done = fmpz_mpoly_divides(q, a, b, context);
  fmpz_mpoly_add_ui(q, q, 1, context);
  return done;
}
int loses_a_factor(fmpz_mpoly_factor_struct* factors, In f, Context context)
{
  const int done = fmpz_mpoly_factor(factors, f, context);
  --factors->num;
  return done;
}
int alters_a_factor(fmpz_mpoly_factor_struct* factors, In f, Context context)
{
  const int done = fmpz_mpoly_factor(factors, f, context);
  fmpz_mpoly_add_ui(factors->poly, factors->poly, 1, context);
  return done;
}
int resultant_plus_one(Out r, In f, In g, slong axis, Context context)
{
  const int done = fmpz_mpoly_resultant(r, f, g, axis, context);
  fmpz_mpoly_add_ui(r, r, 1, context);
  return done;
}
int negative_resultant(Out r, In f, In g, slong axis, Context context)
{
  const int done = fmpz_mpoly_resultant(r, f, g, axis, context);
  fmpz_mpoly_neg(r, r, context);
  return done;
}
int gives_up(Out, In, In, Context) { return 0; }

const std::vector<Flint_functions>& wrong_divisions()
{
  static const std::vector<Flint_functions> list = {{.gcd = gcd_is_one},
                                                    {.gcd = gcd_is_first},
                                                    {.gcd = gcd_plus_one},
                                                    {.divides = gives_no_quotient},
                                                    {.divides = quotient_plus_one}};
  return list;
}

TEST(Verification, finds_wrong_square_free_parts)
{
  for (const auto* const text : {"(x + 2*y - 1)^2*(x - y)", "(x^2 + y^2 - 3)^3*(x*y - 2)^2*(7*x - y + 1)", "x^2*y^3"}) {
    const auto terms = detail::flat_terms(plane(text));
    EXPECT_NO_THROW((void)detail::square_free_part(terms, Flint_functions()));
    for (std::size_t k = 0; k < wrong_divisions().size(); ++k)
      EXPECT_THROW((void)detail::square_free_part(terms, wrong_divisions()[k]), Wrong_answer)
          << text << ", error " << k;
  }
  EXPECT_THROW((void)detail::square_free_part(detail::flat_terms(plane("x^2")), {.gcd = gives_up}), Budget_exceeded);
}

TEST(Verification, finds_wrong_common_factors)
{
  const auto f = space("(x + y*z - 1)^2*(x^2 + y^2 + z^2 - 3)");
  const auto g = space("(x + y*z - 1)*(x - y + 5*z)");
  const auto parts = exact::common_factor(f, g);
  EXPECT_EQ(parts.divisor * parts.f, f);
  EXPECT_EQ(parts.divisor * parts.g, g);
  for (std::size_t k = 0; k < wrong_divisions().size(); ++k)
    EXPECT_THROW((void)exact::common_factor(f, g, wrong_divisions()[k]), Wrong_answer) << "error " << k;
  EXPECT_THROW((void)exact::common_factor(f, g, {.gcd = gives_up}), Budget_exceeded);
}

TEST(Verification, finds_wrong_factors)
{
  const auto f = space("(x + y*z - 1)*(x^2 + y^2 + z^2 - 3)*(2*x - 2*y + 10*z)");
  EXPECT_EQ(exact::irreducible_factors(f).size(), 3U);
  EXPECT_EQ(exact::irreducible_factors(plane("(x + y - 1)^3*(x^2 + y^2 - 3)")).size(), 2U);
  EXPECT_THROW((void)exact::irreducible_factors(f, {.factor = loses_a_factor}), Wrong_answer);
  EXPECT_THROW((void)exact::irreducible_factors(f, {.factor = alters_a_factor}), Wrong_answer);
}

TEST(Verification, finds_wrong_resultants)
{
  const auto f = space("x*z^3 + y*z - x^2 + 1");
  const auto g = space("(x - y)*z^2 + x*y*z - 7");
  EXPECT_FALSE(exact::resultant(f, g).is_zero());
  EXPECT_NO_THROW((void)exact::resultant(g, f)); // of the other sign where both degrees are odd
  EXPECT_NO_THROW((void)exact::resultant(f, space("x + 3*z")));
  EXPECT_TRUE(exact::resultant(f, f).is_zero());
  EXPECT_THROW((void)exact::resultant(f, g, {.resultant = resultant_plus_one}), Wrong_answer);
  EXPECT_THROW((void)exact::resultant(f, g, {.resultant = negative_resultant}), Wrong_answer);
}

TEST(Verification, finds_wrong_eliminations)
{
  const auto f = exact::bivariate(plane("x*y^3 + y - x^2 + 1"), 1);
  const auto g = exact::bivariate(plane("(x - 2)*y^2 + x*y - 7"), 1);
  const auto right = exact::eliminate(f, g);
  ASSERT_GT(right.s1.size(), 0U);
  EXPECT_NO_THROW(exact::require_elimination(right, f, g));
  for (const auto part : {&exact::Elimination::resultant, &exact::Elimination::s1, &exact::Elimination::s0}) {
    auto wrong = right;
    auto coefficients = (wrong.*part).coefficients();
    coefficients.front() += 1;
    wrong.*part = Integer_polynomial(std::move(coefficients));
    EXPECT_THROW(exact::require_elimination(wrong, f, g), Wrong_answer);
  }
}

TEST(Verification, believes_right_answers_about_large_numbers)
{
  // Coefficients that are multiples of 2^61 - 1, the first prime that is tried.
  const std::string prime = "2305843009213693951";
  const auto f = plane("(x^2 + " + prime + "*y - 1)^2*(" + prime + "*x^3 + y)");
  EXPECT_EQ(square_free_part(f), plane("(x^2 + " + prime + "*y - 1)*(" + prime + "*x^3 + y)"));
  EXPECT_NO_THROW(detail::require_coprime(detail::flat_terms(plane(prime + "*x + 1")),
                                          detail::flat_terms(plane(prime + "*x^2 + x*y + 2"))));
}

TEST(Verification, refuses_exponents_that_no_term_holds)
{
  const Flint_ring ring(2);
  detail::Flint_polynomial f(ring);
  fmpz_mpoly_gen(f.get(), 1, ring.context());
  ASSERT_NE(fmpz_mpoly_pow_ui(f.get(), f.get(), 65535, ring.context()), 0);
  EXPECT_EQ(f.terms().exponents, (std::vector<std::uint16_t>{0, 65535}));
  fmpz_mpoly_mul(f.get(), f.get(), f.get(), ring.context());
  EXPECT_THROW((void)f.terms(), Budget_exceeded);
  std::vector<Integer> coefficients(65537 + 1);
  coefficients.back() = 1;
  const exact::Bivariate high{Integer_polynomial(std::move(coefficients))};
  EXPECT_THROW((void)exact::polynomial(high, 1), Budget_exceeded);
}

TEST(Definite, knows_squares_with_a_constant)
{
  for (const auto* const text :
       {"(x^2 + y^2 - 1)^2 + 1/10^8", "-3*(x*y - 1/3)^2 - 1/7", "(x^2 - y)^4*(x + y)^2 + 1/10^30"})
    EXPECT_TRUE(exact::is_square_plus_constant(plane(text))) << text;
  EXPECT_TRUE(exact::is_square_plus_constant(space("((x^2+y^2-z)*(x+y-z+1/3))^2+1/10^9")));
  EXPECT_TRUE(exact::is_square_plus_constant(space("2*(x^3 - 7*z)^2 + 5")));
}

// Each has a real zero, or is definite for another reason.
TEST(Definite, claims_nothing_else)
{
  for (const auto* const text :
       {"(x^2 + y^2 - 1)^2 - 1/10^8", "(x^2 + y^2 - 1)^2", "x^2 + y^2 + 1", "(x - y)^3 + 1", "x*(x - y)^2 + 1", "x + y",
        "-(x - y)^2 + 1", "(x - y)^2*(x + y) + 1", "(x*y)^2 + x + 1", "y", "(x^2 + y^2)^2 - 2*(x^2 + y^2)"})
    EXPECT_FALSE(exact::is_square_plus_constant(plane(text))) << text;
  EXPECT_FALSE(exact::is_square_plus_constant(space("(x + y - z)^2 - 1")));
}

} // namespace
