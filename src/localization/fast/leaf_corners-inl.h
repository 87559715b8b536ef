// SPDX-License-Identifier: LGPL-3.0-or-later
// Included once for each instruction set, by fast_engine.cpp.
#if defined(CORRAL_SRC_FAST_LEAF_CORNERS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CORRAL_SRC_FAST_LEAF_CORNERS_INL_H
#undef CORRAL_SRC_FAST_LEAF_CORNERS_INL_H
#else
#define CORRAL_SRC_FAST_LEAF_CORNERS_INL_H
#endif

#include "corner_facts-inl.h"
#include "leaf_form-inl.h"
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

/// \brief The verdicts that the values at the corners of the cells give, for eight leaves of 8 x 8 or 4 x 4 x 8 cells.
template <std::size_t D>
class Leaf_corners
{
public:
  Leaf_corners(const Plan<D>& plan, const Leaf_form<D>& form, const Thresholds& thresholds)
      : plan_(plan), form_(form), t_(thresholds)
  {}

  /// \param lanes  the leaves that need verdicts.
  void decide(unsigned lanes, Leaf_masks<D>* masks)
  {
    if ((t_.bent & lanes) != 0)
      decide_by_degree<true>(lanes, masks);
    else
      decide_by_degree<false>(lanes, masks);
  }

private:
  template <bool bent, std::size_t degree>
  void visit_corners();
  template <bool bent, std::size_t degree>
  HWY_INLINE void visit_row(std::size_t row);
  template <bool bent, std::size_t degree>
  void decide_as(unsigned lanes, Leaf_masks<D>* masks);
  template <bool bent>
  void decide_by_degree(unsigned lanes, Leaf_masks<D>* masks);

  const Plan<D>& plan_;
  const Leaf_form<D>& form_;
  const Thresholds& t_;
  Corner_facts<D> above_, below_;       // the corners at which f has a sign
  Corner_facts<D> positive_, negative_; // those that also say something about the cells around, in bent leaves
};

template <std::size_t D>
template <bool bent, std::size_t degree>
HWY_INLINE void Leaf_corners<D>::visit_row(std::size_t row)
{
  const Octet sign = load(t_.sign);
  const Octet minus_sign = set(0) - sign;
  const Octet positive = load(t_.positive);
  const Octet minus_negative = set(0) - load(t_.negative);
  const auto visit = [&](std::size_t k, const Octet& value) HWY_ATTR {
    above_.row(row)[k] = static_cast<std::uint8_t>(at_most(sign, value));
    below_.row(row)[k] = static_cast<std::uint8_t>(at_most(value, minus_sign));
    if constexpr (bent) {
      positive_.row(row)[k] = static_cast<std::uint8_t>(at_most(positive, value));
      negative_.row(row)[k] = static_cast<std::uint8_t>(at_most(value, minus_negative));
    }
  };
  if (plan_.leaf_cells[D - 1] == 8) return form_.template along_symmetric_row<degree>(visit);
  std::size_t k = 0; // a small grid
  form_.along_row(
      Corner_layout<D>::row_points, [&](std::size_t point) HWY_ATTR { return set(plan_.lattice[D - 1][point]); },
      [&](const Octet& value) HWY_ATTR { visit(k++, value); });
}

template <std::size_t D>
template <bool bent, std::size_t degree>
void Leaf_corners<D>::visit_corners()
{
  constexpr std::size_t side = Corner_layout<D>::side;
  for (std::size_t j = 0; j < side; ++j) {
    form_.fix_axis_before_last(set(plan_.lattice[D - 2][j]));
    if constexpr (D == 2) {
      visit_row<bent, degree>(j);
    } else {
      for (std::size_t i = 0; i < side; ++i) {
        form_.fix_first_axis(set(plan_.lattice[0][i]));
        visit_row<bent, degree>(i * side + j);
      }
    }
  }
}

/// \tparam bent  whether the thresholds of a cell differ from that of a corner in some leaf.
template <std::size_t D>
template <bool bent, std::size_t degree>
void Leaf_corners<D>::decide_as(unsigned lanes, Leaf_masks<D>* masks)
{
  visit_corners<bent, degree>();
  const auto hit = both(of_cells<Any>(above_), of_cells<Any>(below_));
  auto empty = bent ? either(of_cells<All>(positive_), of_cells<All>(negative_))
                    : either(of_cells<All>(above_), of_cells<All>(below_));
  // If nothing is rounded every corner has its sign, zero on both sides, and f has its extremes at corners.
  if constexpr (!bent) empty = chosen_or_not(below(set(0), load(t_.sign)), empty, hit);
  const Facts_by_leaf<D> hit_by_leaf(hit);
  const Facts_by_leaf<D> empty_by_leaf(empty);
  for (; lanes != 0; lanes &= lanes - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
    masks[lane] = {empty_by_leaf[lane], hit_by_leaf[lane]};
  }
}

template <std::size_t D>
template <bool bent>
void Leaf_corners<D>::decide_by_degree(unsigned lanes, Leaf_masks<D>* masks)
{
  switch (form_.degree()) {
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
