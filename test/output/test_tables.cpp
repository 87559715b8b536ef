// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/output/tables.h>

#include "shapes.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sstream>

namespace {

using namespace corral;

Raster<2> few(const Grid<2>& grid)
{
  return test::raster(grid, {{{9, 1}, Verdict::unknown}, {{0, 3}, Verdict::hit}, {{10, 0}, Verdict::hit}});
}

TEST(Csv, is_sorted_with_a_header)
{
  std::ostringstream out;
  write_csv(out, few(test::grid<2>(16)), {});
  EXPECT_EQ(out.str(), "i,j,verdict\n0,3,hit\n9,1,unknown\n10,0,hit\n");
}

TEST(Csv, names_every_axis_and_holds_the_largest_index)
{
  std::ostringstream out;
  const std::uint32_t last = Grid<3>::max_resolution - 1;
  write_csv(out, test::raster(test::grid<3>(Grid<3>::max_resolution), {{{last, 0, last}, Verdict::hit}}), {});
  EXPECT_EQ(out.str(), "i,j,k,verdict\n1073741823,0,1073741823,hit\n");
}

TEST(Json, can_be_read_back)
{
  Output_options options;
  options.variables = {"u", "v"};
  options.facts = {{"bounder", "rt"},
                   {"bounds", std::uint64_t{1} << 60},
                   {"seconds", 0.5},
                   {"polynomials", std::vector<std::string>{"u - \"\xff\\"}}};
  std::ostringstream out;
  write_json(out, few(test::grid<2>(16, Rational(-1, 3), Rational(1, 3))), options);
  const auto read = nlohmann::json::parse(out.str());
  EXPECT_EQ(read["variables"], (nlohmann::json{"u", "v"}));
  EXPECT_EQ(read["box"][1], (nlohmann::json{"-1/3", "1/3"}));
  EXPECT_EQ(read["resolution"], (nlohmann::json{16, 16}));
  EXPECT_EQ(read["bounds"], std::uint64_t{1} << 60);
  EXPECT_EQ(read["plotted"], 3);
  EXPECT_EQ(read["hit"], 2);
  EXPECT_EQ(read["unknown"], 1);
  EXPECT_EQ(read["cells"].size(), 3U);
  EXPECT_EQ(read["cells"][1], (nlohmann::json{9, 1, "unknown"}));
}

TEST(Json, of_no_cell_is_still_json)
{
  std::ostringstream out;
  write_json(out, test::raster(test::grid<1>(5), {}), {});
  EXPECT_TRUE(nlohmann::json::parse(out.str())["cells"].empty());
}

// A run that was stopped: three cells found, six not visited on either side of them.
TEST(Tables, list_cells_that_were_not_visited_as_unknown)
{
  Raster_builder<2> cells;
  cells.append({1, 0}, Verdict::hit);
  cells.append({1, 3}, Verdict::hit);
  cells.leave({{0, 0}, {1, 2}});
  cells.leave({{1, 1}, {3, 3}});
  const auto stopped = std::move(cells).finish(test::grid<2>(4), true);
  std::ostringstream csv;
  write_csv(csv, stopped, {});
  EXPECT_EQ(csv.str(), "i,j,verdict\n0,0,unknown\n0,1,unknown\n1,0,hit\n1,1,unknown\n1,2,unknown\n1,3,hit\n"
                       "2,1,unknown\n2,2,unknown\n");
  std::ostringstream summary;
  write_summary(summary, stopped, {});
  const auto read = nlohmann::json::parse(summary.str());
  EXPECT_EQ(read["plotted"], 8);
  EXPECT_EQ(read["hit"], 2);
  EXPECT_EQ(read["unknown"], 6);
  EXPECT_EQ(read["not_visited"], 6);
  std::ostringstream text;
  write_text(text, stopped, {});
  EXPECT_EQ(text.str(), ".#..\n.??.\n???.\n?#..\n");
}

TEST(Summary, is_one_line)
{
  std::ostringstream out;
  write_summary(out, few(test::grid<2>(16)), {});
  EXPECT_EQ(out.str().find('\n'), out.str().size() - 1);
  EXPECT_FALSE(nlohmann::json::parse(out.str()).contains("cells"));
}

TEST(Text, has_y_pointing_up)
{
  std::ostringstream out;
  write_text(
      out, test::raster(test::grid<2>(4), {{{0, 0}, Verdict::hit}, {{1, 1}, Verdict::unknown}, {{3, 2}, Verdict::hit}}),
      {});
  EXPECT_EQ(out.str(), "....\n"
                       "...#\n"
                       ".?..\n"
                       "#...\n");
}

TEST(Text, shows_slices_above_two_dimensions)
{
  std::ostringstream out;
  write_text(out, test::raster(test::grid<3>(2), {{{1, 0, 1}, Verdict::hit}}), {});
  EXPECT_EQ(out.str(), "slice z 0\n..\n..\nslice z 1\n..\n.#\n");
}

TEST(Text, loses_no_cell_of_a_large_grid)
{
  std::ostringstream out;
  const std::uint32_t n = 1U << 30;
  write_text(out,
             test::raster(test::grid<2>(n),
                          {{{0, n - 1}, Verdict::unknown}, {{n - 1, 0}, Verdict::hit}, {{n - 2, 0}, Verdict::unknown}}),
             {});
  const std::string text = out.str();
  EXPECT_EQ(text.size(), 128U * 129U);
  EXPECT_EQ(text.front(), '?');
  EXPECT_EQ(text[text.size() - 2], '#'); // the stronger verdict
}

} // namespace
