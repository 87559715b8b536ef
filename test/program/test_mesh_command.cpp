// SPDX-License-Identifier: LGPL-3.0-or-later
#include "run_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <random>

namespace {

using namespace corral::test;
using Words = std::vector<std::string>;

nlohmann::json summary(Words arguments)
{
  arguments.insert(arguments.begin(), "mesh");
  const auto run = run_program(arguments);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  return nlohmann::json::parse(run.out);
}

TEST(Mesh_command, prints_the_counts)
{
  const auto json = summary({"(x^2+y^2-1)*(x^2+y^2-4)", "--box", "-3:3,-3:3", "--repeat", "3"});
  EXPECT_EQ(json["components"], 2);
  EXPECT_EQ(json["closed_components"], 2);
  EXPECT_EQ(json["euler_characteristic"], 0);
  EXPECT_EQ(json["certified"], true);
  EXPECT_EQ(json["repeat"], 3);
  EXPECT_EQ(json["tolerance"], "3/500");
}

TEST(Mesh_command, gives_the_same_with_several_threads)
{
  const Words curves{"x^2+y^2-1", "y^2-x^3+x", "x*y", "(x^2-2)^2+(y^2-3)^2", "y-x^5"};
  const auto with = [&](const char* threads) {
    Words arguments = curves;
    arguments.insert(arguments.end(), {"--box", "-2:2,-2:2", "--format", "json", "--threads", threads});
    auto json = summary(arguments);
    json.erase("seconds");
    return json;
  };
  const auto one = with("1");
  EXPECT_EQ(one["curves"].size(), curves.size());
  EXPECT_EQ(with("3"), one);
  EXPECT_EQ(with("0"), one);
}

TEST(Mesh_command, writes_all_files_or_none)
{
  const Temporary_folder folder;
  Program_limits limits;
  limits.folder = folder.path();
  const Words curve{"mesh", "x^2+y^2-1", "--box", "-2:2,-2:2"};
  auto arguments = curve;
  for (const char* name : {"a.svg", "a.png", "a.json", "a.csv", "a.dxf", "a.wkt"}) {
    arguments.emplace_back("--output");
    arguments.emplace_back(name);
  }
  EXPECT_EQ(run_program(arguments, limits).exit_code, 0);
  EXPECT_EQ(folder.files(), (Words{"a.csv", "a.dxf", "a.json", "a.png", "a.svg", "a.wkt"}));
  arguments = curve;
  arguments.insert(arguments.end(), {"--output", "b.svg", "--output", "no/such/folder/b.csv"});
  EXPECT_NE(run_program(arguments, limits).exit_code, 0);
  EXPECT_EQ(folder.files().size(), 6U);
}

void expect_refusal(const Words& arguments)
{
  const auto run = run_program(arguments);
  EXPECT_TRUE(run.exit_code == 1 || run.exit_code == 2) << run.exit_code << ' ' << run.err;
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
}

TEST(Mesh_command, refuses_in_one_line)
{
  const auto with = [&](Words arguments) {
    arguments.insert(arguments.begin(), "mesh");
    expect_refusal(arguments);
  };
  with({"x^2+", "--box", "-1:1,-1:1"});
  with({"0*x*y", "--box", "-1:1,-1:1"});
  with({"x*y*z", "--box", "-1:1,-1:1,-1:1"});
  with({"x+y", "--box", "1:1,-1:1"});
  with({"x+y", "--box", "-1:1,-1:1", "--tolerance", "0"});
  with({"x+y", "--box", "-1:1,-1:1", "--tolerance", "-1"});
  with({"x+y", "--box", "-1:1,-1:1", "--tolerance", "a"});
  with({"x+y", "--box", "-1:1,-1:1", "--output", "a.stl"});
  with({"x+y"});
}

// Texts of random letters: whatever they are, one line of complaint or one object of JSON.
TEST(Mesh_command, survives_random_arguments)
{
  std::mt19937 random(17);
  const std::string letters = "xy0123456789+-*^()/., :z";
  const auto word = [&] {
    std::string result;
    for (auto length = 1 + random() % 12; length > 0; --length) result += letters[random() % letters.size()];
    return result;
  };
  for (int round = 0; round < 40; ++round) {
    const Words arguments{"mesh", "--max-cells", "2000", "--box=" + (round % 2 == 0 ? word() : "-1:1,-1:1"),
                          "--",   word()};
    const auto run = run_program(arguments);
    if (run.exit_code == 0)
      EXPECT_TRUE(nlohmann::json::parse(run.out).contains("certified"));
    else {
      EXPECT_TRUE(run.exit_code == 1 || run.exit_code == 2) << arguments.back() << ' ' << run.exit_code;
      EXPECT_EQ(run.out, "");
    }
  }
}

// Circles 10^-9 apart take far longer than the limit of processor time.
TEST(Mesh_command, keeps_what_is_certified_when_interrupted_or_nothing)
{
  const Temporary_folder folder;
  Program_limits limits;
  limits.folder = folder.path();
  limits.seconds = 30;
  limits.interrupt_after = std::chrono::milliseconds(1500);
  const auto run = run_program({"mesh", "(x^2+y^2-1)*(x^2+y^2-1-1/1000000000)", "--box", "-2:2,-2:2", "--max-cells",
                                "1000000000", "--tolerance", "1/1000000000", "--output", "a.svg"},
                               limits);
  EXPECT_EQ(run.exit_code, 128 + SIGINT) << run.err;
  EXPECT_EQ(folder.files(), run.out.empty() ? Words{} : Words{"a.svg"});
  if (run.out.empty()) return; // a step did not end in time
  const auto summary = nlohmann::json::parse(run.out);
  EXPECT_EQ(summary["certified"], false);
  EXPECT_FALSE(summary["uncertified_regions"].empty());
}

} // namespace
