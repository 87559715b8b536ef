// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_DECISION_CELL_DECISION_H
#define CORRAL_DECISION_CELL_DECISION_H

#include <corral/decision/Witness.h>
#include <corral/localization/Grid.h>
#include <corral/localization/Verdict.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace corral {

/// The steps of the ladder, from cheap to dear. Each proves what it decides.
enum class Rung : std::uint8_t {
  floats,    ///< the localisation that supplied the cells
  intervals, ///< doubles with directed rounding on the cell itself
  mpfr,      ///< MPFR intervals
  integers,  ///< exact integers: signs at points and of Bernstein coefficients
  algebra    ///< real roots, resultants, algebraic numbers
};
inline constexpr std::size_t rung_count = 5;
inline constexpr std::array<std::string_view, rung_count> rung_names = {"floats", "intervals", "mpfr", "integers",
                                                                        "algebra"};

/// Which witnesses a decision makes. An exact algebraic point can cost more to write down than to find.
enum class Witnesses : std::uint8_t {
  simple, ///< all but algebraic points of the plane, for which the witness is left empty
  all
};

/// The verdict of one closed cell with the rung that decided it and, if that was an exact one, a witness.
template <std::size_t D>
struct Cell_decision
{
  Verdict verdict = Verdict::unknown;
  Rung rung = Rung::integers;
  Witness<D> witness{};
  std::string reason{}; ///< why the cell is unknown; empty if it is not
};

/// \brief Decides closed cells of one grid, one after another; every verdict is proved.
///
/// `decide(cell)` takes a cell of the grid and may throw `Cancelled`, after which it can be asked again.
// clang-format off
template <class T, std::size_t D>
concept CellDecider =
  std::movable<T> && requires(T decider, const Cell<D>& cell) {
    { decider.decide(cell) } -> std::same_as<Cell_decision<D>>;
  };
// clang-format on

} // namespace corral

#endif
