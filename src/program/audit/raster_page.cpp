// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Evidence_text.h"
#include "Raster_report.h"
#include "html.h"
#include "report_page.h"

#include <corral/polynomial/print.h>

#include <algorithm>

namespace corral::program {

namespace {

constexpr const char* right_colour = "#9a9a9a";
constexpr const char* lost_colour = "#c8102e";
constexpr const char* wrong_colour = "#e08a00";
constexpr const char* undecided_colour = "#3b6fb6";

const Cell<2>& cell_of(const Cell<2>& cell) { return cell; }
const Cell<2>& cell_of(const Claimed_cell<2>& claimed) { return claimed.cell; }

// Cells as vertical runs: one path for all of a kind. The outline shows a single cell however small it is.
template <class Cells>
std::string path(const Cells& cells, std::uint32_t height, const char* colour, bool outlined)
{
  if (cells.empty()) return {};
  std::string data;
  for (std::size_t k = 0; k < cells.size();) {
    const Cell<2> first = cell_of(cells[k]);
    std::uint32_t length = 1;
    while (++k < cells.size() && cell_of(cells[k]) == Cell<2>{first[0], first[1] + length}) ++length;
    data += 'M' + std::to_string(first[0]) + ' ' + std::to_string(height - first[1] - length) + "h1v"
            + std::to_string(length) + "h-1z";
  }
  const std::string outline =
      outlined ? std::string("\" stroke=\"") + colour + "\" stroke-width=\"3\" vector-effect=\"non-scaling-stroke" : "";
  return std::string("<path fill=\"") + colour + outline + "\" d=\"" + data + "\"/>\n";
}

std::string key(const char* colour, const std::string& what)
{
  return std::string("<span class=\"key\" style=\"background:") + colour + "\"></span> " + what + " &ensp; ";
}

std::string picture(const Raster_audit<2>& audit)
{
  constexpr std::size_t most_cells = 200'000;
  const auto& judgement = audit.judgement;
  if (judgement.right.size() + judgement.wrong.size() + judgement.lost.size() > most_cells)
    return "<p class=\"note\">There are too many cells to draw them here.</p>\n";
  const auto [width, height] = audit.grid.resolution();
  const auto& box = audit.grid.box();
  const Rational proportion = (box[1].upper() - box[1].lower()) / (box[0].upper() - box[0].lower());
  const double side = 760;
  std::string svg = "<svg width=\"" + std::to_string(side) + "\" height=\""
                    + std::to_string(side * std::clamp(proportion.get_d(), 0.25, 1.0)) + "\" viewBox=\"0 0 "
                    + std::to_string(width) + ' ' + std::to_string(height)
                    + "\" preserveAspectRatio=\"none\" style=\"border:1px solid #999\">\n";
  svg += path(judgement.right, height, right_colour, false) + path(judgement.undecided, height, undecided_colour, true)
         + path(judgement.wrong, height, wrong_colour, true) + path(judgement.lost, height, lost_colour, true);
  return svg + "</svg>\n<p>" + key(right_colour, "correct") + key(lost_colour, "lost") + key(wrong_colour, "false")
         + (judgement.undecided.empty() ? "" : key(undecided_colour, "not judged")) + "</p>\n";
}

template <std::size_t D>
class Tables
{
public:
  Tables(const Raster_audit<D>& audit, Evidence_finder<D>& evidence, std::size_t most)
      : audit_(audit), evidence_(evidence), most_(most)
  {
    if (evidence.is_of_square_free_part()) square_free_ = to_string(evidence.subjects()[0], audit.variables);
  }

  [[nodiscard]] const std::string& square_free() const { return square_free_; }

