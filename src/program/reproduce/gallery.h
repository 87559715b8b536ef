// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_PROGRAM_REPRODUCE_GALLERY_H
#define CORRAL_SRC_PROGRAM_REPRODUCE_GALLERY_H

#include <filesystem>
#include <functional>
#include <string>

namespace corral::program {

/// \brief Draws Figures 3 to 24 of the paper and some space curves into a folder, with a page `index.html` that shows
/// them.
/// \pre The folder exists.
/// \param number  the number type of the figures.
/// \param report  called with a line of text after each picture; `false` stops the run.
/// \throw Output_error if the folder cannot be written; Cancelled.
void draw_gallery(const std::filesystem::path& folder, const std::string& number,
                  const std::function<bool(const std::string&)>& report);

} // namespace corral::program

#endif
