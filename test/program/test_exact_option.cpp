// SPDX-License-Identifier: LGPL-3.0-or-later
#include "run_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <map>

namespace {

using namespace corral::test;
using nlohmann::json;
using Words = std::vector<std::string>;

constexpr const char* rungs[] = {"floats", "intervals", "mpfr", "integers", "algebra"};

json localize(Words words, const std::string& box, const std::string& resolution, const std::string& format)
{
  words.insert(words.begin(), "localize");
  words.insert(words.end(), {"--box", box, "--resolution", resolution, "--format", format});
  const Program_run run = run_program(words);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  return json::parse(run.out);
}

// Every plotted cell is a hit, and the counts of the rungs agree with that.
void expect_all_decided(const json& summary)
{
  std::uint64_t hits = 0;
  for (const std::string rung : rungs) hits += summary.at("hit_by_" + rung).get<std::uint64_t>();
  EXPECT_EQ(summary["unknown"], 0) << summary;
  EXPECT_EQ(summary["plotted"], hits) << summary;
  EXPECT_FALSE(summary.contains("unknown_because"));
}

json without_rungs(json cells)
{
  for (auto& cell : cells) cell.erase(cell.size() - 1);
  return cells;
}

// The elliptic curve 24.a1. Its egg, from (-11, 0) to (6 - 12 sqrt(2), 0), is smaller than a cell and crosses a line of
// the grid.
TEST(Exact_option, decides_every_cell_of_an_elliptic_curve)
{
  const Words curve{"y^2 - x^3 + x^2 + 384*x + 2772"};
  Words exact = curve;
  exact.push_back("--exact");
  const json ideal = localize(exact, "-30:60,-300:300", "1024", "json");
  expect_all_decided(ideal);
  json egg = json::array();
  for (const auto& cell : ideal["cells"])
    if (cell[0] < 230) egg.push_back(cell);
  EXPECT_EQ(without_rungs(egg), (json{{216, 511, "hit"}, {216, 512, "hit"}}));
  const json fast = localize(curve, "-30:60,-300:300", "1024", "summary");
  EXPECT_LE(ideal["plotted"], fast["plotted"]);
  EXPECT_GE(ideal["plotted"], fast["hit"]);
  EXPECT_FALSE(fast.contains("hit_by_floats"));
}

// x^2 = y^2 passes through the corners of the 8 cells along each diagonal and those that touch it there: 8 and 14
// cells for each, of which the 4 in the middle belong to both.
TEST(Exact_option, closed_cells_touched_at_a_corner_are_hit)
{
  const json ideal = localize({"x^2 - y^2", "--exact"}, "-1:1,-1:1", "8", "json");
  const json cells = ideal["cells"];
  const auto touches = [](int i, int j) { return std::abs(i - j) <= 1 || std::abs(i + j - 7) <= 1; };
  std::size_t expected = 0;
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j) expected += touches(i, j) ? 1U : 0U;
  EXPECT_EQ(cells.size(), expected);
  for (const auto& cell : cells) {
    EXPECT_TRUE(touches(cell[0], cell[1])) << cell;
    EXPECT_EQ(cell[2], "hit");
    EXPECT_NE(std::find(std::begin(rungs), std::end(rungs), cell[3]), std::end(rungs)) << cell;
  }
}

TEST(Exact_option, knows_isolated_points_and_empty_sets)
{
  const json point = localize({"(x - 1/3)^2 + y^2", "--exact"}, "-1:1,-1:1", "33", "json");
  EXPECT_EQ(without_rungs(point["cells"]), (json{{21, 16, "hit"}, {22, 16, "hit"}}));
  const json none = localize({"x^2 + y^2 + 1e-30", "--exact"}, "-1:1,-1:1", "33", "json");
  EXPECT_EQ(none["cells"], json::array());
}

TEST(Exact_option, decides_two_equations)
{
  const json points = localize({"x^2 + y^2 - 1", "x - y", "--exact"}, "-1:1,-1:1", "5", "json");
  EXPECT_EQ(points["cells"],
            (json{{0, 0, "hit", "algebra"}, {4, 4, "hit", "algebra"}})); // at 0.7071, in cells from 0.6
}

TEST(Exact_option, decides_a_line)
{
  const json roots = localize({"(x^2 - 2)*(x - 1/2)^2", "--exact"}, "-2:2", "8", "json");
  EXPECT_EQ(without_rungs(roots["cells"]), (json{{1, "hit"}, {4, "hit"}, {5, "hit"}, {6, "hit"}}));
  EXPECT_EQ(roots["engine"], "paper");
}

TEST(Exact_option, decides_surfaces)
{
  expect_all_decided(localize({"x^2 + y^2 - z^2", "--exact"}, "-1:1,-1:1,-1:1", "9", "summary"));
}

