// SPDX-License-Identifier: LGPL-3.0-or-later
// Included once for each instruction set, by fast_engine.cpp.
#if defined(CORRAL_SRC_FAST_OCTET_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CORRAL_SRC_FAST_OCTET_INL_H
#undef CORRAL_SRC_FAST_OCTET_INL_H
#else
#define CORRAL_SRC_FAST_OCTET_INL_H
#endif

#include <hwy/highway.h>

#include <array>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace corral::fast::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The number of lanes that everything here works on, whatever the processor has.
inline constexpr std::size_t batch = 8;

using Tag = hn::CappedTag<double, batch>;
inline constexpr std::size_t part_lanes = hn::MaxLanes(Tag());
inline constexpr std::size_t parts = batch / part_lanes;

/// Eight doubles in as many registers as it takes.
struct Octet
{
  Octet() {} // a generated one would not be compiled for the instruction set, and vectors of Arm have constructors
  hn::Vec<Tag> part[parts];
};

template <class Function>
HWY_INLINE Octet each(const Function& function)
{
  Octet result;
  for (std::size_t p = 0; p < parts; ++p) result.part[p] = function(p);
  return result;
}

HWY_INLINE Octet set(double value)
{
  return each([&](std::size_t) HWY_ATTR { return hn::Set(Tag(), value); });
}
HWY_INLINE Octet load(const double* from)
{
  return each([&](std::size_t p) HWY_ATTR { return hn::LoadU(Tag(), from + p * part_lanes); });
}
HWY_INLINE void store(const Octet& a, double* to)
{
  for (std::size_t p = 0; p < parts; ++p) hn::StoreU(a.part[p], Tag(), to + p * part_lanes);
}
HWY_INLINE Octet operator+(const Octet& a, const Octet& b)
{
  return each([&](std::size_t p) HWY_ATTR { return hn::Add(a.part[p], b.part[p]); });
}
HWY_INLINE Octet operator-(const Octet& a, const Octet& b)
{
  return each([&](std::size_t p) HWY_ATTR { return hn::Sub(a.part[p], b.part[p]); });
}
HWY_INLINE Octet operator*(const Octet& a, const Octet& b)
{
  return each([&](std::size_t p) HWY_ATTR { return hn::Mul(a.part[p], b.part[p]); });
}
HWY_INLINE Octet abs(const Octet& a)
{
  return each([&](std::size_t p) HWY_ATTR { return hn::Abs(a.part[p]); });
}
HWY_INLINE Octet max(const Octet& a, const Octet& b)
{
  return each([&](std::size_t p) HWY_ATTR { return hn::Max(a.part[p], b.part[p]); });
}
HWY_INLINE Octet min(const Octet& a, const Octet& b)
{
  return each([&](std::size_t p) HWY_ATTR { return hn::Min(a.part[p], b.part[p]); });
}

/// a where `sign` is not negative, -a where it is.
HWY_INLINE Octet with_sign_of(const Octet& a, const Octet& sign)
{
  return each([&](std::size_t p) HWY_ATTR { return hn::Xor(a.part[p], hn::And(sign.part[p], hn::SignBit(Tag()))); });
}

/// yes where a <= b, else no.
HWY_INLINE Octet if_at_most(const Octet& a, const Octet& b, const Octet& yes, const Octet& no)
{
  return each([&](std::size_t p)
                  HWY_ATTR { return hn::IfThenElse(hn::Le(a.part[p], b.part[p]), yes.part[p], no.part[p]); });
}

/// One bit a lane: whether a <= b.
HWY_INLINE unsigned at_most(const Octet& a, const Octet& b)
{
  unsigned result = 0;
  for (std::size_t p = 0; p < parts; ++p) {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(Tag(), hn::Le(a.part[p], b.part[p]), bits);
    result |= static_cast<unsigned>(bits[0]) << (p * part_lanes);
  }
  return result;
}
/// One bit a lane: whether a < b.
HWY_INLINE unsigned below(const Octet& a, const Octet& b)
{
  unsigned result = 0;
  for (std::size_t p = 0; p < parts; ++p) {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(Tag(), hn::Lt(a.part[p], b.part[p]), bits);
    result |= static_cast<unsigned>(bits[0]) << (p * part_lanes);
  }
  return result;
}

/// One bit a lane: whether a < b < c.
HWY_INLINE unsigned between(const Octet& a, const Octet& b, const Octet& c)
{
  unsigned result = 0;
  for (std::size_t p = 0; p < parts; ++p) {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(Tag(), hn::And(hn::Lt(a.part[p], b.part[p]), hn::Lt(b.part[p], c.part[p])), bits);
    result |= static_cast<unsigned>(bits[0]) << (p * part_lanes);
  }
  return result;
}

/// For each set of lanes, their numbers in order, then zeros.
inline constexpr auto lanes_of_set = [] {
  std::array<std::array<std::int64_t, batch>, 256> table{};
  for (unsigned lanes = 0; lanes < 256; ++lanes)
    for (unsigned lane = 0, count = 0; lane < batch; ++lane)
      if ((lanes >> lane & 1) != 0) table[lanes][count++] = lane;
  return table;
}();

} // namespace corral::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
