// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_LOCALIZATION_FAST_EXACT_LIMITS_H
#define CORRAL_SRC_LOCALIZATION_FAST_EXACT_LIMITS_H

#include <vector>

namespace corral::fast {

/// Coordinates of the corners of cells in a leaf block are multiples of two to the minus this, and those of probes.
inline constexpr unsigned corner_bits = 2;
inline constexpr unsigned probe_bits = 4;

/// \brief The largest norm at which operations round nothing, if what they give is a multiple of quantum 2^-bits and at
/// most the norm; 0, the norm of the zero form, if there is none.
///
/// The proof is in doc/taylor_form.md, "What is exact". \pre `quantum` is a power of two or 0.
[[nodiscard]] double exact_limit(double quantum, unsigned bits);

/// \brief Up to which norm the forms of one run are split and evaluated exactly.
///
/// It follows from the seeds of the run and nothing else: what is exact is a matter of the coefficients.
class Exact_limits
{
public:
  /// \param degree      of the forms, at least.
  /// \param level       of the seeds. \param leaf_level  where forms are evaluated.
  /// \param quantum     of all coefficients of all seeds, 0 if none is known.
  void reset(unsigned degree, unsigned level, unsigned leaf_level, double quantum);

  /// Of the forms that are split into this level, which is below that of the seeds.
  [[nodiscard]] double split(unsigned level) const { return limit_[level]; }
  /// Of the leaf forms that are evaluated at corners of cells.
  [[nodiscard]] double corner() const { return corner_; }
  /// Of the leaf forms that are evaluated at the points of the finest lattice in a cell.
  [[nodiscard]] double probe() const { return probe_; }

  /// A quantum of the forms of this level; 0 if none is known.
  [[nodiscard]] double quantum(unsigned level) const;

private:
  unsigned degree_ = 0;
  unsigned level_ = 0;
  double quantum_ = 0;
  std::vector<double> limit_; // by level
  double corner_ = 0;
  double probe_ = 0;
};

} // namespace corral::fast

#endif
