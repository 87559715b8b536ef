// SPDX-License-Identifier: LGPL-3.0-or-later
#include "gallery.h"

#include "../arguments.h"
#include "../audit/html.h"
#include "../localize/engine.h"
#include "examples.h"

#include <corral/number/all.h>
#include <corral/output/all.h>

#include <iterator>
#include <span>

namespace corral::program {

namespace fs = std::filesystem;

namespace {

// One picture: what is drawn, how, and what the paper counted.
struct Figure
{
  std::string name;  // of the files
  std::string title; // "Figure 3. Example 1"
  std::vector<std::string> polynomials;
  std::string box;
  std::string resolution;
  std::string method; // as the paper calls it
  Localize_settings settings;
  int paper_count = 0; // 0: not in the paper
  std::string remark;
};

struct Paper_figure
{
  int example;
  const char* bounder;
  bool plus;
  int count;
};

// Figures 3 to 24, in order, with the numbers of their captions.
constexpr Paper_figure paper_figures[] = {
    {1, "rt", true, 522},   {2, "rt", true, 432},   {3, "rt", true, 601},   {4, "rt", true, 774},
    {5, "rt", true, 456},   {6, "rt", true, 456},   {7, "rt", true, 460},   {8, "rt", true, 808},
    {9, "rt", true, 1088},  {10, "rt", true, 772},  {4, "maa", false, 816}, {4, "rt", false, 801},
    {11, "rt", true, 1791}, {12, "rt", true, 3952}, {13, "rt", true, 3712}, {14, "rt", true, 3176},
    {15, "rt", true, 1904}, {16, "rt", true, 2148}, {17, "rt", true, 4896}, {18, "rt", true, 7236},
    {19, "rt", true, 1572}, {20, "rt", true, 3288}};

Figure paper_figure(int figure, const Paper_figure& what, const std::string& number)
{
  const Example& example = examples()[static_cast<std::size_t>(what.example - 1)];
  Figure result;
  result.name = "figure-" + std::string(figure < 10 ? "0" : "") + std::to_string(figure);
  result.title = "Figure " + std::to_string(figure) + ". Example " + std::to_string(what.example);
  if (example.dimension == 3) result.title += ": " + std::string(example.name);
  result.polynomials = {std::string(example.polynomial)};
  result.box = example.box();
  result.resolution = std::to_string(example.resolution());
  result.method = std::string(what.bounder == std::string_view("rt") ? "RT" : "MAA") + (what.plus ? "++" : "");
  result.settings.engine = "paper";
  result.settings.method.bounder = what.bounder;
  result.settings.method.number = number;
  result.settings.sample = result.settings.refine = what.plus;
  result.paper_count = what.count;
  return result;
}

Figure space_curve(const std::string& name, const std::string& title, std::vector<std::string> polynomials,
                   const std::string& half_side, const std::string& resolution)
{
  Figure result;
  result.name = name + '-' + resolution;
  result.title = title;
  result.polynomials = std::move(polynomials);
  const std::string side = '-' + half_side + ':' + half_side;
  result.box = side + ',' + side + ',' + side;
  result.resolution = resolution;
  result.method = "fast engine";
  result.settings.engine = "fast";
  return result;
}

std::vector<Figure> all_figures(const std::string& number)
{
  std::vector<Figure> figures;
  int figure = 3;
  for (const Paper_figure& what : paper_figures) figures.push_back(paper_figure(figure++, what, number));
  for (const char* const resolution : {"64", "256"}) {
    figures.push_back(space_curve("viviani", "Viviani's curve: a sphere and a cylinder",
                                  {"x^2 + y^2 + z^2 - 4", "(x - 1)^2 + y^2 - 1"}, "2", resolution));
    figures.push_back(space_curve("torus-plane", "A torus and a plane tangent to it at the inner equator",
                                  {"(x^2 + y^2 + z^2 + 3/4)^2 - 4*(x^2 + y^2)", "x - 1/2"}, "3/2", resolution));
    figures.push_back(space_curve("tangent-spheres", "Two spheres that touch in one point",
                                  {"(x - 1)^2 + y^2 + z^2 - 1", "(x + 1)^2 + y^2 + z^2 - 1"}, "2", resolution));
  }
  return figures;
}

struct Counts
{
  std::uint64_t plotted;
  std::uint64_t hit;
};

// Writes the picture and the data of a figure.
Counts draw(const fs::path& folder, const Figure& figure)
{
  const std::vector<Formula> polynomials(figure.polynomials.begin(), figure.polynomials.end());
  const Space space = read_space(figure.box, "", polynomials);
  Counts counts{};
  with_dimension(space, [&](auto dimension) {
    constexpr std::size_t D = dimension;
    if constexpr (D == 2 || D == 3) {
      Resolution<D> resolution;
      resolution.fill(read_resolution(figure.resolution, 1)[0]);
      const Grid<D> grid(box_of<D>(space), resolution);
      const auto found = localize_by_name<D>(polynomials_of<D>(space, polynomials), grid, figure.settings);
      Output_options options;
      options.variables = space.variables;
      // A picture of one verdict alone says nothing by its colour; the paper's figures are black.
      if (found.hit() == 0) options.colouring = Colouring::plotted;
      options.size = 800;
      write_file(folder / (figure.name + ".png"), found, options);
      write_file(folder / (figure.name + (D == 2 ? ".svg" : ".ply")), found, options);
      counts = {found.plotted(), found.hit()};
    }
  });
  return counts;
}

std::string cells_text(const Figure& figure, const Counts& counts)
{
  const bool is_curve = figure.box.find(',') == figure.box.rfind(',');
  std::string text = std::to_string(counts.plotted) + (is_curve ? " pixels" : " voxels");
  if (counts.hit != 0) text += ", " + std::to_string(counts.hit) + " of them proved to be hit";
  if (figure.paper_count != 0) text += "; the paper: " + std::to_string(figure.paper_count);
  return text;
}

std::string card(const Figure& figure, const Counts& counts)
{
  std::string equations;
  for (const auto& polynomial : figure.polynomials)
    equations += "<span class=\"equation\">" + polynomial_html(polynomial) + " = 0</span> ";
  const bool is_curve = figure.box.find(',') == figure.box.rfind(',');
  const std::string data = figure.name + (is_curve ? ".svg" : ".ply");
  return "<figure>\n<a href=\"" + figure.name + ".png\"><img src=\"" + figure.name + ".png\" alt=\"" + figure.title
         + "\" loading=\"lazy\"></a>\n<figcaption><b>" + figure.title + ".</b> " + equations + "<span class=\"facts\">"
         + figure.method + ", " + figure.resolution + "<sup>" + (is_curve ? "2" : "3")
         + "</sup>: " + cells_text(figure, counts) + ". <a href=\"" + data + "\">" + (is_curve ? "SVG" : "PLY")
         + "</a></span></figcaption>\n</figure>\n";
}

constexpr const char* page_head = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Corral: gallery</title>
<style>
body { font: 16px/1.45 Georgia, "DejaVu Serif", serif; color: #1a1a1a; background: #fff; max-width: 1240px;
       margin: 2.5rem auto; padding: 0 1.5rem; }
h1 { font-size: 2rem; margin: 0 0 .4rem; } h2 { font-size: 1.35rem; margin: 2.6rem 0 .3rem; }
p { max-width: 46rem; margin: .3rem 0 1rem; }
.figures { display: grid; grid-template-columns: repeat(auto-fill, minmax(340px, 1fr)); gap: 2rem 1.8rem; }
figure { margin: 0; } img { width: 100%; aspect-ratio: 1; object-fit: contain; }
figcaption { font-size: .9rem; padding: 0 .4rem; } .equation { display: block; margin: .15rem 0; }
.equation:not(:first-of-type) { margin-top: 0; } .facts { color: #555; } sup, sub { font-size: .72em; line-height: 0; }
a { color: #1b5e9e; } .key { display: inline-block; width: .8em; height: .8em; vertical-align: -.05em; }
</style>
</head>
<body>
<h1>Corral: the figures of the paper, recomputed</h1>
)";

constexpr const char* page_key = R"(In colour:
<span class="key" style="background:#000"></span> or <span class="key" style="background:#bfd4eb"></span> <i>hit</i>,
proved to hold one (a change of sign at its corners); <span class="key" style="background:#d55e00"></span>
<i>unknown</i>, neither proved. Where no cell is proved to be hit, all are drawn alike. The paper is H. Shou, R. Martin,
G. Wang, A. Bowyer, I. Voiculescu, &ldquo;A Recursive Taylor Method for Algebraic Curves and Surfaces&rdquo;, 2005.</p>
)";

std::string guarantee_text(const std::string& number)
{
  const bool is_guaranteed =
      Number_types::visit(number, []<class I>(std::type_identity<I>) { return Interval_traits<I>::is_guaranteed; });
  return is_guaranteed ? "<p>Every cell that is not drawn is proved to hold no point of the curve or surface, rounding "
                         "included (number type "
                             + number + "). "
                       : "<p>Computed with plain doubles rounded to nearest, as in the paper (number type " + number
                             + "): <b>not proved</b>. ";
}

struct Section
{
  std::size_t first; // index of its first figure
  const char* title;
  const char* text;
};

constexpr Section sections[] = {
    {0, "Curves",
     "Figures 3 to 12, which the paper drew by RT++: the recursive Taylor method of order 2 with point "
     "sampling and subpixels."},
    {10, "Example 4 again",
     "Figures 13 and 14, which the paper drew by MAA and RT without sampling; compare Figure 6."},
    {12, "Surfaces",
     "Figures 15 to 24. The paper's counts of Examples 12 and 14 to 19 do not follow from the method that it "
     "describes: "
     "its subvoxel test bounded the polynomial of Example 20 instead. Both counts are given."},
    {22, "Space curves",
     "Where two surfaces meet: a cell is kept while neither polynomial excludes it. The third is "
     "two spheres that touch in a single point, the origin, which eight voxels share: a speck in the finer picture."}};

std::string page(const std::vector<std::string>& cards, const std::string& number)
{
  std::string html = page_head + guarantee_text(number) + page_key;
  for (std::size_t k = 0; k < std::size(sections); ++k) {
    const std::size_t end = k + 1 < std::size(sections) ? sections[k + 1].first : cards.size();
    html +=
        std::string("<h2>") + sections[k].title + "</h2>\n<p>" + sections[k].text + "</p>\n<div class=\"figures\">\n";
    for (std::size_t card = sections[k].first; card < end; ++card) html += cards[card];
    html += "</div>\n";
  }
  return html + "</body>\n</html>\n";
}

} // namespace

void draw_gallery(const fs::path& folder, const std::string& number,
                  const std::function<bool(const std::string&)>& report)
{
  std::vector<std::string> cards;
  for (const Figure& figure : all_figures(number)) {
    const Counts counts = draw(folder, figure);
    cards.push_back(card(figure, counts));
    if (!report(figure.name + ".png  " + figure.title + ", " + figure.method + ": " + cells_text(figure, counts)))
      throw Cancelled("gallery");
  }
  write_whole_file(folder / "index.html", [&](std::ostream& out) { out << page(cards, number); });
}

} // namespace corral::program
