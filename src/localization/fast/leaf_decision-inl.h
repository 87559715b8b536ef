// SPDX-License-Identifier: LGPL-3.0-or-later
// Included once for each instruction set, by fast_engine.cpp.
#if defined(CORRAL_SRC_FAST_LEAF_DECISION_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CORRAL_SRC_FAST_LEAF_DECISION_INL_H
#undef CORRAL_SRC_FAST_LEAF_DECISION_INL_H
#else
#define CORRAL_SRC_FAST_LEAF_DECISION_INL_H
#endif

#include "leaf_corners-inl.h"
#include "leaf_probe-inl.h"

#include <hwy/aligned_allocator.h>

#include <bit>

HWY_BEFORE_NAMESPACE();
namespace corral::fast::HWY_NAMESPACE {

/// \brief Decides the cells of leaves and harvests those that are not empty.
template <std::size_t D>
class Leaf_decision
{
public:
  explicit Leaf_decision(const Plan<D>& plan) : plan_(plan), whole_leaves_(true)
  {
    workspace_ = hwy::AllocateAligned<double>(Leaf_probe<D>::workspace_size(plan.shape));
    for (std::size_t axis = 0; axis < D; ++axis) {
      const std::uint32_t side = block_side<D> * (axis + 1 == D ? std::uint32_t{Plan<D>::leaf_blocks} : 1U);
      whole_leaves_ = whole_leaves_ && plan.resolution[axis] % side == 0;
    }
  }

  /// \throw Budget_exceeded if the harvest has more plotted cells than `plan.cell_budget`.
  void decide(const Leaf_batch<D>& leaves, Block_list<D>& harvest);

private:
  static void take(const Leaf_batch<D>& leaves, const Leaf_masks<D>* masks, Block_list<D>& harvest);
  [[nodiscard]] std::uint64_t inside(const std::array<std::uint32_t, D>& corner) const;
  [[nodiscard]] Leaf_words<D> outside(const Leaf_batch<D>& leaves, std::size_t lane) const;

  const Plan<D>& plan_;
  hwy::AlignedFreeUniquePtr<double[]> workspace_;
  bool whole_leaves_; // the grid is made of whole leaves
};

template <std::size_t D>
void Leaf_decision<D>::decide(const Leaf_batch<D>& leaves, Block_list<D>& harvest)
{
  if (harvest.plotted() > plan_.cell_budget) throw_over_budget(plan_.cell_budget);
  const Octet norm = load(leaves.norm);
  const Thresholds thresholds =
      leaf_thresholds(plan_, leaves.exact, leaves.cut.size, leaves.coefficients, norm, load(leaves.remainder));
  const Arithmetic at_corners([&]() HWY_ATTR { return at_most(norm, set(leaves.exact.corner())); });
  std::array<Leaf_masks<D>, batch> masks;
  const Leaf_form<D> form(leaves.cut, leaves.coefficients, workspace_.get(), at_corners);
  Leaf_corners<D>(plan_, form, thresholds).decide(leaves.lanes, masks.data());
  Leaf_probe<D> probe(plan_, leaves, thresholds, masks.data(), workspace_.get());
  // Where rounding errors hide everything, no probe helps.
  const unsigned clear = at_most(load(thresholds.sign) * set(64), norm);
  for (unsigned rest = leaves.lanes; rest != 0; rest &= rest - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(rest));
    if (!whole_leaves_) {
      const Leaf_words<D> cells = outside(leaves, lane);
      for (std::size_t b = 0; b < Plan<D>::leaf_blocks; ++b) masks[lane].empty[b] |= cells[b];
    }
    for (std::size_t b = 0; b < Plan<D>::leaf_blocks; ++b)
      if (const std::uint64_t open = ~masks[lane].empty[b] & ~masks[lane].hit[b]; open != 0 && (clear >> lane & 1) != 0)
        probe.add(lane, b, open);
  }
  probe.finish();
  take(leaves, masks.data(), harvest);
}

template <std::size_t D>
void Leaf_decision<D>::take(const Leaf_batch<D>& leaves, const Leaf_masks<D>* masks, Block_list<D>& harvest)
{
  Cell_block<D>* const to = harvest.room(batch * Plan<D>::leaf_blocks + 1);
  std::size_t count = 0;
  std::uint64_t plotted = 0;
  for (unsigned rest = leaves.lanes; rest != 0; rest &= rest - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(rest));
    for (std::size_t b = 0; b < Plan<D>::leaf_blocks; ++b) {
      Cell_block<D>& block = to[count];
      for (std::size_t axis = 0; axis < D; ++axis)
        block.index[axis] = static_cast<std::uint32_t>(leaves.corner[axis][lane]) / block_side<D>;
      block.index[D - 1] += static_cast<std::uint32_t>(b);
      block.plotted = ~masks[lane].empty[b];
      block.hit = masks[lane].hit[b] & block.plotted;
      plotted += static_cast<unsigned>(std::popcount(block.plotted));
      count += block.plotted != 0 ? 1 : 0; // no branch, since nobody can predict it
    }
  }
  harvest.keep(count, plotted);
}

/// The cells of a leaf that do not belong to the grid.
template <std::size_t D>
Leaf_words<D> Leaf_decision<D>::outside(const Leaf_batch<D>& leaves, std::size_t lane) const
{
  Leaf_words<D> cells;
  std::array<std::uint32_t, D> corner;
  for (std::size_t axis = 0; axis < D; ++axis) corner[axis] = static_cast<std::uint32_t>(leaves.corner[axis][lane]);
  for (auto& word : cells) {
    word = corner[D - 1] < plan_.resolution[D - 1] ? ~inside(corner) : ~std::uint64_t{0};
    corner[D - 1] += block_side<D>;
  }
  return cells;
}

/// The cells of a block that belong to the grid. \pre `corner` does.
template <std::size_t D>
std::uint64_t Leaf_decision<D>::inside(const std::array<std::uint32_t, D>& corner) const
{
  bool whole = true;
  std::array<std::uint32_t, D> count;
  for (std::size_t axis = 0; axis < D; ++axis) {
    count[axis] = std::min(plan_.resolution[axis] - corner[axis], block_side<D>);
    whole = whole && count[axis] == block_side<D>;
  }
  if (whole) return ~std::uint64_t{0};
  std::uint64_t cells = 0;
  for (unsigned bit = 0; bit < 64; ++bit) {
    const auto cell = cell_of<D>({}, bit);
    bool in = true;
    for (std::size_t axis = 0; axis < D; ++axis) in = in && cell[axis] < count[axis];
    if (in) cells |= std::uint64_t{1} << bit;
  }
  return cells;
}

} // namespace corral::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
