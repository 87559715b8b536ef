// SPDX-License-Identifier: LGPL-3.0-or-later
#include "run_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace {

using namespace corral::test;
using nlohmann::json;
using Words = std::vector<std::string>;

/// A folder with files, in which the program runs.
class Input : public testing::Test
{
protected:
  void write(const std::string& name, const std::string& text) const { std::ofstream(folder_.path() / name) << text; }

  [[nodiscard]] Program_run run(const Words& words) const
  {
    Program_limits limits;
    limits.folder = folder_.path();
    return run_program(words, limits);
  }

  /// The summary of `localize` in a small grid.
  [[nodiscard]] json summary(Words words, const std::string& box = "-2:2,-2:2") const
  {
    words.insert(words.begin(), "localize");
    words.insert(words.end(), {"--box", box, "--resolution", "4"});
    const Program_run answer = run(words);
    EXPECT_EQ(answer.exit_code, 0) << words[1] << '\n' << answer.err;
    return answer.exit_code == 0 ? json::parse(answer.out) : json();
  }

  [[nodiscard]] json reading(const Words& words, const std::string& box = "-2:2,-2:2") const
  {
    return summary(words, box).value("polynomial", json());
  }

  /// The complaint about words that must be refused.
  [[nodiscard]] std::string refusal(const Words& words) const
  {
    const Program_run answer = run(words);
    EXPECT_EQ(answer.exit_code, 2) << words[1];
    EXPECT_EQ(answer.out, "") << words[1];
    return answer.err;
  }

  Temporary_folder folder_;
};

