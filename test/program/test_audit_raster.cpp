// SPDX-License-Identifier: LGPL-3.0-or-later
#include "run_program.h"

#include <corral/polynomial/evaluate.h>
#include <corral/polynomial/parse.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <png.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

namespace {

using namespace corral;
using namespace corral::test;
using nlohmann::json;
using Words = std::vector<std::string>;
using Cells = std::set<std::pair<int, int>>;

// The elliptic curve 24.a1, whose egg is 0.03 wide and 0.17 high.
constexpr int resolution = 256;
const std::string egg_curve = "y^2 - x^3 + x^2 + 384*x + 2772";
const Words egg_grid{"--box", "-30:60,-300:300", "--resolution", "256"};

Words operator+(Words words, const Words& more)
{
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

Program_run run_in(const Temporary_folder& folder, const Words& words)
{
  Program_limits limits;
  limits.folder = folder.path();
  limits.memory = std::size_t{2} << 30;
  return run_program(words, limits);
}

void write(const std::filesystem::path& path, const std::string& text)
{
  std::ofstream(path, std::ios::binary) << text;
}

void write_table(const std::filesystem::path& path, const Cells& cells)
{
  std::ofstream out(path);
  for (const auto& [i, j] : cells) out << i << ',' << j << '\n';
}

Cells true_cells(const std::string& polynomial, const Words& grid)
{
  const Program_run run = run_program(Words{"localize", polynomial, "--exact", "--format", "json"} + grid);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  Cells cells;
  const json answer = json::parse(run.out);
  for (const auto& cell : answer["cells"]) cells.emplace(cell[0], cell[1]);
  return cells;
}

// The answer of the audit as JSON, with the exit code that it must have.
json audit(const std::string& polynomial, const Words& grid, const Cells& raster)
{
  const Temporary_folder folder;
  write_table(folder.path() / "cells.csv", raster);
  const Program_run run =
      run_in(folder, Words{"audit", "raster", polynomial, "--cells", "cells.csv", "--format", "json"} + grid);
  EXPECT_EQ(run.err, "");
  json answer = json::parse(run.out);
  EXPECT_EQ(run.exit_code, answer["is_faultless"] == true ? 0 : 1);
  return answer;
}

Cells cells_of(const json& list)
{
  Cells cells;
  for (const auto& entry : list) cells.emplace(entry["cell"][0], entry["cell"][1]);
  return cells;
}

Rational rational(const json& text) { return parse_rational(text.get<std::string>()); }

// Checks with nothing but exact evaluation what an entry claims of a polynomial in x and y.
void expect_evidence(const json& entry, const Polynomial<Rational, 2>& f, const Polynomial<Rational, 2>& g)
{
  const auto& box = entry["box"];
  if (entry.contains("bound")) {
    const std::array<Rational, 2> middle{Rational((rational(box[0][0]) + rational(box[0][1])) / 2),
                                         Rational((rational(box[1][0]) + rational(box[1][1])) / 2)};
    const Rational value = evaluate(f, middle);
    EXPECT_LE(rational(entry["bound"][0]), value) << entry;
    EXPECT_GE(rational(entry["bound"][1]), value) << entry;
    EXPECT_GT(sgn(rational(entry["bound"][0])) * sgn(rational(entry["bound"][1])), 0) << entry;
    return;
  }
  ASSERT_TRUE(entry.contains("points")) << entry;
  int product = 1;
  for (const auto& point : entry["points"]) {
    const std::array<Rational, 2> x{rational(point[0]), rational(point[1])};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      EXPECT_LE(rational(box[axis][0]), x[axis]);
      EXPECT_GE(rational(box[axis][1]), x[axis]);
    }
    product *= sgn(evaluate(g, x));
  }
  EXPECT_EQ(product, entry["points"].size() == 1 ? 0 : -1) << entry;
}

TEST(Audit_raster, accepts_the_truth)
{
  const json answer = audit(egg_curve, egg_grid, true_cells(egg_curve, egg_grid));
  EXPECT_EQ(answer["is_faultless"], true);
  EXPECT_EQ(answer["correct"], 404);
  EXPECT_EQ(answer["lost"], 0);
  EXPECT_EQ(answer["false"], 0);
}

TEST(Audit_raster, reports_exactly_the_cells_that_were_removed_and_added)
{
  // The second curve has a double component, so that witnesses speak of the square-free part.
  for (const std::string polynomial : {"y^2 - x^3 + x", "(x^2 + y^2 - 2)^2*(x - y)"}) {
    const Words grid{"--box", "-2:2,-2:2", "--resolution", "64"};
    const Cells truth = true_cells(polynomial, grid);
    Cells raster;
    Cells removed;
    Cells added;
    int number = 0;
    for (const auto& cell : truth) (++number % 7 == 0 ? removed : raster).insert(cell);
    for (int k = 0; k < 64; k += 3)
      if (const std::pair<int, int> cell{k, (k * k + 5) % 64}; !truth.contains(cell)) added.insert(cell);
    raster.insert(added.begin(), added.end());
    const json answer = audit(polynomial, grid, raster);
    EXPECT_FALSE(removed.empty());
    EXPECT_FALSE(added.empty());
    EXPECT_EQ(cells_of(answer["lost_cells"]), removed);
    EXPECT_EQ(cells_of(answer["false_cells"]), added);
    EXPECT_EQ(answer["correct"], truth.size() - removed.size());
    const auto f = parse_polynomial<2>(polynomial, {"x", "y"});
    const auto g = parse_polynomial<2>(answer.value("square_free_part", polynomial), {"x", "y"});
    EXPECT_EQ(answer.contains("square_free_part"), polynomial[0] == '(');
    for (const char* const list : {"lost_cells", "false_cells"})
      for (const auto& entry : answer[list]) expect_evidence(entry, f, g);
  }
}

// What a plotter finds that looks for changes of sign at the corners of each cell.
Cells sampled(const Polynomial<Rational, 2>& f)
{
  std::vector<std::vector<int>> signs(resolution + 1, std::vector<int>(resolution + 1));
  for (int i = 0; i <= resolution; ++i)
    for (int j = 0; j <= resolution; ++j)
      signs[std::size_t(i)][std::size_t(j)] =
          sgn(evaluate(f, {-30 + Rational(90 * i) / resolution, -300 + Rational(600 * j) / resolution}));
  Cells cells;
  for (std::size_t i = 0; i < resolution; ++i)
    for (std::size_t j = 0; j < resolution; ++j) {
      const auto [low, high] = std::minmax({signs[i][j], signs[i + 1][j], signs[i][j + 1], signs[i + 1][j + 1]});
      if (low <= 0 && high >= 0) cells.emplace(i, j);
    }
  return cells;
}

const Cells egg{{54, 127}, {54, 128}};

TEST(Audit_raster, finds_the_oval_that_a_sampler_loses)
{
  const json answer = audit(egg_curve, egg_grid, sampled(parse_polynomial<2>(egg_curve, {"x", "y"})));
  EXPECT_EQ(cells_of(answer["lost_cells"]), egg);
  EXPECT_EQ(answer["false"], 0);
}

void write_picture(const std::filesystem::path& path, const Cells& cells, png_byte ink, png_byte paper)
{
  std::vector<png_byte> pixels(std::size_t{resolution} * resolution, paper);
  for (const auto& [i, j] : cells) pixels[std::size_t(resolution - 1 - j) * resolution + std::size_t(i)] = ink;
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = image.height = resolution;
  image.format = PNG_FORMAT_GRAY;
  ASSERT_NE(png_image_write_to_file(&image, path.c_str(), 0, pixels.data(), 0, nullptr), 0);
}

TEST(Audit_raster, judges_pictures)
{
  const Temporary_folder folder;
  const Cells cells = sampled(parse_polynomial<2>(egg_curve, {"x", "y"}));
  write_picture(folder.path() / "dark.png", cells, 0, 255);
  write_picture(folder.path() / "light.png", cells, 200, 30);
  for (const Words& more : {Words{"--cells", "dark.png"}, Words{"--cells", "light.png", "--invert"}}) {
    const Program_run run = run_in(folder, Words{"audit", "raster", egg_curve, "--format", "json"} + egg_grid + more);
    EXPECT_EQ(run.exit_code, 1) << run.err;
    EXPECT_EQ(cells_of(json::parse(run.out)["lost_cells"]), egg);
    EXPECT_EQ(json::parse(run.out)["false"], 0);
  }
}

TEST(Audit_raster, tells_people_what_is_wrong)
{
  const Temporary_folder folder;
  write(folder.path() / "cells.csv", "i,j,verdict\n0,0,hit\n0,1,unknown\n1,1,empty\n4,4,hit\n4,4,hit\n");
  const Words words =
      Words{"audit", "raster", "x - y", "--box", "0:1,0:1", "--resolution", "8", "--cells", "cells.csv"};
  const Program_run run = run_in(folder, words + Words{"--list", "2"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.out.find("3 cells plotted, 1 row that repeats a cell"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("correct: 3 plotted cells are hit"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("... 17 more"), std::string::npos) << run.out; // 22 cells are hit or touched at a corner
  write(folder.path() / "cells.csv", "i,j,verdict\n0,7,hit\n7,0,unknown\n");
  const std::string text = run_in(folder, words).out;
  EXPECT_NE(text.find("false: 2 plotted cells are empty, 1 of them claimed to be hit"), std::string::npos) << text;
  EXPECT_NE(text.find("  (0, 7)  claimed hit; f in [-1, -0.75] there"), std::string::npos) << text;
  EXPECT_NE(text.find("  (7, 0)  claimed unknown; f in [0.75, 1] there"), std::string::npos) << text;
}

TEST(Audit_raster, judges_other_dimensions_and_systems)
{
  const auto faultless = [](const Words& polynomials, const std::string& box, const std::string& cells) {
    const Temporary_folder folder;
    const Words problem = polynomials + Words{"--box", box, "--resolution", "8"};
    const Program_run truth = run_in(folder, Words{"localize", "--exact", "--format", "csv"} + problem);
    EXPECT_EQ(truth.exit_code, 0) << truth.err;
    write(folder.path() / "true.csv", truth.out);
    write(folder.path() / "wrong.csv", cells);
    const Words command = Words{"audit", "raster"} + problem + Words{"--cells"};
    const Program_run good = run_in(folder, command + Words{"true.csv"});
    EXPECT_EQ(good.exit_code, 0) << good.out << good.err;
    const Program_run bad = run_in(folder, command + Words{"wrong.csv"});
    EXPECT_EQ(bad.exit_code, 1) << bad.out << bad.err;
    EXPECT_NE(bad.out.find("false: 1 plotted cell is empty"), std::string::npos) << bad.out;
    return bad.out;
  };
  faultless({"x^2 - 1/3"}, "-1:1", "4\n");
  faultless({"x^2 + y^2 + z^2 - 1"}, "-1:1,-1:1,-1:1", "4,4,4\n");
  const std::string text = faultless({"x^2 - 2*y^2", "x^2 + y^2 - 1/5"}, "-1:1,-1:1", "0,0\n");
  EXPECT_NE(text.find("an algebraic zero with x in ["), std::string::npos) << text;
  faultless({"x^2 + y^2 + z^2 - 1", "x - y"}, "-1:1,-1:1,-1:1", "0,7,0\n");
}

TEST(Audit_raster, writes_reports_whole)
{
  const Temporary_folder folder;
  write(folder.path() / "<cells>.csv", "0,7\n");
  const Words words{"audit",   "raster",      "x - y",    "--box",  "0:1,0:1",  "--resolution", "8",
                    "--cells", "<cells>.csv", "--output", "a.json", "--output", "a.html"};
  EXPECT_EQ(run_in(folder, words).exit_code, 1);
  EXPECT_EQ(json::parse(content(folder.path() / "a.json"))["lost"], 22);
  const std::string page = content(folder.path() / "a.html");
  EXPECT_NE(page.find("<svg"), std::string::npos);
  EXPECT_NE(page.find("&lt;cells&gt;.csv"), std::string::npos);
  for (const char* const outside : {"http", "src=", "url(", "<script"})
    EXPECT_EQ(page.find(outside), std::string::npos);
  EXPECT_EQ(folder.files(), (Words{"<cells>.csv", "a.html", "a.json"}));
}

TEST(Audit_raster, refuses_in_one_line)
{
  const Temporary_folder folder;
  write(folder.path() / "cells.csv", "0,0\n");
  write(folder.path() / "far.csv", "0,8\n");
  const Words good{"--box", "0:1,0:1", "--resolution", "8"};
  EXPECT_EQ(run_in(folder, Words{"localize", "x - y", "--output", "drawing.png"} + good).exit_code, 0);
  const auto refuse = [&](const Words& more, const std::string& hint, const Words& grid) {
    const Program_run run = run_in(folder, Words{"audit", "raster"} + grid + more);
    EXPECT_EQ(run.exit_code, 2) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(run.err.rfind("corral: ", 0), 0U) << run.err;
    EXPECT_NE(run.err.find(hint), std::string::npos) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  };
  refuse({"x - y", "--cells", "drawing.png"}, "a drawing with axes is not a raster", good);
  refuse({"x - y", "--cells", "far.csv"}, "line 1: given '8'", good);
  refuse({"x - y", "--cells", "."}, "Is a directory", good);
  refuse({"x - y", "--cells", "none.csv"}, "No such file", good);
  refuse({"x - y", "--cells", "cells.csv", "--output", "a.pdf"}, ".json .html", good);
  refuse({"x - y", "x + y", "x*y", "--cells", "cells.csv"}, "given 3 polynomials", good);
  refuse({"x - x", "--cells", "cells.csv"}, "zero", good);
  refuse({"x - y"}, "--cells", good);
  refuse({"x", "--cells", "cells.csv"}, "expected 1 to 3",
         {"--box", "0:1,0:1,0:1,0:1", "--resolution", "4", "--variables", "x,y,z,w"});
  EXPECT_EQ(run_in(folder, {"audit"}).exit_code, 2);
  EXPECT_EQ(run_in(folder, {"audit", "rasters"}).exit_code, 2);
  EXPECT_EQ(folder.files(), (Words{"cells.csv", "drawing.png", "far.csv"}));
}

TEST(Audit_raster, leaves_nothing_when_interrupted)
{
  const Temporary_folder folder;
  write(folder.path() / "cells.csv", "0,0\n");
  Program_limits limits;
  limits.folder = folder.path();
  limits.interrupt_after = std::chrono::milliseconds(700);
  const Program_run run = run_program({"audit", "raster", "(x - y)^2*(x + y - 1)^2", "--box", "0:1,0:1", "--resolution",
                                       "200000", "--cells", "cells.csv", "--output", "a.json"},
                                      limits);
  EXPECT_EQ(run.exit_code, 130) << run.err;
  EXPECT_EQ(folder.files(), Words{"cells.csv"});
}

} // namespace
