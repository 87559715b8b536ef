// SPDX-License-Identifier: LGPL-3.0-or-later
// Included once for each instruction set, by fast_engine.cpp.
#if defined(CORRAL_SRC_FAST_LEAF_BLOCK_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CORRAL_SRC_FAST_LEAF_BLOCK_INL_H
#undef CORRAL_SRC_FAST_LEAF_BLOCK_INL_H
#else
#define CORRAL_SRC_FAST_LEAF_BLOCK_INL_H
#endif

#include "Fast_plan.h"
#include "taylor_shift-inl.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace corral::fast::HWY_NAMESPACE {

/// What a value at a corner must exceed, in absolute value, to prove something.
struct Thresholds
{
  double sign;     ///< if the computed value reaches it, f is not negative there
  double positive; ///< if all corners of a cell exceed it, f is positive on the cell
  double negative; ///< if all corners of a cell are below its negation, f is negative on the cell
};

/// What is known of the cells of a block.
struct Leaf_masks
{
  std::uint64_t empty = 0;
  std::uint64_t some_positive = 0; ///< f >= 0 somewhere in the cell
  std::uint64_t some_negative = 0; ///< f <= 0 somewhere in the cell
};

HWY_INLINE unsigned bits_of(Tag tag, hn::Mask<Tag> mask)
{
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(tag, mask, bits);
  return bits[0];
}

/// The four facts about corners, one bit a corner, in any layout `Bits` of corners.
template <class Bits>
struct Corner_signs
{
  Bits positive{}, negative{}, surely_positive{}, surely_negative{};

  /// Calls `add(bits of this set, bits of the chunk)` for each of the sets.
  template <class Add>
  HWY_INLINE void record(Tag tag, Vector value, const Thresholds& t, const Add& add)
  {
    add(positive, bits_of(tag, hn::Ge(value, hn::Set(tag, t.sign))));
    add(negative, bits_of(tag, hn::Le(value, hn::Set(tag, -t.sign))));
    add(surely_positive, bits_of(tag, hn::Gt(value, hn::Set(tag, t.positive))));
    add(surely_negative, bits_of(tag, hn::Lt(value, hn::Set(tag, -t.negative))));
  }
  template <class Add>
  void record_one(double value, const Thresholds& t, const Add& add)
  {
    add(positive, value >= t.sign ? 1U : 0U);
    add(negative, value <= -t.sign ? 1U : 0U);
    add(surely_positive, value > t.positive ? 1U : 0U);
    add(surely_negative, value < -t.negative ? 1U : 0U);
  }
};

/// The 9 x 9 corners of a block of 8 x 8 cells: 8 x 8 of them, the last of axis 0, of axis 1, and of both.
struct Corners_2
{
  std::uint64_t inner = 0;
  unsigned last_0 = 0;
  unsigned last_1 = 0;
  unsigned both = 0;

  /// One bit a cell: whether all (any) of its four corners are in the set.
  template <class Combine>
  [[nodiscard]] std::uint64_t cells(const Combine& combine) const
  {
    constexpr std::uint64_t low_seven = 0x7f7f7f7f7f7f7f7fU;
    // bit k of last_1 becomes the highest bit of byte k; seven bits a multiplication, so that no carry spoils it
    const std::uint64_t seven = (last_1 & 0x7fU) * std::uint64_t{0x0002040810204081U} & 0x0101010101010101U;
    const std::uint64_t spread = (seven | std::uint64_t{last_1 >> 7} << 56) << 7;
    const std::uint64_t along_1 = combine(inner, (inner >> 1 & low_seven) | spread);
    const std::uint64_t top = combine(std::uint64_t{last_0}, std::uint64_t{last_0 >> 1 | both << 7});
    return combine(along_1, along_1 >> 8 | top << 56);
  }
};

/// The 5 x 5 x 5 corners of a block of 4 x 4 x 4 cells: a plane of 25 for each corner of axis 0.
struct Corners_3
{
  std::uint32_t plane[5] = {};

  template <class Combine>
  [[nodiscard]] std::uint64_t cells(const Combine& combine) const
  {
    std::uint64_t result = 0;
    for (unsigned slab = 0; slab < 4; ++slab) {
      const std::uint32_t a = combine(plane[slab], plane[slab + 1]);
      const std::uint32_t b = combine(a, a >> 1);
      const std::uint32_t c = combine(b, b >> 5);
      const std::uint64_t rows = (c & 0xfU) | (c >> 1 & 0xf0U) | (c >> 2 & 0xf00U) | (c >> 3 & 0xf000U);
      result |= rows << (16 * slab);
    }
    return result;
  }
};

template <class Bits>
Leaf_masks decide_cells(const Corner_signs<Bits>& signs)
{
  const auto all = [](auto a, auto b) { return a & b; };
  const auto any = [](auto a, auto b) { return a | b; };
  return {signs.surely_positive.cells(all) | signs.surely_negative.cells(all), signs.positive.cells(any),
          signs.negative.cells(any)};
}

