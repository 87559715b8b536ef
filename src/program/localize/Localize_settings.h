// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_PROGRAM_LOCALIZE_LOCALIZE_SETTINGS_H
#define CORRAL_SRC_PROGRAM_LOCALIZE_LOCALIZE_SETTINGS_H

#include <corral/Run_options.h>

#include <cstdint>
#include <string>

namespace corral::program {

/// How a polynomial is bounded.
struct Method
{
  std::string bounder = "rt";
  unsigned order = 2;
  std::string number = "cgal_interval";
  long precision = 128;
};

inline constexpr std::uint64_t default_max_cells = 50'000'000;

/// How cells are found.
struct Localize_settings
{
  Method method;
  std::string engine = "fast";
  bool refine = false;
  bool sample = false;
  bool count = false; ///< additions and multiplications
  Run_options run{.cell_budget = default_max_cells};
};

} // namespace corral::program

#endif
