// SPDX-License-Identifier: LGPL-3.0-or-later
#include "run_program.h"

#include <program/one_line.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <csignal>
#include <fstream>

/// \file
/// How the program ends before its work is done. What does not obey is killed by the limit of processor time, which
/// gives another exit code: no test reads a clock.
namespace {

using namespace corral::test;
using Words = std::vector<std::string>;

std::string what(int signal) { return "signal " + std::to_string(signal); }

void expect_one_line(const std::string& err, const std::string& hint)
{
  EXPECT_EQ(err.rfind("corral: ", 0), 0U) << err;
  EXPECT_NE(err.find(hint), std::string::npos) << err;
  EXPECT_EQ(std::count(err.begin(), err.end(), '\n'), 1) << err;
}

bool has_part(const Temporary_folder& folder)
{
  const auto files = folder.files();
  return std::any_of(files.begin(), files.end(), [&](const std::string& name) {
    std::error_code gone;
    return name.ends_with(".part") && std::filesystem::file_size(folder.path() / name, gone) > 0 && !gone;
  });
}

// A resultant of degree 3600 takes minutes.
TEST(Stopping, a_long_step_of_the_exact_decision_is_left)
{
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const Temporary_folder folder;
    Program_limits limits;
    limits.folder = folder.path();
    limits.seconds = 30;
    limits.interrupt_after = std::chrono::milliseconds(4000);
    limits.signals = {signal};
    const auto run = run_program({"localize", "(x^30 + y^30 - 1)^2 + (x - y)^60", "--box", "-2:2,-2:2", "--resolution",
                                  "64", "--exact", "--output", "a.csv"},
                                 limits);
    EXPECT_EQ(run.exit_code, 128 + signal) << run.err;
    expect_one_line(run.err, "interrupted");
    EXPECT_FALSE(has_part(folder));
    if (run.out.empty()) continue; // it was still in the fast engine, on a very busy machine
    EXPECT_EQ(folder.files(), Words{"a.csv"});
    EXPECT_GT(nlohmann::json::parse(run.out)["unknown"], 0) << what(signal);
  }
}

TEST(Stopping, a_certificate_keeps_what_is_proved_or_nothing)
{
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const Temporary_folder folder;
    Program_limits limits;
    limits.folder = folder.path();
    limits.seconds = 30;
    limits.interrupt_after = std::chrono::milliseconds(1500);
    limits.signals = {signal};
    const auto run = run_program({"certify", "(x^30 + y^30 - 1)^2 + (x - y)^60", "--box", "-2:2,-2:2", "--resolution",
                                  "64", "--output", "a.json"},
                                 limits);
    EXPECT_EQ(run.exit_code, 128 + signal) << run.err;
    expect_one_line(run.err, "interrupted");
    EXPECT_EQ(folder.files(), run.out.empty() ? Words{} : Words{"a.json"}) << what(signal);
  }
}

// Exact fractions: some cells are decided within the time, and never all of them.
TEST(Stopping, a_localisation_keeps_what_is_proved_or_nothing)
{
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const Temporary_folder folder;
    Program_limits limits;
    limits.folder = folder.path();
    limits.seconds = 30;
    limits.interrupt_after = std::chrono::milliseconds(1500);
    limits.signals = {signal};
    const auto run = run_program({"localize", "x^30 + y^30 - x*y/7 - 1/3", "--box", "-2:2,-2:2", "--resolution", "4096",
                                  "--number", "rational", "--plus", "--output", "a.csv"},
                                 limits);
    EXPECT_EQ(run.exit_code, 128 + signal) << run.err;
    expect_one_line(run.err, "interrupted");
    EXPECT_EQ(folder.files(), run.out.empty() ? Words{} : Words{"a.csv"}) << what(signal);
    if (run.out.empty()) continue;
    const auto summary = nlohmann::json::parse(run.out);
    EXPECT_GT(summary["not_visited"], 0) << what(signal);
    EXPECT_GE(summary["unknown"], summary["not_visited"]) << what(signal);
  }
}

