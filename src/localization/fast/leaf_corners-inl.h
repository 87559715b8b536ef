// SPDX-License-Identifier: LGPL-3.0-or-later
// Included once for each instruction set, by fast_engine.cpp.
#if defined(CORRAL_SRC_FAST_LEAF_CORNERS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CORRAL_SRC_FAST_LEAF_CORNERS_INL_H
#undef CORRAL_SRC_FAST_LEAF_CORNERS_INL_H
#else
#define CORRAL_SRC_FAST_LEAF_CORNERS_INL_H
#endif

#include "corner_facts-inl.h"
#include "leaf_thresholds-inl.h"

HWY_BEFORE_NAMESPACE();
namespace corral::fast::HWY_NAMESPACE {

/// Verdicts on the cells of the blocks of a leaf: empty, hit, or neither.
template <std::size_t D>
struct Leaf_masks
{
  Leaf_words<D> empty;
  Leaf_words<D> hit;
};

/// \brief The forms of a batch, evaluated one by one at the corners of the cells of their leaves: 8 x 8 or 4 x 4 x 8
/// cells each.
///
/// The corners of a *row* differ in the last coordinate only and lie in the lanes of one octet, but for the ninth.
template <std::size_t D>
class Leaf_corners
{
public:
  using Cut = typename Monomial_shape<D>::Class;

  /// \param coefficients  an octet each.
  /// \param workspace     `Plan<D>::padded_rows` doubles for each power of the last axis.
  Leaf_corners(const Plan<D>& plan, const Cut& cut, const double* coefficients, const Thresholds& thresholds,
               double* workspace)
      : plan_(plan), lines_(cut.lines[D - 2]), slab_(cut.slab), c_(coefficients), t_(thresholds), powers_(workspace)
  {}

  /// The verdicts that the corners of the cells give, for some lanes.
  void decide(unsigned lanes, Leaf_masks<D>* masks) const
  {
    if (const unsigned bent = lanes & t_.bent; bent != 0) by_degree<true>(bent, masks);
    if (const unsigned other = lanes & ~t_.bent; other != 0) by_degree<false>(other, masks);
  }

private:
  static constexpr std::size_t padded_rows = Plan<D>::padded_rows;

  [[nodiscard]] HWY_INLINE Octet line(const double* c, std::size_t number, const Octet& x) const;
  HWY_INLINE void powers(const double* c, std::size_t k) const;
  template <std::size_t degree, class Visitor>
  HWY_INLINE void visit_values(Visitor& visitor) const;
  template <bool bent, std::size_t degree>
  [[nodiscard]] HWY_INLINE Leaf_masks<D> decide_lane(std::size_t lane) const;
  template <bool bent, std::size_t degree>
  [[nodiscard]] HWY_NOINLINE Leaf_masks<D> decide_by_thresholds(std::size_t lane) const;
  template <bool bent, std::size_t degree>
  void decide_as(unsigned lanes, Leaf_masks<D>* masks) const;
  template <bool bent>
  void by_degree(unsigned lanes, Leaf_masks<D>* masks) const;

  const Plan<D>& plan_;
  const typename Monomial_shape<D>::Lines& lines_;
  const std::vector<std::uint32_t>& slab_;
  const double* c_;
  const Thresholds& t_;
  double* powers_;
};

/// One line of coefficients as a function of its axis, by Horner's rule.
template <std::size_t D>
HWY_INLINE Octet Leaf_corners<D>::line(const double* c, std::size_t number, const Octet& x) const
{
  const auto& l = lines_.lines[number];
  const std::uint32_t* const index = lines_.index.data() + l.first;
  Octet value = set(c[index[l.degree] * batch]);
  for (std::uint32_t e = l.degree; e-- > 0;) value = value * x + set(c[index[e] * batch]);
  return value;
}

/// The coefficient of the k-th power of the last coordinate in all rows.
template <std::size_t D>
HWY_INLINE void Leaf_corners<D>::powers(const double* c, std::size_t k) const
{
  double* const to = powers_ + k * padded_rows;
  if constexpr (D == 2) {
    for (std::size_t o = 0; o < padded_rows; o += batch)
      store(line(c, slab_[k], load(plan_.lattice[0].data() + o)), to + o);
  } else {
    constexpr std::size_t layers = padded_rows / batch;
    const Octet y = load(plan_.lattice[1].data());
    std::size_t number = slab_[k + 1] - std::size_t{1};
    Octet value[layers];
    const Octet top = line(c, number, y);
    for (auto& v : value) v = top;
    while (number-- > slab_[k]) {
      const Octet next = line(c, number, y);
      for (std::size_t x = 0; x < layers; ++x) value[x] = value[x] * set(plan_.lattice[0][x]) + next;
    }
    for (std::size_t x = 0; x < layers; ++x) store(value[x], to + x * batch);
  }
}

/// \brief Calls `visitor.row(layer, row, values)` for the first eight corners of each row, `visitor.end(layer, values)`
/// for the ninth of eight rows. \pre The powers are there. \tparam degree  that of the last axis, or 0 if it is only
/// known at run time.
template <std::size_t D>
template <std::size_t degree, class Visitor>
HWY_INLINE void Leaf_corners<D>::visit_values(Visitor& visitor) const
{
  const std::size_t top = degree == 0 ? slab_.size() - 2 : degree;
  const Octet x = load(plan_.lattice[D - 1].data());
  for (std::size_t layer = 0; layer < (D == 2 ? 1 : Corner_facts<D>::layers); ++layer)
    for (std::size_t row = 0; row <= block_side<D>; ++row) {
      const double* const p = powers_ + layer * batch + row;
      Octet value = set(p[top * padded_rows]);
      for (std::size_t k = top; k-- > 0;) value = value * x + set(p[k * padded_rows]);
      visitor.row(layer + row / batch, row % batch, value);
    }
  for (std::size_t layer = 0; layer < Corner_facts<D>::layers; ++layer) { // where the last coordinate is 1
    const double* const p = powers_ + layer * batch;
    Octet value = load(p + top * padded_rows);
    for (std::size_t k = top; k-- > 0;) value = value + load(p + k * padded_rows);
    visitor.end(layer, value);
  }
}

/// Where every corner has its sign: the signs, and the corners too near to zero for a bent form.
template <std::size_t D, bool bent>
struct Sign_visitor
{
  Octet positive, minus_negative;
  Octet least = set(std::numeric_limits<double>::infinity()); ///< of the absolute values
  Corner_facts<D> below_zero{}, near{};

