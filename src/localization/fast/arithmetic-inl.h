// SPDX-License-Identifier: LGPL-3.0-or-later
// Included once for each instruction set, by fast_engine.cpp.
#if defined(CORRAL_SRC_FAST_ARITHMETIC_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CORRAL_SRC_FAST_ARITHMETIC_INL_H
#undef CORRAL_SRC_FAST_ARITHMETIC_INL_H
#else
#define CORRAL_SRC_FAST_ARITHMETIC_INL_H
#endif

#include "octet-inl.h"
#include "rounds_nothing.h"

#include <cassert>

HWY_BEFORE_NAMESPACE();
namespace corral::fast::HWY_NAMESPACE {

inline constexpr unsigned all_lanes = (1U << batch) - 1;

/// \brief Sums and products of octets, some lanes of which are claimed to be exact.
///
/// Where assertions are on, the claim is checked of every operation; else this costs nothing.
class Arithmetic
{
public:
#ifdef NDEBUG
  /// \param lanes  a function that tells the lanes in which nothing may be rounded.
  template <class Lanes>
  HWY_INLINE explicit Arithmetic(const Lanes&)
  {}
#else
  template <class Lanes>
  explicit Arithmetic(const Lanes& lanes) : exact_(lanes())
  {}
#endif

  [[nodiscard]] HWY_INLINE Octet sum(const Octet& a, const Octet& b) const
  {
    const Octet result = a + b;
    check<is_exact_sum>(a, b, result);
    return result;
  }
  [[nodiscard]] HWY_INLINE Octet difference(const Octet& a, const Octet& b) const
  {
    const Octet result = a - b;
    check<is_exact_difference>(a, b, result);
    return result;
  }
  [[nodiscard]] HWY_INLINE Octet product(const Octet& a, const Octet& b) const
  {
    const Octet result = a * b;
    check<is_exact_product>(a, b, result);
    return result;
  }

private:
  static bool is_exact_difference(double a, double b, double difference) { return is_exact_sum(a, -b, difference); }

#ifdef NDEBUG
  template <bool (*is_exact)(double, double, double)>
  HWY_INLINE void check(const Octet&, const Octet&, const Octet&) const
  {}
#else
  template <bool (*is_exact)(double, double, double)>
  void check(const Octet& a, const Octet& b, const Octet& result) const
  {
    if (exact_ == 0) return;
    double lanes[3][batch];
    store(a, lanes[0]);
    store(b, lanes[1]);
    store(result, lanes[2]);
    for (std::size_t lane = 0; lane < batch; ++lane)
      assert((exact_ >> lane & 1) == 0 || is_exact(lanes[0][lane], lanes[1][lane], lanes[2][lane]));
  }

  unsigned exact_;
#endif
};

} // namespace corral::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
