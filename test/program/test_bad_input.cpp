// SPDX-License-Identifier: LGPL-3.0-or-later
#include "run_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

namespace {

using namespace corral::test;
using Words = std::vector<std::string>;

// Runs the program in an empty folder and expects one line of complaint that holds `hint`, the exit code, nothing on
// standard output and no file.
void expect_refusal(const Words& arguments, int exit_code, const std::string& hint, Program_limits limits = {})
{
  const Temporary_folder folder;
  limits.folder = folder.path();
  limits.memory = std::size_t{2} << 30;
  const Program_run run = run_program(arguments, limits);
  std::string command;
  for (const auto& argument : arguments) command += ' ' + argument.substr(0, 60);
  EXPECT_EQ(run.exit_code, exit_code) << command;
  EXPECT_EQ(run.err.rfind("corral: ", 0), 0U) << command << '\n' << run.err;
  EXPECT_NE(run.err.find(hint), std::string::npos) << command << '\n' << run.err;
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << command << '\n' << run.err;
  EXPECT_LT(run.err.size(), 700U);
  EXPECT_EQ(run.out, "") << command;
  EXPECT_EQ(folder.files(), Words{}) << command;
}

// localize with a good box, resolution and output, so that only the rest can be wrong.
void expect_polynomial_refused(const std::string& polynomial, const std::string& hint)
{
  expect_refusal({"localize", polynomial, "--box", "0:1,0:1", "--resolution", "8", "--output", "a.csv"}, 2, hint);
}

void expect_box_refused(const std::string& box, const std::string& hint)
{
  expect_refusal({"localize", "x + y", "--box", box, "--resolution", "8", "--output", "a.csv"}, 2, hint);
}

void expect_resolution_refused(const std::string& resolution, const std::string& hint)
{
  expect_refusal({"localize", "x + y", "--box", "0:1,0:1", "--resolution", resolution, "--output", "a.csv"}, 2, hint);
}

TEST(Bad_input, polynomials)
{
  expect_polynomial_refused("(x", "this ( has no )");
  expect_polynomial_refused("x)", "this ) has no (");
  expect_polynomial_refused("1/2x", "(a/2)*x or a/(2*x)");
  expect_polynomial_refused("1/0", "division by zero");
  expect_polynomial_refused("x^-1", "exponent");
  expect_polynomial_refused("sin(x)+y", "the function sin is no polynomial");
  expect_polynomial_refused("x=y=1", "a second equals sign");
  expect_polynomial_refused("x^1000000", "degree 1000000");
  expect_polynomial_refused("x + \xc3\xa9", "ASCII");
  expect_polynomial_refused("x + \x01\n", "ASCII");
  expect_polynomial_refused("xy - 1", "'xy' is a new name; a product is written x*y");
  expect_polynomial_refused("x^2 - pi", "'pi' is a new name; pi is not rational");
  expect_polynomial_refused("", "expected");
  expect_polynomial_refused("x - x", "every point is a zero");
  expect_polynomial_refused("0", "every point is a zero");
  expect_polynomial_refused("x + y + z", "x, y, z");
  expect_polynomial_refused("@missing.txt", "cannot read");
  expect_refusal({"localize", "x + q", "--variables", "x,y", "--box", "0:1,0:1", "--resolution", "8"}, 2,
                 "unknown variable");
}

TEST(Bad_input, boxes)
{
  expect_box_refused("", "LOWER:UPPER");
  expect_box_refused("0:0,0:1", "side 1 of the box is [0, 0]; expected lower < upper");
  expect_box_refused("1:0,0:1", "side 1 is '1:0'; expected LOWER:UPPER with LOWER <= UPPER");
  expect_box_refused("0:1,0", "side 2 is '0'");
  expect_box_refused("0:inf,0:1", "finite");
  expect_box_refused("nan:1,0:1", "finite");
  expect_box_refused("0:1e999999999,0:1", "finite");
  expect_box_refused("0:1", "given 1 side; expected one for each of the variables x, y");
  expect_box_refused("0:1,0:1,0:1,0:1,0:1", "expected 1 to 4");
  expect_refusal({"localize", "x", "--variables", "x,y,z", "--box", "0:1,0:1", "--resolution", "8"}, 2,
                 "expected 2 names");
  expect_refusal({"localize", "x", "--variables", "x,x", "--box", "0:1,0:1", "--resolution", "8"}, 2,
                 "variables: given 'x' twice");
  expect_refusal({"localize", "x", "--variables", "x,2", "--box", "0:1,0:1", "--resolution", "8"}, 2,
                 "variables: given '2'; expected a letter");
}

TEST(Bad_input, resolutions)
{
  expect_resolution_refused("0", "'0'");
  expect_resolution_refused("-5", "'-5'");
  expect_resolution_refused("1099511627776", "1 to 1073741824");
  expect_resolution_refused("99999999999999999999999999", "1 to 1073741824");
  expect_resolution_refused("1.5", "whole number");
  expect_resolution_refused("8,8,8", "given 3 numbers; expected 1 or 2");
  expect_refusal({"localize", "x", "--box", "0:1", "--resolution", "8,8"}, 2, "given 2 numbers; expected 1\n");
  expect_resolution_refused("", "whole number");
}

TEST(Bad_input, usage)
{
  expect_refusal({"locate"}, 2, "expected one of localize");
  expect_refusal({"--colour"}, 2, "given '--colour'; expected one of localize");
  expect_refusal({"-x+1"}, 2, "given '-x+1'; expected one of localize");
  expect_refusal({"localize"}, 2, "--help");
  expect_refusal({"localize", "x"}, 2, "--help");
  expect_refusal({"localize", "x", "--box", "0:1", "--resolution", "8", "--colour"}, 2, "--colour");
  expect_refusal({"localize", "x", "--box", "0:1,0:1", "--resolution", "8", "--format", "xml"}, 2,
                 "csv,json,text,summary");
}

TEST(Bad_input, bound)
{
  const auto refuse = [](const std::string& option, const std::string& value, const std::string& hint) {
    expect_refusal({"bound", "x + y", "--box", "0:1,0:1", option, value}, 2, hint);
  };
  refuse("--bounder", "best", "expected one of ");
  refuse("--bounder", "best", "maa, natural");
  refuse("--number", "float", "double_nearest, double_outward, cgal_interval, mpfr, rational, counted");
  for (const char* const order : {"0", "-1", "2.5", "99999999999999999999", "two", ""})
    refuse("--order", order, "--order: given '" + std::string(order) + "'; expected a whole number from 1");
  refuse("--precision", "10", "53");
  expect_refusal({"bound", "x + y", "--box", "0:1"}, 2, "x, y");
  expect_refusal({"bound", "x + y", "--box", "1:0,0:1"}, 2, "LOWER <= UPPER");
  expect_refusal({"bound", "x +", "--box", "0:1"}, 2, "expected");
  expect_refusal({"bound", "x"}, 2, "--box");
  expect_refusal({"bound", "x", "--box", "0:1", "--at", "q"}, 2, "at: number: given 'q'; expected a digit");
  expect_refusal({"bound", "x", "--box", "0:1", "--at", ""}, 2, "at: given 0 coordinates; expected 1");
}

TEST(Bad_input, methods_of_localize)
{
  const auto refuse = [](const std::string& option, const std::string& value, const std::string& hint) {
    expect_refusal({"localize", "x + y", "--box", "0:1,0:1", "--resolution", "8", option, value}, 2, hint);
  };
  refuse("--bounder", "best", "expected one of rt, maa, ");
  refuse("--number", "float", "expected one of double_nearest, ");
  refuse("--order", "0", "expected a whole number from 1");
  refuse("--order", "-1", "given '-1'; expected a whole number from 1");
  refuse("--precision", "52", "expected 53");
  refuse("--threads", "1000000", "expected a whole number from 0 to 1024");
  refuse("--max-cells", "-1", "expected a whole number");
  expect_refusal({"localize", "x", "--box", "0:1", "--resolution", "8", "--bounder", "maa", "--order", "0"}, 2,
                 "order");
  expect_refusal(
      {"localize", "x", "--box", "0:1,0:1,0:1,0:1", "--variables", "t,x,y,z", "--resolution", "2", "--exact"}, 2,
      "given 1 polynomial in 4 dimensions");
  refuse("--size", "63", "expected a whole number from 64 to 8192");
}

TEST(Bad_input, reproduce)
{
  expect_refusal({"reproduce"}, 2, "WHAT");
  expect_refusal({"reproduce", "table5"}, 2, "table5 not in");
  expect_refusal({"reproduce", "table4", "--format", "xml"}, 2, "xml not in");
  for (const char* const what : {"table4", "figures", "all"}) {
    expect_refusal({"reproduce", what, "--number", "float", "--output", "new"}, 2, "expected one of double_nearest, ");
    expect_refusal({"reproduce", what, "--output", "/proc/new"}, 1, "cannot make folder '/proc/new'");
  }
}

TEST(Bad_input, certify)
{
  const auto refuse = [](const std::string& polynomial, const std::string& box, const std::string& resolution,
                         const std::string& hint) {
    expect_refusal({"certify", polynomial, "--box", box, "--resolution", resolution, "--output", "a.json"}, 2, hint);
  };
  refuse("(x", "0:1", "8", "this ( has no )");
  refuse("x^1000000", "0:1", "8", "degree 1000000");
  refuse("x + \xc3\xa9", "0:1", "8", "ASCII");
  refuse("0", "0:1,0:1", "8", "every point is a zero");
  refuse("x", "0:0", "8", "expected lower < upper");
  refuse("x", "1:0", "8", "LOWER <= UPPER");
  refuse("x", "0:inf", "8", "finite");
  refuse("x + y", "0:1", "8", "x, y");
  refuse("x", "0:1", "-5", "'-5'");
  refuse("x", "0:1", "1099511627776", "1 to 1073741824");
  expect_refusal({"certify", "x", "--box", "0:1", "--resolution", "8", "--max-boxes", "0", "--output", "a.json"}, 2,
                 "--max-boxes: given '0'");
  Program_limits full;
  full.file_size = 100;
  for (const char* const name : {"a.json", "a.json.gz"})
    expect_refusal({"certify", "x^2 + y^2 - 1", "--box", "-2:2,-2:2", "--resolution", "16", "--output", name}, 1,
                   "File too large", full);
}

TEST(Bad_input, exact_and_repeat)
{
  const auto refuse = [](Words words, const std::string& box, const std::string& hint) {
    words.insert(words.begin(), "localize");
    words.insert(words.end(), {"--box", box, "--resolution", "8", "--output", "a.csv"});
    expect_refusal(words, 2, hint);
  };
  refuse({"x - y", "x + y", "x*y", "--exact"}, "0:1,0:1", "given 3 polynomials");
  refuse({"x", "x - 1", "--exact"}, "0:1", "given 2 polynomials in 1 dimension;");
  refuse({"x - y", "--repeat", "0"}, "0:1,0:1", "--repeat");
  refuse({"x - y", "--repeat", "-3"}, "0:1,0:1", "--repeat");
}

TEST(Bad_input, outputs)
{
  const Words good{"localize", "x - y", "--box", "0:1,0:1", "--resolution", "2000"};
  const auto with = [&](Words more) {
    more.insert(more.begin(), good.begin(), good.end());
    return more;
  };
  expect_refusal(with({"--output", "a.gif"}), 2, ".png .svg");
  expect_refusal(with({"--output", "a"}), 2, ".png .svg");
  expect_refusal(with({"--output", "a.off"}), 2, ".png .svg"); // for surfaces only
  expect_refusal(with({"--output", "nowhere/a.csv"}), 1, "No such file or directory");
  expect_refusal(with({"--output", "/proc/a.csv"}), 1, "cannot write");
  expect_refusal(with({"--output", "a.png", "--size", "1"}), 2, "from 64 to 8192");
  expect_refusal(with({"--max-cells", "100"}), 1, "100 cells");
  for (const char* const name : {"a.csv", "a.json", "a.png", "a.svg"}) {
    Program_limits full;
    full.file_size = 1000;
    expect_refusal(with({"--output", name}), 1, "File too large", full);
  }
}

TEST(Bad_input, full_standard_output)
{
  Program_limits limits;
  limits.out_file = "/dev/full";
  for (const char* const format : {"csv", "json", "text", "summary"}) {
    const Program_run run =
        run_program({"localize", "x - y", "--box", "0:1,0:1", "--resolution", "100", "--format", format}, limits);
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_EQ(run.err, "corral: output: cannot write standard output: No space left on device\n");
  }
  for (const Words& command : {Words{"list"}, Words{"bound", "x", "--box", "0:1"}, Words{"--help"}, Words{"--version"},
                               Words{"reproduce", "table4"}}) {
    const Program_run run = run_program(command, limits);
    EXPECT_EQ(run.exit_code, 1) << command[0];
    EXPECT_EQ(run.err, "corral: output: cannot write standard output: No space left on device\n") << command[0];
  }
}

TEST(Good_input, that_looks_bad)
{
  const Temporary_folder folder;
  const auto write = [&](const char* name, const std::string& text) { std::ofstream(folder.path() / name) << text; };
  write("nested.txt", std::string(100000, '(') + "x" + std::string(100000, ')') + " - y\n");
  write("minus.txt", std::string(100000, '-') + "x - y");
  write("digits.txt", std::string(100000, '7') + "*x - " + std::string(100000, '7') + "*y");
  Program_limits limits;
  limits.folder = folder.path();
  limits.memory = std::size_t{2} << 30;
  // The verdicts may differ: floating point need not see that the corners are exact zeros.
  const auto cells = [](std::string csv) {
    for (const std::string verdict : {",hit", ",unknown"})
      for (auto at = csv.find(verdict); at != std::string::npos; at = csv.find(verdict)) csv.erase(at, verdict.size());
    return csv;
  };
  std::string diagonal;
  for (const char* const polynomial : {"x - y", "@nested.txt", "@minus.txt", "@digits.txt", "-y + x", "-(y - x)"}) {
    const Program_run run =
        run_program({"localize", polynomial, "--box", "0:1,0:1", "--resolution", "8", "--format", "csv"}, limits);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.err, "");
    if (diagonal.empty()) diagonal = cells(run.out);
    EXPECT_EQ(cells(run.out), diagonal) << polynomial;
  }
  const Program_run constant =
      run_program({"localize", "7", "--box", "0:1,-1:1", "--resolution", "8", "--format", "csv"});
  EXPECT_EQ(constant.exit_code, 0);
  EXPECT_EQ(constant.out, "i,j,verdict\n");
}

// Without it, a test of the tests above could pass because nothing runs at all.
TEST(Bad_input, is_told_from_good_input)
{
  const Program_run run = run_program({"localize", "x - y", "--box", "0:1,0:1", "--resolution", "8"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.err, "");
  EXPECT_NE(run.out, "");
}

} // namespace