/// \brief Evaluates one lane of a batch of forms at the corners of its block.
template <std::size_t D>
class Leaf_block
{
public:
  Leaf_block(const Plan<D>& plan, const typename Monomial_shape<D>::Class& cut, const double* coefficients)
      : plan_(plan), lines_(cut.lines[D - 1]), slab_(cut.slab), c_(coefficients)
  {}

  /// \pre `powers` holds 8 doubles for each power of axis 0.
  [[nodiscard]] Leaf_masks decide(const Thresholds& thresholds, double* powers) const;

private:
  [[nodiscard]] Vector set(double value) const { return hn::Set(Tag(), value); }

  /// The value of one line at z, by Horner's rule.
  [[nodiscard]] HWY_INLINE Vector along(std::size_t line, Vector z) const
  {
    const auto& l = lines_.lines[line];
    const std::uint32_t* const index = lines_.index.data() + l.first;
    Vector value = set(c_[index[l.degree] * batch]);
    for (std::uint32_t k = l.degree; k-- > 0;) value = hn::Add(hn::Mul(value, z), set(c_[index[k] * batch]));
    return value;
  }
  [[nodiscard]] double along(std::size_t line, double z) const
  {
    const auto& l = lines_.lines[line];
    const std::uint32_t* const index = lines_.index.data() + l.first;
    double value = c_[index[l.degree] * batch];
    for (std::uint32_t k = l.degree; k-- > 0;) value = value * z + c_[index[k] * batch];
    return value;
  }
  [[nodiscard]] static HWY_INLINE Vector horner(const double* powers, std::size_t degree, Vector x)
  {
    Vector value = hn::Load(Tag(), powers + degree * batch);
    for (std::size_t i = degree; i-- > 0;) value = hn::Add(hn::Mul(value, x), hn::Load(Tag(), powers + i * batch));
    return value;
  }

  const Plan<D>& plan_;
  const typename Monomial_shape<D>::Lines& lines_;
  const std::vector<std::uint32_t>& slab_;
  const double* c_;
};

template <>
inline Leaf_masks Leaf_block<2>::decide(const Thresholds& t, double* powers) const
{
  const Tag tag;
  const std::size_t degree = slab_.size() - 2;
  const auto& x = plan_.lattice[0];
  const auto& y = plan_.lattice[1];
  Corner_signs<Corners_2> signs;
  for (std::size_t first = 0; first < batch; first += hn::Lanes(tag)) {
    const Vector ys = hn::LoadU(tag, y.data() + first);
    for (std::size_t i = 0; i <= degree; ++i) hn::Store(along(i, ys), tag, powers + i * batch);
    for (std::size_t row = 0; row < 8; ++row)
      signs.record(tag, horner(powers, degree, set(x[row])), t,
                   [&](Corners_2& to, std::uint64_t bits) { to.inner |= bits << (8 * row + first); });
    signs.record(tag, horner(powers, degree, set(x[8])), t,
                 [&](Corners_2& to, unsigned bits) { to.last_0 |= bits << first; });
  }
  for (std::size_t i = 0; i <= degree; ++i) hn::Store(set(along(i, y[8])), tag, powers + i * batch);
  for (std::size_t first = 0; first < batch; first += hn::Lanes(tag))
    signs.record(tag, horner(powers, degree, hn::LoadU(tag, x.data() + first)), t,
                 [&](Corners_2& to, unsigned bits) { to.last_1 |= bits << first; });
  signs.record_one(hn::GetLane(horner(powers, degree, set(x[8]))), t,
                   [](Corners_2& to, unsigned bits) { to.both = bits; });
  return decide_cells(signs);
}

template <>
inline Leaf_masks Leaf_block<3>::decide(const Thresholds& t, double* powers) const
{
  const Tag tag;
  const std::size_t degree = slab_.size() - 2;
  const auto& x = plan_.lattice[0];
  alignas(64) double ys[32];
  alignas(64) double zs[32];
  for (std::size_t corner = 0; corner < 32; ++corner) {
    ys[corner] = plan_.lattice[1][std::min<std::size_t>(corner / 5, 4)];
    zs[corner] = plan_.lattice[2][corner % 5];
  }
  Corner_signs<Corners_3> signs;
  for (std::size_t first = 0; first < 32; first += hn::Lanes(tag)) {
    const Vector y = hn::Load(tag, ys + first);
    const Vector z = hn::Load(tag, zs + first);
    for (std::size_t i = 0; i <= degree; ++i) {
      std::size_t line = slab_[i + 1] - 1;
      Vector value = along(line, z);
      while (line-- > slab_[i]) value = hn::Add(hn::Mul(value, y), along(line, z));
      hn::Store(value, tag, powers + i * batch);
    }
    for (std::size_t plane = 0; plane < 5; ++plane)
      signs.record(tag, horner(powers, degree, set(x[plane])), t,
                   [&](Corners_3& to, unsigned bits) { to.plane[plane] |= bits << first; });
  }
  return decide_cells(signs);
}

} // namespace corral::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
