// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_OUTPUT_OUTPUT_OPTIONS_H
#define CORRAL_OUTPUT_OUTPUT_OPTIONS_H

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace corral {

/// How pictures colour the plotted cells.
enum class Colouring : std::uint8_t {
  by_verdict, ///< `hit` dark, `unknown` orange and lighter, with a legend
  plotted     ///< all plotted cells alike, as in the paper's figures
};

/// What there is to say of each plotted cell: who decided it, or why nobody could.
struct Cell_notes
{
  struct Note
  {
    std::string rung;
    std::string reason; ///< of an unknown cell
    friend bool operator==(const Note&, const Note&) = default;
  };
  std::vector<Note> notes;             ///< the different ones
  std::vector<std::uint8_t> of_cell{}; ///< for each plotted cell, sorted, an index into `notes`; empty: no notes
  bool in_csv = false;                 ///< whether CSV has a column for the rung, too
};

/// What a writer may say or decide besides the cells. The defaults are always good.
struct Output_options
{
  /// A value of the run worth recording.
  using Fact = std::variant<std::string, std::uint64_t, double, bool, std::vector<std::string>>;

  /// The names of the axes. Where too few are given: x, y, z, then x4, x5 and so on.
  std::vector<std::string> variables;
  /// Recorded in this order by the writers that can hold them (JSON).
  std::vector<std::pair<std::string, Fact>> facts;
  /// JSON adds the rung and, for an unknown cell, the reason to each cell; CSV the rung as a last column, if so wanted.
  Cell_notes cell_notes{};
  /// The longer side of a picture in pixels (PNG) or points (SVG), 64 to 8192.
  unsigned size = 720;
  Colouring colouring = Colouring::by_verdict;
};

/// The name of one axis.
[[nodiscard]] std::string axis_name(const Output_options& options, std::size_t axis);

} // namespace corral

#endif
