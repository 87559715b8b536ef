// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_PROGRAM_AUDIT_TIGHTNESS_PLOT_H
#define CORRAL_SRC_PROGRAM_AUDIT_TIGHTNESS_PLOT_H

#include "Method_audit.h"

#include <string>
#include <vector>

/// \file
/// Plots of the tightness of bounders, as SVG to be put into a page.
namespace corral::program {

/// What tightness is plotted against.
enum class Plot_axis : std::uint8_t { box_width, degree };

/// \brief One line for each audit: the median of width(bound) / width(range) - 1 over the samples of one width or
/// degree. Both scales are logarithmic but that of degrees. What is below a millionth is drawn there. \pre At most one
/// audit of each bounder and order is given.
[[nodiscard]] std::string tightness_plot(const std::vector<const Method_audit*>& audits, Plot_axis axis);

/// What line belongs to which bounder.
[[nodiscard]] std::string plot_legend(const std::vector<const Method_audit*>& audits);

} // namespace corral::program

#endif
