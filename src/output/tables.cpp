// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/output/tables.h>

#include "Coarse_view.h"

#include <nlohmann/json.hpp>

#include <charconv>
#include <string_view>

namespace corral {

std::string axis_name(const Output_options& options, std::size_t axis)
{
  if (axis < options.variables.size()) return options.variables[axis];
  static constexpr const char* usual[] = {"x", "y", "z"};
  return axis < 3 ? usual[axis] : 'x' + std::to_string(axis + 1);
}

namespace {

// Numbers of a cell into a buffer, several times faster than streaming each.
template <std::size_t D>
class Index_text
{
public:
  std::string_view operator()(const Cell<D>& cell)
  {
    char* end = buffer_;
    for (const std::uint32_t index : cell) {
      end = std::to_chars(end, buffer_ + sizeof buffer_, index).ptr;
      *end++ = ',';
    }
    return {buffer_, static_cast<std::size_t>(end - buffer_)};
  }

private:
  char buffer_[11 * D]; // ten digits and a comma each
};

template <std::size_t D>
nlohmann::ordered_json summary(const Raster<D>& raster, const Output_options& options)
{
  const Grid<D>& grid = raster.grid();
  nlohmann::ordered_json result;
  for (std::size_t axis = 0; axis < D; ++axis) {
    const auto& side = grid.box()[axis];
    result["variables"].push_back(axis_name(options, axis));
    result["box"].push_back({to_string(side.lower()), to_string(side.upper())});
  }
  result["resolution"] = grid.resolution();
  for (const auto& [name, fact] : options.facts)
    std::visit([&, &key = name](const auto& value) { result[key] = value; }, fact);
  result["plotted"] = raster.plotted();
  result["hit"] = raster.hit();
  result["unknown"] = raster.unknown();
  if (raster.was_stopped()) result["not_visited"] = raster.unvisited_cells();
  return result;
}

// The notes of the cells in the order of the writers; null where there are none.
class Note_reader
{
public:
  explicit Note_reader(const Output_options& options) : notes_(options.cell_notes) {}
  const Cell_notes::Note* next()
  {
    return at_ < notes_.of_cell.size() ? &notes_.notes.at(notes_.of_cell[at_++]) : nullptr;
  }

private:
  const Cell_notes& notes_;
  std::size_t at_ = 0;
};

// Names and polynomials come from outside and need not be UTF-8.
std::string dump(const nlohmann::ordered_json& value)
{
  return value.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

} // namespace

template <std::size_t D>
void write_csv(std::ostream& out, const Raster<D>& raster, const Output_options& options)
{
  static_assert(D <= 8, "one letter an axis");
  for (std::size_t axis = 0; axis < D; ++axis) out << static_cast<char>('i' + axis) << ',';
  const bool with_rungs = options.cell_notes.in_csv;
  Note_reader notes(options);
  out << (with_rungs ? "verdict,rung\n" : "verdict\n");
  Index_text<D> text;
  raster.for_each_sorted([&](const Cell<D>& cell, Verdict verdict) {
    out << text(cell) << to_string(verdict);
    if (const auto* note = notes.next(); note != nullptr && with_rungs) out << ',' << note->rung;
    out << '\n';
  });
}

template <std::size_t D>
void write_json(std::ostream& out, const Raster<D>& raster, const Output_options& options)
{
  std::string head = dump(summary(raster, options));
  head.pop_back(); // the closing brace: the cells are streamed, not held
  out << head << ",\"cells\":[";
  Index_text<D> text;
  const char* separator = "\n[";
  Note_reader notes(options);
  raster.for_each_sorted([&](const Cell<D>& cell, Verdict verdict) {
    out << separator << text(cell) << '"' << to_string(verdict) << '"';
    if (const auto* note = notes.next()) {
      out << ',' << dump(note->rung);
      if (!note->reason.empty()) out << ',' << dump(note->reason);
    }
    out << ']';
    separator = ",\n[";
  });
  out << "\n]}\n";
}

template <std::size_t D>
void write_summary(std::ostream& out, const Raster<D>& raster, const Output_options& options)
{
  out << dump(summary(raster, options)) << '\n';
}

template <std::size_t D>
void write_text(std::ostream& out, const Raster<D>& raster, const Output_options& options)
{
  Resolution<D> limit;
  limit.fill(D <= 2 ? 128 : 32);
  const Raster<D> view = coarsen(raster, limit);
  const Resolution<D>& resolution = view.grid().resolution();
  const std::uint32_t height = D == 1 ? 1 : resolution[1 % D];
  std::uint32_t slices = 1;
  for (std::size_t axis = 2; axis < D; ++axis) slices *= resolution[axis];
  for (std::uint32_t slice = 0; slice < slices; ++slice) {
    Cell<D> cell{};
    std::uint32_t rest = slice;
    for (std::size_t axis = D; axis-- > 2; rest /= resolution[axis]) cell[axis] = rest % resolution[axis];
    for (std::size_t axis = 2; axis < D; ++axis)
      out << "slice " << axis_name(options, axis) << ' ' << cell[axis] << (axis + 1 < D ? ", " : "\n");
    for (std::uint32_t row = height; row-- > 0; out << '\n') {
      if (D > 1) cell[1 % D] = row;
      for (cell[0] = 0; cell[0] < resolution[0]; ++cell[0]) out << ".?#"[static_cast<std::size_t>(view.verdict(cell))];
    }
  }
}

#define CORRAL_INSTANTIATE(D)                                                                                          \
  template void write_csv<D>(std::ostream&, const Raster<D>&, const Output_options&);                                  \
  template void write_json<D>(std::ostream&, const Raster<D>&, const Output_options&);                                 \
  template void write_summary<D>(std::ostream&, const Raster<D>&, const Output_options&);                              \
  template void write_text<D>(std::ostream&, const Raster<D>&, const Output_options&);
CORRAL_INSTANTIATE(1)
CORRAL_INSTANTIATE(2)
CORRAL_INSTANTIATE(3)
CORRAL_INSTANTIATE(4)

} // namespace corral
