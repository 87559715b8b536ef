// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_PROGRAM_LOCALIZE_ENGINE_H
#define CORRAL_SRC_PROGRAM_LOCALIZE_ENGINE_H

#include <corral/Run_options.h>
#include <corral/localization/Raster.h>
#include <corral/polynomial/Polynomial.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

/// \file
/// The library behind names known only at run time. The templates for each number type are compiled in a file of their
/// own, so that no command waits for all of them.
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

/// \throw Invalid_input for unknown names; what the localisation throws.
template <std::size_t D>
[[nodiscard]] Raster<D> localize_by_name(const std::vector<Polynomial<Rational, D>>& system, const Grid<D>& grid,
                                         const Localize_settings& settings);

} // namespace corral::program

#endif
