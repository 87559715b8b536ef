// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_PROGRAM_LOCALIZE_RUN_FACTS_H
#define CORRAL_SRC_PROGRAM_LOCALIZE_RUN_FACTS_H

#include "Localize_settings.h"

#include <corral/decision/Ideal_result.h>
#include <corral/output/Output_options.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

/// \file
/// What a summary and a table say of a run beside its cells.
namespace corral::program {

using Facts = std::vector<std::pair<std::string, Output_options::Fact>>;

/// What the summary says of a run.
[[nodiscard]] Facts facts(const std::vector<std::string>& polynomials, const Localize_settings& settings,
                          const Work_counters& work, bool is_guaranteed);

/// What the exact decision says of the cells that the engine plotted.
template <std::size_t D>
[[nodiscard]] Facts exact_facts(const Ideal_raster<D>& ideal, bool recheck);

/// Times of the computation alone, of every run; at least one.
[[nodiscard]] Facts time_facts(std::vector<double> seconds);

/// Who decided each cell, and why it is unknown.
template <std::size_t D>
[[nodiscard]] Cell_notes notes(const std::vector<Decided_cell<D>>& decided);

} // namespace corral::program

#endif