  HWY_INLINE void row(std::size_t layer, std::size_t row, const Octet& value)
  {
    least = min(least, abs(value));
    below_zero.layer[layer] |= std::uint64_t{below(value, set(0))} << 8 * row;
    if constexpr (bent) near.layer[layer] |= std::uint64_t{between(minus_negative, value, positive)} << 8 * row;
  }
  HWY_INLINE void end(std::size_t layer, const Octet& value)
  {
    least = min(least, abs(value));
    below_zero.end[layer] = below(value, set(0));
    if constexpr (bent) near.end[layer] = between(minus_negative, value, positive);
  }
};

/// Where some corners may have no sign, or both: the corners whose values reach a threshold on either side.
template <std::size_t D>
struct Threshold_visitor
{
  Octet plus, minus;
  Corner_facts<D> above{}, below{};

  HWY_INLINE void row(std::size_t layer, std::size_t row, const Octet& value)
  {
    above.layer[layer] |= std::uint64_t{at_most(plus, value)} << 8 * row;
    below.layer[layer] |= std::uint64_t{at_most(value, minus)} << 8 * row;
  }
  HWY_INLINE void end(std::size_t layer, const Octet& value)
  {
    above.end[layer] = at_most(plus, value);
    below.end[layer] = at_most(value, minus);
  }
};

/// \tparam bent  whether the thresholds of a cell differ from that of a corner.
template <std::size_t D>
template <bool bent, std::size_t degree>
HWY_INLINE auto Leaf_corners<D>::decide_lane(std::size_t lane) const -> Leaf_masks<D>
{
  const std::size_t top = degree == 0 ? slab_.size() - 2 : degree;
  for (std::size_t k = 0; k <= top; ++k) powers(c_ + lane, k);
  if (!bent && t_.sign[lane] == 0) return decide_by_thresholds<bent, degree>(lane); // zeros are likely
  Sign_visitor<D, bent> signs{set(t_.positive[lane]), set(-t_.negative[lane])};
  visit_values<degree>(signs);
  if (below(signs.least, set(std::max(t_.sign[lane], least_positive))) != 0)
    return decide_by_thresholds<bent, degree>(lane);
  const auto next = next_along_rows(signs.below_zero);
  const auto hit = without(with_any(signs.below_zero, next), with_all(signs.below_zero, next));
  Cell_facts<D> plotted = hit;
  if constexpr (bent) plotted = either(plotted, with_any(signs.near));
  return {complement(in_blocks(plotted)), in_blocks(hit)};
}

/// The same where the value at a corner may be zero or lost in rounding errors.
template <std::size_t D>
template <bool bent, std::size_t degree>
auto Leaf_corners<D>::decide_by_thresholds(std::size_t lane) const -> Leaf_masks<D>
{
  Threshold_visitor<D> corner{set(t_.sign[lane]), set(-t_.sign[lane])};
  visit_values<degree>(corner);
  const auto hit = in_blocks(both(with_any(corner.above), with_any(corner.below)));
  if constexpr (bent) {
    Threshold_visitor<D> cell{set(t_.positive[lane]), set(-t_.negative[lane])};
    visit_values<degree>(cell);
    return {in_blocks(either(with_all(cell.above), with_all(cell.below))), hit};
  }
  // If nothing is rounded every corner has its sign, and f has its extremes at corners.
  if (t_.sign[lane] == 0) return {complement(hit), hit};
  return {in_blocks(either(with_all(corner.above), with_all(corner.below))), hit};
}

template <std::size_t D>
template <bool bent, std::size_t degree>
void Leaf_corners<D>::decide_as(unsigned lanes, Leaf_masks<D>* masks) const
{
  for (; lanes != 0; lanes &= lanes - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
    masks[lane] = decide_lane<bent, degree>(lane);
  }
}

template <std::size_t D>
template <bool bent>
void Leaf_corners<D>::by_degree(unsigned lanes, Leaf_masks<D>* masks) const
{
  switch (slab_.size() - 2) {
  case 1:
    return decide_as<bent, 1>(lanes, masks);
  case 2:
    return decide_as<bent, 2>(lanes, masks);
  case 3:
    return decide_as<bent, 3>(lanes, masks);
  case 4:
    return decide_as<bent, 4>(lanes, masks);
  default:
    return decide_as<bent, 0>(lanes, masks);
  }
}

} // namespace corral::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
