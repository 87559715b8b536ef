// SPDX-License-Identifier: LGPL-3.0-or-later
#include "algebra/constant_slope.h"

#include <corral/internal/polynomial/integer_form.h>
#include <corral/polynomial/parse.h>

#include <gtest/gtest.h>

#include <string>

namespace {

using namespace corral;

bool has_constant_slope(const std::string& text)
{
  return exact::has_constant_slope(integer_primitive(parse_polynomial<3>(text, {"x", "y", "z"})));
}

TEST(Constant_slope, is_seen_along_any_direction)
{
  for (const auto* const text : {"z - x^2*y", "(x+y+z-1/3)^16 + x/10^20", "x^2 + y^2 - 1", "(x-y)^3 + (y-z)^2 + 7*z",
                                 "(2*x-3*y)^2*(y+5*z)", "3*x - y + 1", "7"})
    EXPECT_TRUE(has_constant_slope(text)) << text;
}

TEST(Constant_slope, is_not_seen_where_there_is_none)
{
  for (const auto* const text : {"x^2 + y^2 + z^2 - 1", "x*y*z + x", "(x+y+z)^16 + x^2*y", "x*y + y*z + z*x"})
    EXPECT_FALSE(has_constant_slope(text)) << text;
}

} // namespace
