// SPDX-License-Identifier: LGPL-3.0-or-later
// Included once for each instruction set, by fast_engine.cpp.
#if defined(CORRAL_SRC_FAST_LEAF_PROBE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CORRAL_SRC_FAST_LEAF_PROBE_INL_H
#undef CORRAL_SRC_FAST_LEAF_PROBE_INL_H
#else
#define CORRAL_SRC_FAST_LEAF_PROBE_INL_H
#endif

#include "leaf_corners-inl.h"

#include <array>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace corral::fast::HWY_NAMESPACE {

/// \brief Looks at single cells of the leaves of one batch on a finer lattice, up to eight cells at a time.
template <std::size_t D>
class Leaf_probe
{
public:
  /// \param masks      one of each leaf; receives what is found.
  /// \param workspace  `workspace_size` doubles.
  Leaf_probe(const Plan<D>& plan, const Leaf_batch<D>& leaves, const Thresholds& thresholds, Leaf_masks<D>* masks,
             double* workspace)
      : plan_(plan), leaves_(leaves), t_(thresholds), masks_(masks), c_(workspace)
  {}

  [[nodiscard]] static std::size_t workspace_size(const Monomial_shape<D>& shape)
  {
    return shape.size() * batch + Leaf_form<D>::workspace_size(shape);
  }

  /// Looks at some cells of one block of a leaf, now or later.
  void add(std::size_t leaf, std::size_t block, std::uint64_t cells)
  {
    for (; cells != 0; cells &= cells - 1) {
      const auto bit = static_cast<unsigned>(std::countr_zero(cells));
      auto cell = cell_of<D>({}, bit);
      cell[D - 1] += static_cast<std::uint32_t>(block) * block_side<D>;
      for (std::size_t axis = 0; axis < D; ++axis)
        centre_[axis][count_] = (2.0 * cell[axis] + 1) / plan_.leaf_cells[axis] - 1;
      leaf_[count_] = static_cast<std::int64_t>(leaf);
      where_[count_] = {block, std::uint64_t{1} << bit};
      if (++count_ == batch) finish();
    }
  }

  /// Looks at the cells that are left.
  void finish();

private:
  struct Place
  {
    std::size_t block;
    std::uint64_t bit;
  };

  [[nodiscard]] HWY_INLINE Octet coordinate(std::size_t axis, std::size_t k, unsigned pieces) const
  {
    const Arithmetic exact([] { return all_lanes; });
    return exact.sum(load(centre_[axis]), set((2.0 * static_cast<double>(k) / pieces - 1) / plan_.leaf_cells[axis]));
  }
  [[nodiscard]] Octet of_leaf(const double* values) const;
  void gather();
  [[nodiscard]] unsigned look(unsigned lanes, unsigned pieces, unsigned& hit) const;

  const Plan<D>& plan_;
  const Leaf_batch<D>& leaves_;
  const Thresholds& t_;
  Leaf_masks<D>* masks_;
  double* c_; // of the leaf of each cell
  std::size_t count_ = 0;
  std::array<Place, batch> where_{};
  alignas(64) std::int64_t leaf_[batch] = {};
  alignas(64) double centre_[D][batch] = {};
};

/// For each cell the value of its leaf, out of one value a leaf.
template <std::size_t D>
Octet Leaf_probe<D>::of_leaf(const double* values) const
{
  if constexpr (parts == 1) {
    return each([&](std::size_t)
                    HWY_ATTR { return hn::TableLookupLanes(load(values).part[0], hn::SetTableIndices(Tag(), leaf_)); });
  } else {
    alignas(64) double result[batch];
    for (std::size_t lane = 0; lane < batch; ++lane) result[lane] = values[leaf_[lane]];
    return load(result);
  }
}

template <std::size_t D>
void Leaf_probe<D>::gather()
{
  for (std::size_t i = 0; i < leaves_.cut.size; ++i) store(of_leaf(leaves_.coefficients + i * batch), c_ + i * batch);
}

/// Evaluates f at `pieces + 1` points a side of the cells; returns the lanes proved empty, and those hit.
template <std::size_t D>
unsigned Leaf_probe<D>::look(unsigned lanes, unsigned pieces, unsigned& hit) const
{
  const Arithmetic with([&]() HWY_ATTR { return at_most(of_leaf(leaves_.norm), set(leaves_.exact.probe())); });
  const Leaf_form<D> form(leaves_.cut, c_, c_ + leaves_.cut.size * batch, with);
  Octet low = set(std::numeric_limits<double>::infinity());
  Octet high = set(-std::numeric_limits<double>::infinity());
  const auto visit_row = [&]() HWY_ATTR {
    form.along_row(
        pieces + std::size_t{1}, [&](std::size_t k) HWY_ATTR { return coordinate(D - 1, k, pieces); },
        [&](const Octet& value) HWY_ATTR {
          low = min(low, value);
          high = max(high, value);
        });
  };
  for (std::size_t j = 0; j <= pieces; ++j) {
    form.fix_axis_before_last(coordinate(D - 2, j, pieces));
    for (std::size_t i = 0; i <= (D == 3 ? pieces : 0); ++i) {
      if constexpr (D == 3) form.fix_first_axis(coordinate(0, i, pieces));
      visit_row();
    }
  }
  const Octet sign = of_leaf(t_.sign);
  const Octet probe = of_leaf(t_.probe);
  hit |= at_most(probe, high) & at_most(low, set(0) - probe) & lanes;
  const Octet bend = set(1.0 / (pieces * pieces)); // a chord is so much nearer than that of the whole cell
  const Octet slack = set(1 + 0x1p-40);
  const Octet positive = (probe + (of_leaf(t_.positive) - sign) * bend) * slack;
  const Octet negative = (probe + (of_leaf(t_.negative) - sign) * bend) * slack;
  return (below(positive, low) | below(high, set(0) - negative)) & lanes;
}

template <std::size_t D>
void Leaf_probe<D>::finish()
{
  if (count_ == 0) return;
  std::fill(leaf_ + count_, leaf_ + batch, leaf_[0]);
  gather();
  const unsigned lanes = (1U << count_) - 1;
  unsigned hit = 0;
  unsigned empty = 0;
  for (unsigned pieces = 2; pieces <= Plan<D>::probe_pieces && (lanes & ~(hit | empty)) != 0; pieces *= 2)
    empty |= look(lanes & ~(hit | empty), pieces, hit);
  for (std::size_t lane = 0; lane < count_; ++lane) {
    Leaf_masks<D>& masks = masks_[leaf_[lane]];
    if ((empty >> lane & 1) != 0) masks.empty[where_[lane].block] |= where_[lane].bit;
    if ((hit >> lane & 1) != 0) masks.hit[where_[lane].block] |= where_[lane].bit;
  }
  count_ = 0;
}

} // namespace corral::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
