// SPDX-License-Identifier: LGPL-3.0-or-later
// Included once for each instruction set, by fast_engine.cpp.
#if defined(CORRAL_SRC_FAST_LEAF_BLOCK_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CORRAL_SRC_FAST_LEAF_BLOCK_INL_H
#undef CORRAL_SRC_FAST_LEAF_BLOCK_INL_H
#else
#define CORRAL_SRC_FAST_LEAF_BLOCK_INL_H
#endif

#include "Fast_plan.h"
#include "octet-inl.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace corral::fast::HWY_NAMESPACE {

inline constexpr double least_positive = std::numeric_limits<double>::denorm_min();

/// What a computed value must reach, in absolute value, to prove something.
struct Thresholds
{
  double sign;     ///< the sign of f at a corner
  double positive; ///< if all corners of a cell exceed it, f is positive on the cell
  double negative; ///< if all corners of a cell are below its negation, f is negative on the cell
  double probe;    ///< the sign of f at a point of the finer lattice in a cell
};

/// Verdicts on the cells of the blocks of a leaf: empty, hit, or neither.
template <std::size_t D>
struct Leaf_masks
{
  using Words = std::array<std::uint64_t, Plan<D>::leaf_blocks>;
  Words empty;
  Words hit;
};

/// \brief One lane of a batch of forms, evaluated at the corners of the cells of its leaf: 8 x 8 or 8 x 4 x 4 cells.
///
/// Lanes run along axis 0. The corners along the other axes are the *rows*: 9 of them in the plane, 25 in space; facts
/// about corners are collected in one word a lane with one bit a row.
template <std::size_t D>
class Leaf_block
{
public:
  using Masks = Leaf_masks<D>;
  using Words = typename Masks::Words;
  static constexpr std::size_t rows = D == 2 ? 9 : 25;
  static constexpr std::size_t padded_rows = Plan<D>::padded_rows;

  /// \param workspace  `padded_rows` doubles for each power of axis 0.
  Leaf_block(const Plan<D>& plan, const typename Monomial_shape<D>::Class& cut, const double* coefficients,
             const Thresholds& thresholds, double* workspace)
      : plan_(plan), lines_(cut.lines[D - 1]), slab_(cut.slab), c_(coefficients), t_(thresholds), powers_(workspace)
  {}

  /// The verdicts that the corners of the cells give.
  [[nodiscard]] Masks decide() const;

  /// Looks at a finer lattice in each cell of `unknown` and adds what it shows to `masks`.
  void probe(Words unknown, Masks& masks) const;

private:
  /// Whether f may have its extremes in a cell elsewhere than at the corners.
  [[nodiscard]] bool bent() const { return std::max(t_.positive, t_.negative) > std::max(t_.sign, least_positive); }

  /// Facts about corners; `last` is the word of the ninth corner along axis 0.
  struct Facts
  {
    Bits words;
    std::uint64_t last = 0;
  };
  struct Corner_facts
  {
    Facts not_negative, not_positive, positive, negative;
  };

  /// The coefficient of x_0^i as a function of the other coordinates, by Horner's rule, at `count` octets of points.
  template <std::size_t count>
  HWY_INLINE void power(std::size_t i, const Octet (&at)[D - 1][count], Octet (&value)[count]) const
  {
    std::size_t line = slab_[i + 1] - std::size_t{1};
    along(line, at[D - 2], value);
    if constexpr (D == 3)
      while (line-- > slab_[i]) {
        Octet next[count];
        along(line, at[1], next);
        for (std::size_t o = 0; o < count; ++o) value[o] = value[o] * at[0][o] + next[o];
      }
  }
  template <std::size_t count>
  HWY_INLINE void along(std::size_t line, const Octet (&x)[count], Octet (&value)[count]) const
  {
    const auto& l = lines_.lines[line];
    const std::uint32_t* const index = lines_.index.data() + l.first;
    const Octet top = set(c_[index[l.degree] * batch]);
    for (std::size_t o = 0; o < count; ++o) value[o] = top;
    for (std::uint32_t k = l.degree; k-- > 0;) {
      const Octet c = set(c_[index[k] * batch]);
      for (std::size_t o = 0; o < count; ++o) value[o] = value[o] * x[o] + c;
    }
  }
  template <bool bent, std::size_t degree>
  [[nodiscard]] HWY_INLINE Corner_facts look() const;
  template <bool bent, std::size_t degree>
  [[nodiscard]] Masks decide_as() const;
  template <bool bent>
  [[nodiscard]] Masks decide_by_degree() const;
  template <class Combine>
  [[nodiscard]] static HWY_INLINE Bits cells(const Facts& facts, const Combine& combine);
  [[nodiscard]] static HWY_INLINE Words mask(const Bits& cells);
  [[nodiscard]] unsigned probe_cells(const std::array<Octet, D>& centre, unsigned lanes, unsigned pieces,
                                     unsigned& hit) const;

