// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_DECISION_IDEAL_RESULT_H
#define CORRAL_DECISION_IDEAL_RESULT_H

#include <corral/decision/Cell_decision.h>
#include <corral/localization/Raster.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// \file
/// What the exact decision of a raster is asked for, and what it gives.
namespace corral {

/// What to do besides deciding cells.
struct Ideal_raster_options
{
  /// How long a stop waits for a step of algebra that is under way. Without a value it waits for its end. With one, all
  /// work is done in threads of its own; one that has not stopped by then is left to itself, and what it finds is
  /// dropped. It holds its own copy of everything and ends with its step; a process that exits does not wait for it.
  std::optional<std::chrono::milliseconds> patience{};
  /// Whether to say of each plotted cell who decided it.
  bool keep_rungs = false;
  /// Whether to decide every cell of the grid again without floats, those that the localisation called `empty` or `hit`
  /// included. The progress is then that of each pass. Costs in proportion to the cells near zeros.
  bool recheck = false;
};

/// \brief Two computations that both prove what they say contradict each other, so that one of them is wrong.
///
/// Nothing is repaired: no verdict of the run can be trusted. The message names the first cell and both verdicts.
struct Contradiction : std::logic_error
{
  Contradiction(const std::string& message, std::vector<std::uint32_t> where, Verdict first, Verdict second,
                std::uint64_t number)
      : std::logic_error(message), cell(std::move(where)), claimed(first), exact(second), cells(number)
  {}
  std::vector<std::uint32_t> cell; ///< the first one in the order of the index
  Verdict claimed;                 ///< what was said of it
  Verdict exact;                   ///< what exact arithmetic alone says
  std::uint64_t cells;             ///< how many contradict
};

/// Who decided a plotted cell, or why it is unknown.
template <std::size_t D>
struct Decided_cell
{
  Cell<D> cell{};
  Rung rung = Rung::floats;
  std::string reason{}; ///< empty for a hit
};

/// Which rung decided how many cells.
struct Rung_counts
{
  std::array<std::uint64_t, rung_count> hit{};
  std::array<std::uint64_t, rung_count> empty{};
};

/// \brief A raster with all that could be proved of it.
template <std::size_t D>
struct Ideal_raster
{
  Raster<D> raster;                               ///< cells that are hit, and unknown ones if any are left
  Rung_counts rungs{};                            ///< of the cells that were given as plotted
  std::map<std::string, std::uint64_t> reasons{}; ///< why cells are unknown, with their number
  std::vector<Decided_cell<D>> decided{};         ///< every plotted cell, sorted, if `keep_rungs` was given
  double rechecked = 0; ///< cells of the grid decided a second time, all without contradiction; exact up to 2^53
};

} // namespace corral

#endif