// Twelve million lines, two seconds of writing.
TEST(Stopping, a_file_that_is_being_written_is_left_out)
{
  for (const Words& names : {Words{"a.csv"}, Words{"a.csv", "b.csv"}})
    for (const std::vector<int>& signals :
         {std::vector{SIGINT}, std::vector{SIGTERM}, std::vector{SIGHUP}, std::vector{SIGINT, SIGINT}}) {
      const Temporary_folder folder;
      Program_limits limits;
      limits.folder = folder.path();
      limits.interrupt_when = [&] { return has_part(folder); };
      limits.signals = signals;
      Words words = {"localize", "x - y", "--box", "0:1,0:1", "--resolution", "4194304"};
      for (const auto& name : names) words.insert(words.end(), {"--output", name});
      const auto run = run_program(words, limits);
      EXPECT_EQ(run.exit_code, 128 + signals.front()) << run.err;
      expect_one_line(run.err, "interrupted");
      if (run.out.empty())
        EXPECT_EQ(folder.files(), Words{}) << what(signals.front());
      else
        EXPECT_EQ(folder.files(), names) << "it was done in time"; // and must not be half
    }
}

TEST(Stopping, a_lost_terminal_is_ignored_when_that_is_asked_for)
{
  const auto before = std::signal(SIGHUP, SIG_IGN); // as nohup does
  const Temporary_folder folder;
  Program_limits limits;
  limits.folder = folder.path();
  limits.interrupt_when = [&] { return has_part(folder); };
  limits.signals = {SIGHUP};
  const auto run =
      run_program({"localize", "x - y", "--box", "0:1,0:1", "--resolution", "262144", "--output", "a.csv"}, limits);
  std::signal(SIGHUP, before);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(folder.files(), Words{"a.csv"});
}

TEST(Outputs, are_all_written_or_none)
{
  for (const Words& outputs :
       {Words{"a.csv", "nowhere/b.csv"}, Words{"nowhere/b.csv", "a.csv"}, Words{"a.csv", "d.json"}}) {
    const Temporary_folder folder;
    std::filesystem::create_directory(folder.path() / "d.json");
    Program_limits limits;
    limits.folder = folder.path();
    Words words = {"localize", "x - y", "--box", "0:1,0:1", "--resolution", "8"};
    for (const auto& name : outputs) words.insert(words.end(), {"--output", name});
    const auto run = run_program(words, limits);
    EXPECT_EQ(run.exit_code, 1);
    expect_one_line(run.err, "output: cannot write");
    EXPECT_EQ(folder.files(), Words{"d.json"});
  }
}

TEST(Outputs, on_a_disk_that_fills_up_leave_no_other)
{
  const Temporary_folder folder;
  Program_limits limits;
  limits.folder = folder.path();
  limits.file_size = 2000;
  const auto run = run_program(
      {"localize", "x - y", "--box", "0:1,0:1", "--resolution", "512", "--output", "a.txt", "--output", "b.csv"},
      limits);
  EXPECT_EQ(run.exit_code, 1);
  expect_one_line(run.err, "output: cannot write");
  EXPECT_EQ(folder.files(), Words{});
}

