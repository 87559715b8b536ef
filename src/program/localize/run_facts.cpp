// SPDX-License-Identifier: LGPL-3.0-or-later
#include "run_facts.h"

#include <algorithm>
#include <cstdint>

namespace corral::program {

Facts facts(const std::vector<std::string>& polynomials, const Localize_settings& settings, const Work_counters& work,
            bool is_guaranteed)
{
  std::vector<std::pair<std::string, Output_options::Fact>> list{{"polynomials", polynomials},
                                                                 {"engine", settings.engine}};
  if (settings.engine == "paper") {
    list.insert(list.end(), {{"bounder", settings.method.bounder},
                             {"order", std::uint64_t{settings.method.order}},
                             {"number", settings.method.number},
                             {"sample", settings.sample},
                             {"refine", settings.refine}});
  }
  list.insert(list.end(), {{"guaranteed", is_guaranteed}, {"bounds", work.bounds}});
  if (settings.engine == "paper") list.emplace_back("subdivisions", work.subdivisions);
  if (settings.count && settings.engine == "paper")
    list.insert(list.end(), {{"additions", work.additions}, {"multiplications", work.multiplications}});
  return list;
}

template <std::size_t D>
Facts exact_facts(const Ideal_raster<D>& ideal, bool recheck)
{
  const auto& [raster, rungs, reasons, decided, rechecked] = ideal;
  Facts list{{"exact", true}};
  if (recheck) {
    if (rechecked < 0x1p63)
      list.emplace_back("rechecked", static_cast<std::uint64_t>(rechecked));
    else
      list.emplace_back("rechecked", rechecked);
  }
  for (std::size_t rung = 0; rung < rung_count; ++rung) {
    list.emplace_back("hit_by_" + std::string(rung_names[rung]), rungs.hit[rung]);
    if (rung > 0) list.emplace_back("empty_by_" + std::string(rung_names[rung]), rungs.empty[rung]);
  }
  std::vector<std::string> texts;
  for (const auto& [reason, count] : reasons) texts.push_back(std::to_string(count) + " cells: " + reason);
  if (!texts.empty()) list.emplace_back("unknown_because", texts);
  return list;
}

Facts time_facts(std::vector<double> seconds)
{
  std::sort(seconds.begin(), seconds.end());
  const std::size_t half = seconds.size() / 2;
  const double median = seconds.size() % 2 == 1 ? seconds[half] : (seconds[half - 1] + seconds[half]) / 2;
  Facts list{{"seconds", median}};
  if (seconds.size() > 1)
    list.insert(
        list.end(),
        {{"repeat", std::uint64_t{seconds.size()}}, {"seconds_min", seconds.front()}, {"seconds_median", median}});
  return list;
}

template <std::size_t D>
Cell_notes notes(const std::vector<Decided_cell<D>>& decided)
{
  constexpr std::size_t most = 256; // that a byte tells apart
  Cell_notes result;
  for (const auto& cell : decided) {
    Cell_notes::Note note{std::string(rung_names[static_cast<std::size_t>(cell.rung)]), cell.reason};
    auto found = std::find(result.notes.begin(), result.notes.end(), note);
    if (found == result.notes.end() && result.notes.size() < most) found = result.notes.insert(found, std::move(note));
    if (found == result.notes.end()) --found;
    result.of_cell.push_back(static_cast<std::uint8_t>(found - result.notes.begin()));
  }
  return result;
}

template Facts exact_facts(const Ideal_raster<1>&, bool);
template Facts exact_facts(const Ideal_raster<2>&, bool);
template Facts exact_facts(const Ideal_raster<3>&, bool);
template Facts exact_facts(const Ideal_raster<4>&, bool);
template Cell_notes notes(const std::vector<Decided_cell<1>>&);
template Cell_notes notes(const std::vector<Decided_cell<2>>&);
template Cell_notes notes(const std::vector<Decided_cell<3>>&);
template Cell_notes notes(const std::vector<Decided_cell<4>>&);

} // namespace corral::program
