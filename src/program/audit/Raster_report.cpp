// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Raster_report.h"

#include "Evidence_text.h"

#include <corral/polynomial/print.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <string_view>

namespace corral::program {

namespace {

using Json = nlohmann::ordered_json;

// Names and polynomials come from outside and need not be UTF-8.
std::string dump(const Json& object) { return object.dump(-1, ' ', false, Json::error_handler_t::replace); }

std::string counted(std::uint64_t count, const std::string& of_one, const std::string& of_many)
{
  return std::to_string(count) + ' ' + (count == 1 ? of_one : of_many);
}

template <std::size_t D>
std::string cell_text(const Cell<D>& cell)
{
  std::string text = "(";
  for (std::size_t axis = 0; axis < D; ++axis) text += (axis == 0 ? "" : ", ") + std::to_string(cell[axis]);
  return text + ")";
}

// The polynomial that witnesses speak of, if it is another one than the one given.
template <std::size_t D>
std::string square_free_text(const Raster_audit<D>& audit, const Evidence_finder<D>& evidence)
{
  return evidence.is_of_square_free_part() ? to_string(evidence.subjects()[0], audit.variables) : std::string();
}

/// Lists cells of one kind with their evidence, as many as wanted.
template <std::size_t D>
class Cell_list
{
public:
  Cell_list(std::ostream& out, const Raster_audit<D>& audit, Evidence_finder<D>& evidence, std::size_t most)
      : out_(out), audit_(audit), evidence_(evidence), most_(most), name_(evidence.is_of_square_free_part() ? "g" : "f")
  {}

  template <class Cells>
  void print(const Cells& cells)
  {
    for (std::size_t k = 0; k < std::min(most_, cells.size()); ++k) print(cells[k]);
    if (cells.size() > most_) out_ << "  ... " << cells.size() - most_ << " more\n";
  }

private:
  void print(const Cell<D>& cell, std::string_view claim = "")
  {
    out_ << "  " << cell_text<D>(cell) << "  " << claim
         << evidence_text(evidence_.find(cell), evidence_.subjects(), audit_.variables, name_) << '\n';
  }
  void print(const Claimed_cell<D>& claimed)
  {
    print(claimed.cell, claimed.claim == Claim::hit       ? "claimed hit; "
                        : claimed.claim == Claim::unknown ? "claimed unknown; "
                                                          : "");
  }

  std::ostream& out_;
  const Raster_audit<D>& audit_;
  Evidence_finder<D>& evidence_;
  std::size_t most_;
  std::string name_;
};

} // namespace

template <std::size_t D>
void write_raster_text(std::ostream& out, const Raster_audit<D>& audit, Evidence_finder<D>& evidence,
                       const Raster_report_options& options)
{
  const auto& judgement = audit.judgement;
  const auto plotted = judgement.right.size() + judgement.wrong.size();
  out << "raster: " << audit.file << ", " << counted(plotted, "cell", "cells") << " plotted";
  if (audit.repeated != 0) out << ", " << counted(audit.repeated, "row that repeats", "rows that repeat") << " a cell";
  out << '\n';
  if (const std::string g = square_free_text(audit, evidence); !g.empty())
    out << "g, the square-free part of f: " << g << '\n';
  out << "correct: " << counted(judgement.right.size(), "plotted cell is", "plotted cells are") << " hit\n";
  Cell_list<D> list(out, audit, evidence, options.list);
  out << "lost: " << counted(judgement.lost.size(), "cell that is hit is", "cells that are hit are")
      << " not plotted\n";
  list.print(judgement.lost);
  out << "false: " << counted(judgement.wrong.size(), "plotted cell is", "plotted cells are") << " empty";
  if (judgement.wrong_hits != 0) out << ", " << judgement.wrong_hits << " of them claimed to be hit";
  out << '\n';
  list.print(judgement.wrong);
  if (judgement.undecided.empty()) return;
  out << "not judged: " << counted(judgement.undecided.size(), "cell", "cells") << " of which the truth is unknown\n";
  list.print(judgement.undecided);
}

namespace {

template <std::size_t D>
Json summary(const Raster_audit<D>& audit, const Evidence_finder<D>& evidence)
{
  Json result{{"audit", "raster"}, {"polynomials", audit.polynomials}};
  if (audit.readings.size() == 1)
    result["polynomial"] = audit.readings[0];
  else
    result["polynomial"] = audit.readings;
  if (const std::string g = square_free_text(audit, evidence); !g.empty()) result["square_free_part"] = g;
  result["variables"] = audit.variables;
  for (const auto& side : audit.grid.box()) result["box"].push_back({to_string(side.lower()), to_string(side.upper())});
  result["resolution"] = audit.grid.resolution();
  const auto& judgement = audit.judgement;
  result["raster"] = audit.file;
  result["repeated_rows"] = audit.repeated;
  result["is_faultless"] = judgement.is_faultless();
  result["correct"] = judgement.right.size();
  result["lost"] = judgement.lost.size();
  result["false"] = judgement.wrong.size();
  result["false_claimed_hit"] = judgement.wrong_hits;
  result["not_judged"] = judgement.undecided.size();
  return result;
}

template <std::size_t D>
class Json_list
{
public:
  Json_list(std::ostream& out, const Raster_audit<D>& audit, Evidence_finder<D>& evidence)
      : out_(out), audit_(audit), evidence_(evidence)
  {}

  template <class Cells>
  void write(const char* name, const Cells& cells)
  {
    out_ << ",\n\"" << name << "\":[";
    const char* separator = "\n";
    for (const auto& cell : cells) {
      out_ << separator << dump(entry(cell));
      separator = ",\n";
    }
    out_ << ']';
  }

private:
  Json entry(const Cell<D>& cell)
  {
    Json result{{"cell", cell}};
    for (const auto& side : audit_.grid.cell_box(cell))
      result["box"].push_back({to_string(side.lower()), to_string(side.upper())});
    result.update(evidence_json(evidence_.find(cell), evidence_.subjects(), audit_.variables));
    return result;
  }
  Json entry(const Claimed_cell<D>& claimed)
  {
    Json result = entry(claimed.cell);
    result["claim"] = name_of(claimed.claim);
    return result;
  }

  std::ostream& out_;
  const Raster_audit<D>& audit_;
  Evidence_finder<D>& evidence_;
};

} // namespace

template <std::size_t D>
void write_raster_json(std::ostream& out, const Raster_audit<D>& audit, Evidence_finder<D>& evidence)
{
  std::string head = dump(summary(audit, evidence));
  head.pop_back(); // the closing brace: the cells are streamed, not held
  out << head;
  Json_list<D> list(out, audit, evidence);
  list.write("lost_cells", audit.judgement.lost);
  list.write("false_cells", audit.judgement.wrong);
  list.write("cells_not_judged", audit.judgement.undecided);
  out << "}\n";
}

#define CORRAL_INSTANTIATE(D)                                                                                          \
  template void write_raster_text(std::ostream&, const Raster_audit<D>&, Evidence_finder<D>&,                          \
                                  const Raster_report_options&);                                                       \
  template void write_raster_json(std::ostream&, const Raster_audit<D>&, Evidence_finder<D>&);
CORRAL_INSTANTIATE(1)
CORRAL_INSTANTIATE(2)
CORRAL_INSTANTIATE(3)

} // namespace corral::program
