// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_PROGRAM_AUDIT_CELL_TABLE_H
#define CORRAL_SRC_PROGRAM_AUDIT_CELL_TABLE_H

#include "../Input_file.h"
#include "Claim.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace corral::program {

/// \brief Calls `visit(index, claim)` for every row of a table that does not say `empty`.
/// \throw Invalid_input, Budget_exceeded as `read_raster`.
void read_table(Input_file& file, std::span<const std::uint32_t> resolution, const Raster_options& options,
                const std::function<void(const std::vector<std::uint32_t>&, Claim)>& visit);

} // namespace corral::program

#endif