bool says(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

TEST_F(Input, names_no_axis_silently)
{
  EXPECT_EQ(reading({"x*y-1"}), "x*y - 1");
  EXPECT_EQ(reading({"xy-1", "--variables", "x,y"}), "x*y - 1");
  EXPECT_EQ(reading({"x^2 + 3xy = y"}), "x^2 + 3*x*y - y"); // x and y stand alone, too
  EXPECT_EQ(reading({"a^2 - b"}), "a^2 - b");
  EXPECT_EQ(reading({"x1^2 - x2"}), "x1^2 - x2");
  EXPECT_EQ(reading({"e^2 - pi", "--variables", "pi,e"}), "-pi + e^2");
  EXPECT_EQ(summary({"x - 1"})["variables"], (json{"x", "y"}));
  const Words everywhere[] = {{"localize", "F", "--resolution", "4", "--box", "0:1,0:1"},
                              {"bound", "F", "--box", "0:1,0:1"},
                              {"certify", "F", "--resolution", "4", "--output", "a.json", "--box", "0:1,0:1"},
                              {"mesh", "F", "--box", "0:1,0:1"},
                              {"solve", "F"},
                              {"audit", "raster", "F", "--cells", "a.csv", "--resolution", "4", "--box", "0:1,0:1"}};
  for (Words words : everywhere) {
    auto& formula = *std::find(words.begin(), words.end(), "F");
    formula = "xy - 1";
    EXPECT_TRUE(says(refusal(words), "'xy' is a new name; a product is written x*y")) << words[0];
    formula = "x^2 - pi";
    EXPECT_TRUE(says(refusal(words), "'pi' is a new name; pi is not rational")) << words[0];
    formula = "x^2 - e";
    EXPECT_TRUE(says(refusal(words), "'e' is a new name; e is not read as a number")) << words[0];
    formula = "x2 - y";
    EXPECT_TRUE(says(refusal(words), "'x2' is a new name; a power is written x^2, a product 2*x")) << words[0];
    formula = "sin(x) - y";
    EXPECT_TRUE(says(refusal(words), "the function sin is no polynomial")) << words[0];
  }
  EXPECT_TRUE(says(refusal({"bound", "a - 1", "--box", "0:1,0:1"}), "'a' is a new name"));
  EXPECT_TRUE(says(refusal({"bound", "x - 1", "--box", "0:1,0:1,0:1,0:1"}), "expected a name for each"));
}

TEST_F(Input, says_what_was_read)
{
  write("none.csv", "i,j,verdict\n");
  EXPECT_EQ(reading({"2x(y+1)=1", "x-y"}), (json{"2*x*y + 2*x - 1", "x - y"}));
  EXPECT_EQ(run({"bound", "2x(y+1)=1", "--box", "0:1,0:1", "--number", "rational"}).out.substr(0, 28),
            "polynomial: 2*x*y + 2*x - 1\n");
  EXPECT_EQ(json::parse(run({"mesh", "xx=y", "--variables", "x,y", "--box", "0:1,0:1"}).out)["polynomial"], "x^2 - y");
  EXPECT_EQ(json::parse(run({"solve", "2x=1", "--format", "json"}).out)["polynomial"], "2*x - 1");
  EXPECT_TRUE(says(run({"certify", "2x=1", "--box", "2:3", "--resolution", "2", "--output", "a.json"}).out,
                   "\npolynomial: 2*x - 1\n"));
  EXPECT_EQ(json::parse(run({"audit", "raster", "y=7x", "--box", "2:3,0:1", "--resolution", "4", "--cells", "none.csv",
                             "--format", "json"})
                            .out)["polynomial"],
            "-7*x + y");
}

TEST_F(Input, files_have_one_polynomial_a_line)
{
  write("two.txt", "x^2+y^2-1\n-x+y\n");
  EXPECT_EQ(reading({"@two.txt"}), (json{"x^2 + y^2 - 1", "-x + y"}));
  EXPECT_EQ(reading({"x^2+y^2-1\n-x+y"}), (json{"x^2 + y^2 - 1", "-x + y"}));
  write("long.txt", "\xef\xbb\xbf# a circle and a line\r\nx^2 + # and so on\r\n  y^2 \\\r\n -1;\r\n\r\n(x\n-y\n)\n");
  EXPECT_EQ(reading({"@long.txt"}), (json{"x^2 + y^2 - 1", "x - y"}));
  write("one.txt", "x\n= y # not the end of it");
  EXPECT_TRUE(says(refusal({"bound", "@one.txt", "--box", "0:1,0:1"}), "given 2 of them"));
  write("one.txt", "x =\ny");
  EXPECT_EQ(reading({"@one.txt"}), "x - y");
  write("broken.txt", "x^2 + y^2\n- 1\n"); // a system without a zero, or a circle?
  EXPECT_TRUE(says(refusal({"solve", "@broken.txt"}), "'broken.txt', line 2 is a number; expected a polynomial"));
  write("empty.txt", "# nothing\n\n");
  EXPECT_TRUE(says(refusal({"solve", "@empty.txt"}), "file 'empty.txt' has none"));
}

TEST_F(Input, errors_in_files_have_line_column_and_caret)
{
  const auto refused = [&](const std::string& text) {
    write("f.txt", text);
    return refusal({"localize", "@f.txt", "--box", "0:1,0:1", "--resolution", "4"});
  };
  EXPECT_EQ(
      refused("# ellipse\nx^2 + 2y^2 - 1\n  x\xe2\x88\x92y + sin(x)\n"),
      "corral: file 'f.txt', line 3, column 9: the function sin is no polynomial; expected sums, products and powers "
      "of variables and numbers\n"
      "    x\xe2\x88\x92y + sin(x)\n"
      "          ^\n");
  EXPECT_TRUE(says(refused("x - (y\n + 1) +\n $"), "line 3, column 2: no polynomial has '$'"));
  EXPECT_TRUE(says(refused("x*y\nx < y\n"), "line 2, column 3: an inequality"));
  EXPECT_TRUE(says(refused("x; y\n"), "line 1, column 2: text behind the ;"));
  EXPECT_TRUE(says(refused("0,5x\n"), "line 1, column 2: a comma; decimals have a point"));
  EXPECT_TRUE(says(refused("x\n(y"), "line 2, column 1: this ( has no )\n  (y\n  ^\n"));
  EXPECT_TRUE(says(refused("\xef\xbb\xbf$"), "line 1, column 1: no polynomial has '$'"));
  const std::string far = refused(std::string(1000, ' ') + "x + $ + " + std::string(1000, 'x'));
  EXPECT_TRUE(says(far, "column 1005: no polynomial has '$'")) << far;
  EXPECT_LT(far.size(), 400U);
}

} // namespace
