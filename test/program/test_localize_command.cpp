// SPDX-License-Identifier: LGPL-3.0-or-later
#include "run_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <set>

namespace {

using namespace corral::test;
using nlohmann::json;
using Words = std::vector<std::string>;

Words circle(Words more)
{
  more.insert(more.begin(), {"localize", "x^2 + y^2 - 1", "--box", "-2:2,-2:2", "--resolution", "40"});
  return more;
}

TEST(Localize_command, prints_a_summary)
{
  const Program_run run = run_program(circle({"--format", "summary"}));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const json summary = json::parse(run.out);
  EXPECT_GT(summary["plotted"], 0);
  EXPECT_EQ(summary["plotted"], summary["hit"].get<int>() + summary["unknown"].get<int>());
  EXPECT_GE(summary["seconds"], 0.0);
  EXPECT_EQ(summary["variables"], (json{"x", "y"}));
  EXPECT_EQ(summary["resolution"], (json{40, 40}));
}

TEST(Localize_command, prints_cells_as_csv_and_json_alike)
{
  const json cells = json::parse(run_program(circle({"--format", "json"})).out)["cells"];
  std::string csv = "i,j,verdict\n";
  for (const auto& cell : cells)
    csv += to_string(cell[0]) + "," + to_string(cell[1]) + "," + cell[2].get<std::string>() + "\n";
  EXPECT_EQ(run_program(circle({"--format", "csv"})).out, csv);
}

TEST(Localize_command, takes_axes_in_alphabetical_order_or_as_told)
{
  const Words common{"localize", "b - a^2", "--box", "0:1,0:1", "--resolution", "4", "--format", "text"};
  Words swapped = common;
  swapped.insert(swapped.end(), {"--variables", "b,a"});
  const std::string usual = run_program(common).out;
  const std::string other = run_program(swapped).out;
  const auto plotted = [](const std::string& picture) {
    std::set<std::pair<std::size_t, std::size_t>> cells;
    for (std::size_t row = 0; row < 4; ++row)
      for (std::size_t column = 0; column < 4; ++column)
        if (picture.at(5 * row + column) != '.') cells.emplace(column, 3 - row);
    return cells;
  };
  EXPECT_TRUE(plotted(usual).contains({2, 1}));
  for (const auto& [i, j] : plotted(usual)) EXPECT_TRUE(plotted(other).contains({j, i}));
  EXPECT_NE(usual, other);
}

TEST(Localize_command, lets_a_polynomial_use_fewer_variables)
{
  const Program_run run = run_program(
      {"localize", "x^2 + y^2 - 1/2", "--box", "-1:1,-1:1,-1:1", "--resolution", "8", "--format", "summary"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(json::parse(run.out)["variables"], (json{"x", "y", "z"}));
  EXPECT_EQ(json::parse(run.out)["plotted"].get<int>() % 8, 0);
}

TEST(Localize_command, proves_hits_in_every_dimension)
{
  const Program_run run = run_program({"localize", "x^3 - 2", "--box", "-2:2", "--resolution", "7", "--format", "csv"});
  EXPECT_EQ(run.out, "i,verdict\n5,hit\n");
  const Program_run space = run_program(
      {"localize", "w + x + y + z - 1/3", "--box", "0:1,0:1,0:1,0:1", "--resolution", "2", "--format", "summary"});
  EXPECT_EQ(json::parse(space.out)["hit"], 1);
}

TEST(Localize_command, says_what_the_fast_engine_does_not_heed)
{
  const Program_run run =
      run_program(circle({"--engine", "fast", "--bounder", "maa", "--count", "--format", "summary"}));
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.err, "corral: note: engine fast takes no notice of --bounder\n");
  EXPECT_FALSE(json::parse(run.out).contains("additions"));
}

TEST(Localize_command, writes_every_kind_of_file)
{
  const Temporary_folder folder;
  Program_limits limits;
  limits.folder = folder.path();
  const Program_run curve = run_program(circle({"--output", "c.png", "--output", "c.svg", "--output", "c.csv",
                                                "--output", "c.json", "--output", "c.txt"}),
                                        limits);
  EXPECT_EQ(curve.exit_code, 0) << curve.err;
  const Program_run ball =
      run_program({"localize", "x^2 + y^2 + z^2 - 1", "--box", "-2:2,-2:2,-2:2", "--resolution", "16", "--output",
                   "b.png", "--output", "b.off", "--output", "b.ply", "--output", "b.vtk", "--output", "b.csv"},
                  limits);
  EXPECT_EQ(ball.exit_code, 0) << ball.err;
  EXPECT_EQ(folder.files(),
            (Words{"b.csv", "b.off", "b.ply", "b.png", "b.vtk", "c.csv", "c.json", "c.png", "c.svg", "c.txt"}));
  EXPECT_EQ(content(folder.path() / "c.csv"), run_program(circle({"--format", "csv"})).out);
}

TEST(Localize_command, stops_on_an_interrupt_without_a_file)
{
  const Temporary_folder folder;
  Program_limits limits;
  limits.folder = folder.path();
  limits.interrupt_after = std::chrono::milliseconds(300);
  const Program_run run = run_program({"localize", "x*y - 1/3", "--box", "0:1,0:1", "--resolution", "100000000",
                                       "--max-cells", "4000000000", "--output", "a.csv"},
                                      limits);
  EXPECT_EQ(run.exit_code, 130);
  EXPECT_EQ(run.err, "corral: interrupted; nothing was written\n");
  EXPECT_EQ(folder.files(), Words{});
}

TEST(Help, is_everywhere)
{
  for (const Words& words :
       {Words{"--help"}, {"localize", "--help"}, {"bound", "--help"}, {"reproduce", "--help"}, {"list", "--help"}}) {
    const Program_run run = run_program(words);
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_EQ(run.err, "");
    EXPECT_NE(run.out.find("Usage: corral"), std::string::npos);
  }
  EXPECT_EQ(run_program({"list"}).exit_code, 0);
}

} // namespace