TEST(Outputs, do_not_overwrite_an_input)
{
  const Temporary_folder folder;
  Program_limits limits;
  limits.folder = folder.path();
  const auto write = [&](const std::string& name, const std::string& text) {
    std::ofstream(folder.path() / name) << text;
  };
  write("io.txt", "x - y");
  write("io.json", "x - y");
  write("cells.json", "0,0\n");
  std::filesystem::create_symlink("io.txt", folder.path() / "link.txt");
  const Words grid = {"--box", "0:1,0:1", "--resolution", "8", "--output"};
  const auto expect_refused = [&](Words words, const std::string& output) {
    words.insert(words.end(), grid.begin(), grid.end());
    words.push_back(output);
    const auto run = run_program(words, limits);
    EXPECT_EQ(run.exit_code, 2) << run.err;
    expect_one_line(run.err, "output: '" + output + "' is the file that ");
  };
  expect_refused({"localize", "@io.txt"}, "io.txt");
  expect_refused({"localize", "x + y", "@./io.txt"}, "io.txt");
  expect_refused({"localize", "@io.txt"}, "link.txt");
  expect_refused({"localize", "@link.txt", "--output", "a.csv"}, "io.txt");
  expect_refused({"certify", "@io.json"}, "io.json");
  expect_refused({"audit", "raster", "@io.json", "--cells", "cells.json"}, "io.json");
  expect_refused({"audit", "raster", "x - y", "--cells", "cells.json"}, "cells.json");
  EXPECT_EQ(content(folder.path() / "io.txt"), "x - y");
  EXPECT_EQ(content(folder.path() / "io.json"), "x - y");
  EXPECT_EQ(content(folder.path() / "cells.json"), "0,0\n");
  EXPECT_EQ(folder.files(), (Words{"cells.json", "io.json", "io.txt", "link.txt"}));
  EXPECT_EQ(run_program({"localize", "@io.txt", "--box", "0:1,0:1", "--resolution", "8", "--output", "a.txt"}, limits)
                .exit_code,
            0);
}

// GMP would abort: the bound has 10^9 bits.
TEST(Memory, that_arithmetic_lacks_is_said)
{
  const Temporary_folder folder;
  Program_limits limits;
  limits.folder = folder.path();
  limits.memory = std::size_t{160} << 20;
  const auto run = run_program({"bound", "x^1000*y^1000*z^1000", "--box", "1:1e100000,1:1e100000,1:1e100000",
                                "--number", "rational", "--bounder", "natural"},
                               limits);
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.err, "corral: out of memory\n");
  EXPECT_EQ(run.out, "");
}

TEST(Messages, escape_what_a_terminal_would_obey)
{
  using corral::program::one_line;
  EXPECT_EQ(one_line("plain, with 'quotes'"), "plain, with 'quotes'");
  EXPECT_EQ(one_line("two\nlines\tand a tab"), "two lines and a tab");
  EXPECT_EQ(one_line("\x1b[31mred\x7f"), "\\x1b[31mred\\x7f");
  EXPECT_EQ(one_line("caf\xc3\xa9 \xe2\x88\x9e \xf0\x9f\x98\x80"), "caf\xc3\xa9 \xe2\x88\x9e \xf0\x9f\x98\x80");
  EXPECT_EQ(one_line("\xff\xc3"), "\\xff\\xc3");
  EXPECT_EQ(one_line("\xc2\x9b"), "\\xc2\\x9b");          // the one-byte escape of a terminal
  EXPECT_EQ(one_line("\xe2\x80\xae"), "\\xe2\\x80\\xae"); // turns the direction of text
  EXPECT_EQ(one_line("\xed\xa0\x80"), "\\xed\\xa0\\x80"); // half a pair of UTF-16
  EXPECT_EQ(one_line("\xc0\xaf"), "\\xc0\\xaf");          // longer than it need be
  EXPECT_LE(one_line(std::string(5000, '\x01')).size(), 603U);
}

TEST(Messages, about_rasters_escape_raw_bytes)
{
  for (const std::string bytes : {"0,\x1b[2J", "\xff\xfe,1", "0,1,\x9bm"}) {
    const Temporary_folder folder;
    std::ofstream(folder.path() / "r.csv") << "i,j,verdict\n" << bytes << '\n';
    Program_limits limits;
    limits.folder = folder.path();
    const auto run =
        run_program({"audit", "raster", "x - y", "--box", "0:1,0:1", "--resolution", "8", "--cells", "r.csv"}, limits);
    EXPECT_EQ(run.exit_code, 2);
    expect_one_line(run.err, "raster: 'r.csv', line 2: ");
    EXPECT_TRUE(std::all_of(run.err.begin(), run.err.end(), [](unsigned char c) {
      return c == '\n' || (c >= 0x20 && c < 0x7f);
    })) << run.err;
  }
}

} // namespace