  const Plan<D>& plan_;
  const typename Monomial_shape<D>::Lines& lines_;
  const std::vector<std::uint32_t>& slab_;
  const double* c_;
  const Thresholds& t_;
  double* powers_;
};

/// \tparam bent    whether the thresholds of a cell differ from that of a corner.
/// \tparam degree  that of axis 0, or 0 if it is only known at run time.
template <std::size_t D>
template <bool bent, std::size_t degree>
HWY_INLINE auto Leaf_block<D>::look() const -> Corner_facts
{
  const std::size_t top = degree == 0 ? slab_.size() - 2 : degree;
  constexpr std::size_t octets = padded_rows / batch;
  Octet at[D - 1][octets];
  for (std::size_t axis = 1; axis < D; ++axis)
    for (std::size_t o = 0; o < octets; ++o) at[axis - 1][o] = load(plan_.row_coordinate[axis - 1].data() + o * batch);
  for (std::size_t i = 0; i <= top; ++i) {
    Octet value[octets];
    power(i, at, value);
    for (std::size_t o = 0; o < octets; ++o) store(value[o], powers_ + i * padded_rows + o * batch);
  }
  const Octet x = load(plan_.lattice[0].data());
  const Octet plus[] = {set(t_.sign), set(t_.positive)};
  const Octet minus[] = {set(-t_.sign), set(-t_.negative)};
  Corner_facts facts{{no_bits()}, {no_bits()}, {no_bits()}, {no_bits()}};
  Bits bit = all_words(1);
  for (std::size_t row = 0; row < rows; ++row, bit = twice(bit)) {
    Octet value = set(powers_[top * padded_rows + row]);
    for (std::size_t i = top; i-- > 0;) value = value * x + set(powers_[i * padded_rows + row]);
    mark_at_most(facts.not_negative.words, plus[0], value, bit);
    mark_at_most(facts.not_positive.words, value, minus[0], bit);
    if constexpr (bent) {
      mark_at_most(facts.positive.words, plus[1], value, bit);
      mark_at_most(facts.negative.words, value, minus[1], bit);
    }
  }
  const Octet last = set(plan_.lattice[0][batch]);
  for (std::size_t first = 0; first < rows; first += batch) {
    Octet value = load(powers_ + top * padded_rows + first);
    for (std::size_t i = top; i-- > 0;) value = value * last + load(powers_ + i * padded_rows + first);
    facts.not_negative.last |= std::uint64_t{at_most(plus[0], value)} << first;
    facts.not_positive.last |= std::uint64_t{at_most(value, minus[0])} << first;
    if constexpr (bent) {
      facts.positive.last |= std::uint64_t{at_most(plus[1], value)} << first;
      facts.negative.last |= std::uint64_t{at_most(value, minus[1])} << first;
    }
  }
  return facts;
}

/// One bit a cell, in the word of its lane: whether all (any) of its corners have the fact.
template <std::size_t D>
template <class Combine>
HWY_INLINE Bits Leaf_block<D>::cells(const Facts& facts, const Combine& combine)
{
  Bits edges = combine(facts.words, shift_down<1>(facts.words));
  std::uint64_t last = combine(facts.last, std::uint64_t{facts.last >> 1});
  if constexpr (D == 3) {
    edges = combine(edges, shift_down<5>(edges));
    last = combine(last, std::uint64_t{last >> 5});
  }
  return combine(edges, next_lane(edges, last));
}

template <std::size_t D>
HWY_INLINE auto Leaf_block<D>::mask(const Bits& cells) -> Words
{
  if constexpr (D == 2) {
    return pack<std::uint8_t, 1>(keep(cells, 0xff));
  } else { // 4 x 4 bits of the 5 x 5 corners
    return pack<std::uint16_t, 2>(keep(cells, 0xf) | keep(shift_down<1>(cells), 0xf0)
                                  | keep(shift_down<2>(cells), 0xf00) | keep(shift_down<3>(cells), 0xf000));
  }
}

template <std::size_t D>
template <bool bent, std::size_t degree>
auto Leaf_block<D>::decide_as() const -> Masks
{
  const auto all = [](const auto& a, const auto& b) HWY_ATTR { return a & b; };
  const auto any = [](const auto& a, const auto& b) HWY_ATTR { return a | b; };
  const Corner_facts facts = look<bent, degree>();
  const Words hit = mask(cells(facts.not_negative, any) & cells(facts.not_positive, any));
  if constexpr (bent) return {mask(cells(facts.positive, all) | cells(facts.negative, all)), hit};
  if (t_.sign == 0) { // nothing is rounded: every corner has its sign, and f its extremes at corners
    Words empty = hit;
    for (auto& word : empty) word = ~word;
    return {empty, hit};
  }
  return {mask(cells(facts.not_negative, all) | cells(facts.not_positive, all)), hit};
}

