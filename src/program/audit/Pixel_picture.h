// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_PROGRAM_AUDIT_PIXEL_PICTURE_H
#define CORRAL_SRC_PROGRAM_AUDIT_PIXEL_PICTURE_H

#include "../Input_file.h"
#include "Claim.h"

#include <corral/localization/Grid.h>

#include <functional>

namespace corral::program {

/// Whether the file begins as PNG files do.
[[nodiscard]] bool is_png(const Input_file& file);

/// \brief Calls `visit(cell)` for every plotted pixel.
/// \throw Invalid_input, Budget_exceeded as `read_raster`. Nothing is allocated for pixels before the size is checked.
void read_png(Input_file& file, const Resolution<2>& resolution, const Raster_options& options,
              const std::function<void(const Cell<2>&)>& visit);

} // namespace corral::program

#endif
