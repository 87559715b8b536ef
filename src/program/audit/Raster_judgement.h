// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_PROGRAM_AUDIT_RASTER_JUDGEMENT_H
#define CORRAL_SRC_PROGRAM_AUDIT_RASTER_JUDGEMENT_H

#include "Raster_file.h"

#include <corral/algebra/real_roots.h>
#include <corral/decision/Cell_decision.h>
#include <corral/localization/Raster.h>
#include <corral/polynomial/Polynomial.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace corral::program {

/// A raster of somebody else beside the ideal one. The lists are sorted by the index of the cell.
template <std::size_t D>
struct Raster_judgement
{
  std::vector<Cell<D>> lost;          ///< hit, but not plotted
  std::vector<Claimed_cell<D>> wrong; ///< plotted, but empty
  std::vector<Cell<D>> undecided;     ///< cells of which the truth is not known
  std::vector<Cell<D>> right;         ///< plotted and hit
  std::uint64_t wrong_hits = 0;       ///< how many of `wrong` are claimed to be proved hits
  [[nodiscard]] bool is_faultless() const { return lost.empty() && wrong.empty(); }
};

/// \par Complexity  n log n for n cells.
template <std::size_t D>
[[nodiscard]] Raster_judgement<D> judge(const Raster<D>& truth, const Foreign_raster<D>& raster);

/// Why a cell is hit or empty, so that it can be checked by hand.
template <std::size_t D>
struct Evidence
{
  Cell_decision<D> decision;
  /// Of an empty cell: a polynomial of the system whose bound does not contain zero, and that bound, if there is one.
  std::optional<std::size_t> bounded;
  Rational_interval bound{};
};

/// Finds the evidence for one cell after another.
template <std::size_t D>
class Evidence_finder
{
public:
  /// \param system  as for the exact decision. \param checkpoint  stops long decisions by throwing.
  Evidence_finder(const std::vector<Polynomial<Rational, D>>& system, const Grid<D>& grid,
                  const Checkpoint& checkpoint);
  ~Evidence_finder();
  Evidence_finder(const Evidence_finder&) = delete;
  Evidence_finder& operator=(const Evidence_finder&) = delete;

  /// Whether witnesses speak of the square-free part, which is another polynomial than the given one.
  [[nodiscard]] bool is_of_square_free_part() const;

  /// The polynomials of which witnesses speak: the system or, of a single polynomial, the square-free part.
  [[nodiscard]] const std::vector<Polynomial<Rational, D>>& subjects() const;

  /// \pre The cell lies in the grid.
  [[nodiscard]] Evidence<D> find(const Cell<D>& cell);

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace corral::program

#endif