// What a run prints for each cell agrees with the numbers in its summary.
TEST(Exact_option, says_of_each_cell_which_step_decided_it)
{
  const Words curve{"(x^2 - 2)^2 + (y^2 - 3)^2", "--exact"};
  const json points = localize(curve, "-2:2,-2:2", "4", "json");
  EXPECT_EQ(
      points["cells"],
      (json{{0, 0, "hit", "algebra"}, {0, 3, "hit", "algebra"}, {3, 0, "hit", "algebra"}, {3, 3, "hit", "algebra"}}));
  const json cubic = localize({"y^2 - x^3 + x", "--exact"}, "-2:2,-2:2", "37", "json");
  std::map<std::string, std::uint64_t> counts;
  for (const auto& cell : cubic["cells"]) ++counts[cell[3]];
  for (const std::string rung : rungs) EXPECT_EQ(counts[rung], cubic["hit_by_" + rung]) << rung;
  Words words = {
      "localize", "(x^2 - 2)^2 + (y^2 - 3)^2", "--box", "-2:2,-2:2", "--resolution", "4", "--exact", "--format", "csv"};
  EXPECT_EQ(run_program(words).out, "i,j,verdict\n0,0,hit\n0,3,hit\n3,0,hit\n3,3,hit\n");
  words.push_back("--rungs");
  EXPECT_EQ(run_program(words).out,
            "i,j,verdict,rung\n0,0,hit,algebra\n0,3,hit,algebra\n3,0,hit,algebra\n3,3,hit,algebra\n");
  EXPECT_NE(run_program({"localize", "x", "--box", "0:1", "--resolution", "4", "--rungs"}).exit_code, 0);
}

TEST(Exact_option, gives_the_same_for_any_number_of_threads)
{
  const auto run = [](const std::string& threads, const std::string& box) {
    json all = localize({"x^9 - x^7*y + 3*x^2*y^6 - y^3 + y^5 + y^4*x - 4*y^4*x^3", "--exact", "--threads", threads},
                        box, "128", "json");
    all.erase("seconds");
    return all;
  };
  const json one = run("1", "-1:1,-1:1");
  EXPECT_EQ(run("2", "-1:1,-1:1"), one);
  EXPECT_EQ(run("5", "-1:1,-1:1"), one);
  EXPECT_NE(run("2", "-1:1,-1:11/10"), one);
}

TEST(Recheck_option, decides_every_cell_a_second_time)
{
  const json curve = localize({"y^2 - x^3 + x", "--exact", "--recheck"}, "-2:2,-2:2", "64", "summary");
  EXPECT_EQ(curve["rechecked"], 4096);
  expect_all_decided(curve);
  EXPECT_EQ(localize({"y^2 - x^3 + x", "--exact"}, "-2:2,-2:2", "64", "summary").contains("rechecked"), false);
  const json surface =
      localize({"x^2 + y^2 - z^2", "--exact", "--recheck", "--threads", "2"}, "-1:1,-1:1,-1:1", "9", "summary");
  EXPECT_EQ(surface["rechecked"], 729);
  const json points = localize({"x^2 + y^2 - 1", "x - y", "--exact", "--recheck"}, "-1:1,-1:1", "5", "summary");
  EXPECT_EQ(points["rechecked"], 25);
  EXPECT_EQ(run_program({"localize", "x - y", "--box", "0:1,0:1", "--resolution", "4", "--recheck"}).exit_code, 2);
}

// Degree 60 with an isolated irrational point: minutes of work, stopped in a cell or in its resultant.
const std::string long_work = "(x^30 + y^30 - 1)^2 + (x - y)^60";

TEST(Exact_option, keeps_what_is_proved_on_an_interrupt)
{
  for (const std::string threads : {"1", "2"}) {
    const Temporary_folder folder;
    Program_limits limits;
    limits.folder = folder.path();
    limits.interrupt_after = std::chrono::milliseconds(1500);
    limits.seconds = 30;
    const Program_run run = run_program({"localize", long_work, "--box", "-2:2,-2:2", "--resolution", "64", "--exact",
                                         "--threads", threads, "--format", "json", "--output", "a.csv"},
                                        limits);
    EXPECT_EQ(run.exit_code, 130) << run.err;
    if (run.out.empty()) { // the interrupt came before the exact decision, on a very busy machine
      EXPECT_NE(run.err, "");
      EXPECT_TRUE(folder.files().empty());
      continue;
    }
    const json left = json::parse(run.out);
    EXPECT_GT(left["unknown"], 0);
    EXPECT_EQ(left["cells"].size(), left["plotted"]);
    for (const auto& cell : left["cells"])
      if (cell[2] == "unknown") {
        EXPECT_NE(cell[4].get<std::string>().find("stopped"), std::string::npos) << cell;
      }
    // Every cell that may be hit is still there: the zeros are +- (2^(-1/30), 2^(-1/30)).
    std::size_t around_zeros = 0;
    for (const auto& cell : left["cells"])
      around_zeros += (cell[0] == 47 && cell[1] == 47) || (cell[0] == 16 && cell[1] == 16) ? 1U : 0U;
    EXPECT_EQ(around_zeros, 2U);
    EXPECT_EQ(folder.files(), Words{"a.csv"});
  }
}

TEST(Repeat_option, reports_least_and_median_time)
{
  const json summary = localize({"x*y - 1/3", "--repeat", "4", "--threads", "2"}, "0:1,0:1", "64", "summary");
  EXPECT_EQ(summary["repeat"], 4);
  EXPECT_GT(summary["seconds_min"], 0.0);
  EXPECT_LE(summary["seconds_min"], summary["seconds_median"]);
  EXPECT_EQ(summary["seconds"], summary["seconds_median"]);
  const json once = localize({"x*y - 1/3"}, "0:1,0:1", "64", "summary");
  EXPECT_FALSE(once.contains("seconds_min"));
  EXPECT_EQ(once["plotted"], summary["plotted"]);
}

} // namespace
