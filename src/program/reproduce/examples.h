// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_PROGRAM_REPRODUCE_EXAMPLES_H
#define CORRAL_SRC_PROGRAM_REPRODUCE_EXAMPLES_H

#include <cstddef>
#include <span>
#include <string_view>

namespace corral::program {

/// \brief An example of the paper.
///
/// The curves (1 to 10) lie in [0,1]^2 and are drawn on 256^2 pixels, the surfaces (11 to 20) in [-1,1]^3 on 32^3
/// voxels. \par Reference  Shou, Martin, Wang, Bowyer, Voiculescu, "A Recursive Taylor Method for Algebraic Curves and
///      Surfaces", 2005, section 5.
struct Example
{
  int number;
  std::size_t dimension;
  int figure;
  std::string_view name;
  std::string_view polynomial; ///< exact, in x, y, z

  [[nodiscard]] constexpr std::string_view box() const { return dimension == 2 ? "0:1,0:1" : "-1:1,-1:1,-1:1"; }
  [[nodiscard]] constexpr unsigned resolution() const { return dimension == 2 ? 256 : 32; }
};

/// All twenty, in order.
[[nodiscard]] std::span<const Example> examples();

} // namespace corral::program

#endif