  template <class Cells>
  [[nodiscard]] std::string table(const char* title, const Cells& cells)
  {
    if (cells.empty()) return {};
    std::string html = std::string("<h2>") + title + "</h2>\n<table><tr><th>cell</th><th>what proves it</th></tr>\n";
    for (std::size_t k = 0; k < std::min(most_, cells.size()); ++k) html += row(cells[k]);
    html += "</table>\n";
    if (cells.size() > most_)
      html += "<p class=\"note\">... " + std::to_string(cells.size() - most_) + " more; the JSON report has all.</p>\n";
    return html;
  }

private:
  std::string row(const Cell<D>& cell, std::string_view claim = "")
  {
    std::string index;
    for (std::size_t axis = 0; axis < D; ++axis) index += (axis == 0 ? "" : ", ") + std::to_string(cell[axis]);
    return "<tr><td>" + index + "</td><td>" + std::string(claim)
           + escaped(evidence_text(evidence_.find(cell), evidence_.subjects(), audit_.variables,
                                   square_free_.empty() ? "f" : "g"))
           + "</td></tr>\n";
  }
  std::string row(const Claimed_cell<D>& claimed)
  {
    return row(claimed.cell, claimed.claim == Claim::hit ? "<span class=\"bad\">claimed to be hit</span>; " : "");
  }

  const Raster_audit<D>& audit_;
  Evidence_finder<D>& evidence_;
  std::size_t most_;
  std::string square_free_;
};

std::string count_row(const char* what, std::uint64_t count, const char* meaning)
{
  return std::string("<tr><td>") + what + "</td><td class=\"number\">" + std::to_string(count) + "</td><td>" + meaning
         + "</td></tr>\n";
}

} // namespace

template <std::size_t D>
void write_raster_html(std::ostream& out, const Raster_audit<D>& audit, Evidence_finder<D>& evidence,
                       const Raster_report_options& options)
{
  const auto& judgement = audit.judgement;
  Tables<D> tables(audit, evidence, options.list);
  std::string body = "<p>";
  for (const auto& polynomial : audit.polynomials) body += polynomial_html(polynomial) + " = 0<br>\n";
  for (std::size_t axis = 0; axis < D; ++axis)
    body += escaped(audit.variables[axis]) + " in [" + to_string(audit.grid.box()[axis].lower()) + ", "
            + to_string(audit.grid.box()[axis].upper()) + "], " + std::to_string(audit.grid.resolution()[axis])
            + " cells<br>\n";
  body += "Raster: <code>" + escaped(audit.file) + "</code></p>\n";
  body += judgement.is_faultless()
              ? "<p class=\"good\">No cell is lost and none is false.</p>\n"
              : "<p class=\"bad\">" + std::to_string(judgement.lost.size() + judgement.wrong.size())
                    + " cells are lost or false.</p>\n";
  body += "<table><tr><th>cells</th><th class=\"number\">number</th><th></th></tr>\n"
          + count_row("correct", judgement.right.size(), "plotted, and proved to be hit")
          + count_row("lost", judgement.lost.size(), "proved to be hit, but not plotted")
          + count_row("false", judgement.wrong.size(), "plotted, but proved to be empty")
          + count_row("&emsp;claimed hit", judgement.wrong_hits, "of the false ones")
          + count_row("not judged", judgement.undecided.size(), "the truth could not be decided") + "</table>\n";
  if constexpr (D == 2) body += picture(audit);
  if (!tables.square_free().empty())
    body += "<p>g, the square-free part of f: " + polynomial_html(tables.square_free()) + "</p>\n";
  body += tables.table("Lost cells", judgement.lost) + tables.table("False cells", judgement.wrong)
          + tables.table("Cells not judged", judgement.undecided);
  out << report_page("Audit of a raster", body);
}

template void write_raster_html(std::ostream&, const Raster_audit<1>&, Evidence_finder<1>&,
                                const Raster_report_options&);
template void write_raster_html(std::ostream&, const Raster_audit<2>&, Evidence_finder<2>&,
                                const Raster_report_options&);
template void write_raster_html(std::ostream&, const Raster_audit<3>&, Evidence_finder<3>&,
                                const Raster_report_options&);

} // namespace corral::program
