// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_LOCALIZATION_FAST_SUBDIVIDER_H
#define CORRAL_SRC_LOCALIZATION_FAST_SUBDIVIDER_H

#include "Fast_plan.h"
#include "Pulse.h"

#include <cstddef>
#include <memory>
#include <span>

namespace corral::fast {

/// \brief Subdivides the nodes of one plan, for one thread. From one run to the next it keeps nothing but memory.
template <std::size_t D>
class Subdivider
{
public:
  virtual ~Subdivider() = default;

  /// \brief Subdivides some nodes, all of level `level`, down to `stop_level`, or down to the leaves if that is 0, and
  /// adds what it finds to the harvest.
  /// \pre level == plan.root_level for the root seed alone; else level > plan.leaf_level, and at most eight seeds.
  /// \throw Budget_exceeded if the harvest has more plotted cells than `plan.cell_budget`; Cancelled.
  virtual void run(unsigned level, std::span<const Seed<D>> seeds, unsigned stop_level, Harvest<D>& harvest) = 0;
};

/// For the instruction set of the processor. \param pulse  asked now and then whether to go on.
/// \pre Plan and pulse outlive the result.
template <std::size_t D>
[[nodiscard]] std::unique_ptr<Subdivider<D>> make_subdivider(const Plan<D>& plan, Pulse& pulse);

} // namespace corral::fast

#endif
