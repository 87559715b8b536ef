// SPDX-License-Identifier: LGPL-3.0-or-later
#include <program/run_program.h>

#include <corral_check/check.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>

namespace {

using namespace corral::test;
using Words = std::vector<std::string>;

Program_run certify(const std::filesystem::path& folder, Words words)
{
  Program_limits limits;
  limits.folder = folder;
  words.insert(words.begin(), "certify");
  return run_program(words, limits);
}

TEST(Certify_command, writes_a_certificate_that_the_checker_accepts)
{
  const Temporary_folder folder;
  const auto run = certify(
      folder.path(), {"-1 + x^2 + y^2", "--box", "-2:2,-2:2", "--resolution", "16,8", "--output", "circle.json.gz"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const auto counts = corral_check::check(content(folder.path() / "circle.json.gz")).counts;
  EXPECT_EQ(counts.empty + counts.hit, 128U);
  EXPECT_EQ(run.out.rfind("certified: 128 cells, " + std::to_string(counts.empty) + " empty, "
                              + std::to_string(counts.hit) + " hit, 0 unknown; ",
                          0),
            0U)
      << run.out;
}

TEST(Certify_command, certifies_two_equations)
{
  const Temporary_folder folder;
  const auto run = certify(folder.path(), {"x^2 + y^2 + z^2 - 4", "(x - 1)^2 + y^2 - 1", "--box", "-2:2,-2:2,-2:2",
                                           "--resolution", "8", "--output", "viviani.json"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const auto counts = corral_check::check(content(folder.path() / "viviani.json")).counts;
  EXPECT_EQ(counts.empty + counts.hit, 512U);
  EXPECT_GT(counts.hit, 0U);
}

/// Minutes of work at degree 60; what is there after an interrupt is a certificate with unknown cells.
TEST(Certify_command, keeps_what_is_proved_on_an_interrupt)
{
  const Temporary_folder folder;
  Program_limits limits;
  limits.folder = folder.path();
  limits.interrupt_after = std::chrono::milliseconds(1500);
  const auto run = run_program(
      {"certify", "(x^30 + y^30 - 1)^2 + (x - y)^60", "--box", "-2:2,-2:2", "--resolution", "64", "--output", "a.json"},
      limits);
  EXPECT_EQ(run.exit_code, 130) << run.err;
  ASSERT_EQ(folder.files(), Words{"a.json"}) << run.err;
  const auto counts = corral_check::check(content(folder.path() / "a.json")).counts;
  EXPECT_GT(counts.unknown, 0U);
  EXPECT_EQ(counts.empty + counts.hit + counts.unknown, 4096U);
}

TEST(Certify_command, refuses_bad_input_in_one_line_and_writes_nothing)
{
  const struct
  {
    Words words;
    const char* hint;
    int exit_code = 2;
  } cases[] = {
      {{"x", "--box", "0:1", "--resolution", "4", "--output", "a.txt"}, ".json or .json.gz"},
      {{"x", "--box", "0:1", "--resolution", "0", "--output", "a.json"}, "resolution"},
      {{"x+", "--box", "0:1", "--resolution", "4", "--output", "a.json"}, "expected"},
      {{"x-x", "--box", "0:1", "--resolution", "4", "--output", "a.json"}, "zero"},
      {{"x", "--box", "0:1", "--resolution", "4"}, "--output"},
      {{"x", "--box", "0:1,0:1,0:1,0:1", "--resolution", "4", "--variables", "x,y,z,t", "--output", "a.json"},
       "1 to 3"},
      {{"x", "x-1", "--box", "0:1", "--resolution", "4", "--output", "a.json"}, "2 polynomials in 1 dimension"},
      {{"x^300*y^300-1", "--box", "0:1,0:1", "--resolution", "4", "--output", "a.json"}, "65536", 1},
      {{"x", "--box", "0:1", "--resolution", "4", "--output", "no/such/folder/a.json"}, "no/such/folder", 1},
  };
  for (const auto& c : cases) {
    SCOPED_TRACE(c.hint);
    const Temporary_folder folder;
    const auto run = certify(folder.path(), c.words);
    EXPECT_EQ(run.exit_code, c.exit_code);
    EXPECT_NE(run.err.find(c.hint), std::string::npos) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(folder.files(), Words{});
  }
}

} // namespace
