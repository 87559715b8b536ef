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
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace corral::fast::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The number of lanes that everything here works on, whatever the processor has.
inline constexpr std::size_t batch = 8;

using Tag = hn::CappedTag<double, batch>;
using Bit_tag = hn::RebindToUnsigned<Tag>;
inline constexpr std::size_t part_lanes = hn::MaxLanes(Tag());
inline constexpr std::size_t parts = batch / part_lanes;

/// Eight doubles in as many registers as it takes.
struct Octet
{
  hn::Vec<Tag> part[parts];
};

/// Eight words of 64 bits.
struct Bits
{
  hn::Vec<Bit_tag> part[parts];
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

template <class Function>
HWY_INLINE Bits each_word(const Function& function)
{
  Bits result;
  for (std::size_t p = 0; p < parts; ++p) result.part[p] = function(p);
  return result;
}
HWY_INLINE Bits no_bits()
{
  return each_word([&](std::size_t) HWY_ATTR { return hn::Zero(Bit_tag()); });
}
HWY_INLINE Bits operator&(const Bits& a, const Bits& b)
{
  return each_word([&](std::size_t p) HWY_ATTR { return hn::And(a.part[p], b.part[p]); });
}
HWY_INLINE Bits operator|(const Bits& a, const Bits& b)
{
  return each_word([&](std::size_t p) HWY_ATTR { return hn::Or(a.part[p], b.part[p]); });
}
template <int count>
HWY_INLINE Bits shift_down(const Bits& a)
{
  return each_word([&](std::size_t p) HWY_ATTR { return hn::ShiftRight<count>(a.part[p]); });
}
HWY_INLINE Bits twice(const Bits& a)
{
  return each_word([&](std::size_t p) HWY_ATTR { return hn::ShiftLeft<1>(a.part[p]); });
}
HWY_INLINE Bits all_words(std::uint64_t value)
{
  return each_word([&](std::size_t) HWY_ATTR { return hn::Set(Bit_tag(), value); });
}
HWY_INLINE Bits keep(const Bits& a, std::uint64_t mask)
{
  return each_word([&](std::size_t p) HWY_ATTR { return hn::And(a.part[p], hn::Set(Bit_tag(), mask)); });
}

/// Adds `bit` to the words of the lanes where a <= b.
HWY_INLINE void mark_at_most(Bits& words, const Octet& a, const Octet& b, const Bits& bit)
{
  for (std::size_t p = 0; p < parts; ++p) {
    const auto mask = hn::RebindMask(Bit_tag(), hn::Le(a.part[p], b.part[p]));
    words.part[p] = hn::Or(words.part[p], hn::IfThenElseZero(mask, bit.part[p]));
  }
}

/// The word of the next lane; that of the last lane is `last`.
HWY_INLINE Bits next_lane(const Bits& a, std::uint64_t last)
{
  std::int64_t order[part_lanes];
  for (std::size_t lane = 0; lane < part_lanes; ++lane)
    order[lane] = static_cast<std::int64_t>((lane + 1) % part_lanes);
  const std::int64_t zeros[part_lanes] = {};
  const auto rotate = hn::SetTableIndices(Bit_tag(), order);
  const auto broadcast = hn::SetTableIndices(Bit_tag(), zeros);
  const auto all_but_last = hn::FirstN(Bit_tag(), part_lanes - 1);
  return each_word([&](std::size_t p) HWY_ATTR {
    const auto following =
        p + 1 < parts ? hn::TableLookupLanes(a.part[p + 1 < parts ? p + 1 : p], broadcast) : hn::Set(Bit_tag(), last);
    return hn::IfThenElse(all_but_last, hn::TableLookupLanes(a.part[p], rotate), following);
  });
}

/// The lowest bits of all lanes side by side, in `words` words.
template <class Narrow, std::size_t words>
HWY_INLINE std::array<std::uint64_t, words> pack(const Bits& a)
{
  static_assert(sizeof(Narrow) * batch == sizeof(std::uint64_t) * words);
  Narrow narrow[batch];
  for (std::size_t p = 0; p < parts; ++p) {
    const hn::Rebind<Narrow, Bit_tag> tag;
    hn::StoreU(hn::TruncateTo(tag, a.part[p]), tag, narrow + p * part_lanes);
  }
  std::array<std::uint64_t, words> result;
  std::memcpy(result.data(), narrow, sizeof narrow);
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
