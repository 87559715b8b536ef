// SPDX-License-Identifier: LGPL-3.0-or-later
#include "algebra/root_cases.h"
#include "bound/bound_over.h"
#include "localize/paper_engine.h"

#include <corral/algebra/real_roots.h>
#include <corral/audit/audit_bounder.h>
#include <corral/audit/audit_number.h>
#include <corral/audit/root_oracles.h>
#include <corral/bounders/Any_bounder.h>
#include <corral/localization/Raster_builder.h>
#include <corral/localization/localize.h>
#include <corral/number/all.h>
#include <corral/output/all.h>
#include <corral/polynomial/parse.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace {

using namespace corral;

const Rational_box<2> square_of_side_4 = {Rational_interval(-2, 2), Rational_interval(-2, 2)};

Polynomial<Rational, 2> circle() { return parse_polynomial<2>("x^2 + y^2 - 1", {"x", "y"}); }

TEST(Recipes, a_number_type_is_chosen_by_name_and_conforms)
{
  int found = 0;
  Number_types::visit("stranger", [&]<class I>(std::type_identity<I>) {
    const auto audit = audit_number<I>({.seed = 8, .cases = 300});
    EXPECT_EQ(audit.faults, 0U) << (audit.first_fault ? audit.first_fault->text : "");
    ++found;
  });
  EXPECT_EQ(found, 1);
  EXPECT_NE(Number_types::names().find("stranger"), std::string::npos);
}

TEST(Recipes, a_number_type_is_what_the_program_computes_with)
{
  using namespace program;
  const Method method{.bounder = "maa", .number = "stranger"};
  const Bound_problem problem{{{"x"}, {Rational_interval(0, 1)}}, std::string("x^2 - x"), method};
  EXPECT_EQ(bound_over<Stranger_interval>(problem).exact, "[-1/4, 0]");
  const Grid<2> grid(square_of_side_4, {16, 16});
  Localize_settings settings;
  settings.method = method;
  const auto found = localize_over<Stranger_interval, 2>({circle()}, grid, settings);
  EXPECT_TRUE(found.is_guaranteed());
  for (const auto& [cell, verdict] : localize(circle(), grid))
    EXPECT_TRUE(verdict != Verdict::hit || found.verdict(cell) != Verdict::empty) << cell[0] << ", " << cell[1];
  EXPECT_LT(found.plotted(), 64U);
}

TEST(Recipes, a_bounder_is_chosen_by_name_and_conforms)
{
  const auto audit = audit_bounder<Outward_interval, 2>(
      [](const Polynomial<Outward_interval, 2>& f) { return Any_bounder<Outward_interval, 2>("stranger", f); },
      {.seed = 9, .cases = 60});
  EXPECT_EQ(audit.bounder, "stranger");
  EXPECT_EQ(audit.escapes, 0U) << to_string(audit.first_escape.value_or(Escape<2>()));
  EXPECT_GT(audit.checks, 1000U);
  EXPECT_NE(Bounders::names().find("stranger"), std::string::npos);
}

TEST(Recipes, a_writer_is_chosen_by_the_ending)
{
  const auto path = std::filesystem::path(::testing::TempDir()) / "cells.stranger";
  const Grid<2> grid(square_of_side_4, {4, 4});
  Raster_builder<2> cells;
  cells.append({3, 1}, Verdict::hit);
  cells.append({0, 2}, Verdict::unknown);
  write_file(path, std::move(cells).finish(grid, true));
  std::ifstream in(path);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), "2\n4\n");
  std::filesystem::remove(path);
}

TEST(Recipes, an_oracle_judges_the_roots)
{
  const auto oracles = root_oracles();
  ASSERT_EQ(oracles.size(), 1U);
  EXPECT_EQ(oracles.front().name, "stranger");
  for (const auto& [name, p] : root_cases::hard_cases())
    EXPECT_EQ(isolate_real_roots(p).size(), oracles.front().count(p)) << name;
}

} // namespace