template <std::size_t D>
template <bool bent>
auto Leaf_block<D>::decide_by_degree() const -> Masks
{
  switch (slab_.size() - 2) {
  case 1:
    return decide_as<bent, 1>();
  case 2:
    return decide_as<bent, 2>();
  case 3:
    return decide_as<bent, 3>();
  case 4:
    return decide_as<bent, 4>();
  default:
    return decide_as<bent, 0>();
  }
}

template <std::size_t D>
auto Leaf_block<D>::decide() const -> Masks
{
  return bent() ? decide_by_degree<true>() : decide_by_degree<false>();
}

/// Evaluates f at `pieces + 1` points a side of up to eight cells; returns the lanes proved empty, and those hit.
template <std::size_t D>
unsigned Leaf_block<D>::probe_cells(const std::array<Octet, D>& centre, unsigned lanes, unsigned pieces,
                                    unsigned& hit) const
{
  const std::size_t top = slab_.size() - 2;
  const auto coordinate = [&](std::size_t axis, unsigned k)
                              HWY_ATTR { return centre[axis] + set((2.0 * k / pieces - 1) / plan_.leaf_cells[axis]); };
  Octet low = set(std::numeric_limits<double>::infinity());
  Octet high = set(-std::numeric_limits<double>::infinity());
  for (unsigned row = 0, last = D == 2 ? pieces + 1 : (pieces + 1) * (pieces + 1); row < last; ++row) {
    Octet at[D - 1][1];
    at[D - 2][0] = coordinate(D - 1, row % (pieces + 1));
    if constexpr (D == 3) at[0][0] = coordinate(1, row / (pieces + 1));
    for (std::size_t i = 0; i <= top; ++i) {
      Octet value[1];
      power(i, at, value);
      store(value[0], powers_ + i * batch);
    }
    for (unsigned k = 0; k <= pieces; ++k) {
      const Octet x = coordinate(0, k);
      Octet value = load(powers_ + top * batch);
      for (std::size_t i = top; i-- > 0;) value = value * x + load(powers_ + i * batch);
      low = min(low, value);
      high = max(high, value);
    }
  }
  hit |= at_most(set(t_.probe), high) & at_most(low, set(-t_.probe)) & lanes;
  const double bend = 1.0 / (pieces * pieces); // a chord is so much nearer than that of the whole cell
  const double positive = t_.probe + (t_.positive - t_.sign) * bend;
  const double negative = t_.probe + (t_.negative - t_.sign) * bend;
  const double slack = 1 + 0x1p-40;
  return (below(set(positive * slack), low) | below(high, set(-negative * slack))) & lanes;
}

template <std::size_t D>
void Leaf_block<D>::probe(Words unknown, Masks& masks) const
{
  std::size_t block = 0;
  for (;;) {
    alignas(64) double coordinate[D][batch] = {};
    std::array<std::pair<std::size_t, std::uint64_t>, batch> cell_bit{};
    unsigned lanes = 0;
    for (std::size_t lane = 0; lane < batch; ++lane) {
      while (block < unknown.size() && unknown[block] == 0) ++block;
      if (block == unknown.size()) break;
      const auto bit = static_cast<unsigned>(std::countr_zero(unknown[block]));
      unknown[block] &= unknown[block] - 1;
      auto cell = cell_of<D>({}, bit);
      cell[0] += static_cast<std::uint32_t>(block) * block_side<D>;
      for (std::size_t axis = 0; axis < D; ++axis)
        coordinate[axis][lane] = (2.0 * cell[axis] + 1) / plan_.leaf_cells[axis] - 1;
      cell_bit[lane] = {block, std::uint64_t{1} << bit};
      lanes |= 1U << lane;
    }
    if (lanes == 0) return;
    std::array<Octet, D> centre;
    for (std::size_t axis = 0; axis < D; ++axis) centre[axis] = load(coordinate[axis]);
    unsigned hit = 0;
    unsigned empty = 0;
    for (unsigned pieces = 2; pieces <= Plan<D>::probe_pieces && (lanes & ~(hit | empty)) != 0; pieces *= 2)
      empty |= probe_cells(centre, lanes & ~(hit | empty), pieces, hit);
    for (std::size_t lane = 0; lane < batch; ++lane) {
      if ((empty >> lane & 1) != 0) masks.empty[cell_bit[lane].first] |= cell_bit[lane].second;
      if ((hit >> lane & 1) != 0) masks.hit[cell_bit[lane].first] |= cell_bit[lane].second;
    }
  }
}

} // namespace corral::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
