// SPDX-License-Identifier: LGPL-3.0-or-later
// Included once for each instruction set, by fast_engine.cpp.
#if defined(CORRAL_SRC_FAST_NODE_POOL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CORRAL_SRC_FAST_NODE_POOL_INL_H
#undef CORRAL_SRC_FAST_NODE_POOL_INL_H
#else
#define CORRAL_SRC_FAST_NODE_POOL_INL_H
#endif

#include "octet-inl.h"

#include <hwy/aligned_allocator.h>

HWY_BEFORE_NAMESPACE();
namespace corral::fast::HWY_NAMESPACE {

/// \brief Nodes of one level and class, one lane each, in rows as `Row` tells. A norm is an upper bound of the sum of
/// absolute coefficients.
template <std::size_t D>
struct Pool
{
  enum Row : std::size_t { remainder, norm, corner, coefficients = corner + D };
  static constexpr std::size_t stride = batch * ((std::size_t{1} << D) + 2);
  hwy::AlignedFreeUniquePtr<double[]> rows;
  std::size_t count = 0;

  [[nodiscard]] double* row(std::size_t r) const { return rows.get() + r * stride; }
  void prepare(std::size_t coefficients)
  {
    if (!rows) rows = hwy::AllocateAligned<double>((Row::coefficients + coefficients) * stride);
  }
};

} // namespace corral::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
