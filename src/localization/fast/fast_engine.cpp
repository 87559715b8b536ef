// SPDX-License-Identifier: LGPL-3.0-or-later
// The engine proper, compiled once for each instruction set. The order of operations is the same for all of them, and
// no two are fused, so that the results are the same bit for bit. The analysis is in doc/taylor_form.md.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "localization/fast/fast_engine.cpp"
#include <hwy/foreach_target.h>

#include "Fast_plan.h"
#include "leaf_block-inl.h"
#include "taylor_shift-inl.h"

#include <hwy/aligned_allocator.h>
#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace corral::fast::HWY_NAMESPACE {

/// \brief Nodes of one level and class, one lane each; row 0 holds remainders, row 1 norms (upper bounds of the sum of
/// absolute coefficients), the next D corners, the next the case that a node below the leaves belongs to, the others
/// coefficients.
template <std::size_t D>
struct Pool
{
  static constexpr std::size_t header = 3 + D;
  static constexpr std::size_t stride = batch * ((std::size_t{1} << D) + 2);
  hwy::AlignedFreeUniquePtr<double[]> rows;
  std::size_t count = 0;

  [[nodiscard]] double* row(std::size_t r) { return rows.get() + r * stride; }
  void prepare(std::size_t coefficients)
  {
    if (rows) return;
    rows = hwy::AllocateAligned<double>((header + coefficients) * stride);
    std::fill_n(rows.get(), (header + coefficients) * stride, 0.0);
  }
};

/// The unknown cells of a leaf block while they are subdivided further.
struct Open_case
{
  std::size_t block;           ///< where it is in the harvest
  std::uint64_t some_positive; ///< as in `Leaf_masks`
  std::uint64_t some_negative;
};

/// \brief One worker: subdivides batches of eight nodes, deepest full batch first.
template <std::size_t D>
class Worker
{
public:
  Worker(const Plan<D>& plan, unsigned stop_level, Harvest<D>& harvest)
      : plan_(plan), stop_level_(stop_level), harvest_(harvest), cuts_(plan.shape.classes().size()),
        pools_((plan.root_level + 1 + cell_depth) * cuts_), level_count_(plan.root_level + 1 + cell_depth)
  {
    const std::size_t rows = plan.shape.size() * batch;
    buffer_ = hwy::AllocateAligned<double>(rows * (D + 1));
    for (std::size_t k = 0; k <= D; ++k) stage_[k] = buffer_.get() + k * rows;
    const std::size_t degrees = (plan.shape.degree() + std::size_t{1}) * batch;
    by_degree_ = hwy::AllocateAligned<double>(degrees);
    powers_ = hwy::AllocateAligned<double>(degrees);
  }

  void run(int level, const Seed<D>* seeds, std::size_t count);

private:
  using Cut = typename Monomial_shape<D>::Class;
  static constexpr std::size_t header = Pool<D>::header;

  [[nodiscard]] const Cut& cut(std::size_t k) const { return plan_.shape.classes()[k]; }
  /// Levels count cells as in `Subdivision_tree`; the children of cells have level -1, and so on.
  [[nodiscard]] std::size_t slot(int level) const { return static_cast<std::size_t>(level + cell_depth); }
  [[nodiscard]] Pool<D>& pool(int level, std::size_t k) { return pools_[slot(level) * cuts_ + k]; }
  [[nodiscard]] bool halves(int level, std::size_t axis) const
  {
    return level <= static_cast<int>(plan_.cells_log2[axis]);
  }
  [[nodiscard]] double exact_below(int level) const
  {
    return plan_.exact_below[static_cast<std::size_t>(static_cast<int>(plan_.root_level) - level)];
  }
  bool next(int& level, std::size_t& k) const;
  void split(int level, std::size_t k);
  template <std::size_t axis>
  void children(int level, std::size_t k, const double* from);
  void admit(int level, std::size_t k, const double* c);
  unsigned bound(const Cut& cut, const double* c);
  std::size_t drop(int level, std::size_t k, unsigned kept);
  void append(int level, std::size_t k, const double* c, unsigned kept);
  void decide_leaves(std::size_t k, const double* c, unsigned kept);
  void leaf_thresholds(std::size_t k, const double* c);
  [[nodiscard]] std::uint64_t inside(const std::array<std::uint32_t, D>& corner) const;
  void emit_seeds(int level);
  void reopen(std::size_t k, const double* c, std::size_t lane, const Leaf_masks& masks);
  unsigned close_cells(int level, const double* c, unsigned kept);
  [[nodiscard]] std::uint64_t covered(int level, std::size_t lane, const Cell_block<D>& block) const;

  const Plan<D>& plan_;
  unsigned stop_level_;
  Harvest<D>& harvest_;
  std::size_t cuts_;
  std::vector<Pool<D>> pools_;
  std::vector<std::size_t> level_count_; // nodes of one level
  std::vector<Open_case> cases_;
  hwy::AlignedFreeUniquePtr<double[]> buffer_;
  hwy::AlignedFreeUniquePtr<double[]> by_degree_; // sums of absolute coefficients of one degree
  hwy::AlignedFreeUniquePtr<double[]> powers_;
  double* stage_[D + 1]; // stage_[k]: coefficients shifted along k axes
  unsigned valid_ = 0;   // the lanes that hold a node
  alignas(64) double remainder_[batch];
  alignas(64) double norm_[batch];
  alignas(64) double corner_[D][batch];
  alignas(64) double case_[batch] = {};
  alignas(64) double child_remainder_[batch];
  alignas(64) double child_norm_[batch];
  alignas(64) double threshold_[3][batch];
};

template <std::size_t D>
bool Worker<D>::next(int& level, std::size_t& k) const
{
  bool found = false;
  const std::size_t first = stop_level_ == 0 ? 0 : slot(static_cast<int>(stop_level_)) + 1;
  for (std::size_t s = first; s < level_count_.size(); ++s) {
    if (level_count_[s] == 0) continue;
    for (std::size_t cut = 0; cut < cuts_; ++cut) {
      const std::size_t count = pools_[s * cuts_ + cut].count;
      if (count == 0) continue;
      found = true;
      level = static_cast<int>(s) - cell_depth;
      k = cut;
      if (count >= batch) return true;
    }
  }
  return found; // no full batch: the coarsest level
}

template <std::size_t D>
void Worker<D>::split(int level, std::size_t k)
{
  const Tag tag;
  Pool<D>& from = pool(level, k);
  const std::size_t taken = std::min(from.count, batch);
  from.count -= taken;
  level_count_[slot(level)] -= taken;
  valid_ = (1U << taken) - 1;
  unsigned halved = 0;
  for (std::size_t axis = 0; axis < D; ++axis)
    if (halves(level, axis)) halved |= 1U << axis;
  const Rounding& r = plan_.rounding;
  for (std::size_t lane = 0; lane < batch; lane += hn::Lanes(tag)) {
    const double* const column = from.row(0) + from.count + lane;
    const auto row = [&](std::size_t i) { return hn::LoadU(tag, column + i * Pool<D>::stride); };
    const Vector rounding = hn::Add(hn::Mul(row(1), hn::Set(tag, r.split)), hn::Set(tag, r.underflow));
    const Vector remainder = hn::Mul(hn::Add(row(0), rounding), hn::Set(tag, r.step));
    const auto exact = hn::Le(row(1), hn::Set(tag, exact_below(level - 1)));
    hn::Store(hn::IfThenElse(exact, row(0), remainder), tag, remainder_ + lane);
    hn::Store(row(1), tag, norm_ + lane);
    for (std::size_t axis = 0; axis < D; ++axis) hn::Store(row(2 + axis), tag, corner_[axis] + lane);
    hn::Store(row(2 + D), tag, case_ + lane);
    const auto& exponents = plan_.shape.exponents();
    for (std::size_t i = 0; i < cut(k).size; ++i) {
      unsigned exponent = 0;
      for (std::size_t axis = 0; axis < D; ++axis)
        if ((halved >> axis & 1) != 0) exponent += exponents[i][axis];
      hn::Store(hn::Mul(row(header + i), hn::Set(tag, plan_.halves[exponent])), tag, stage_[0] + i * batch + lane);
    }
  }
  children<0>(level - 1, k, stage_[0]);
}

template <std::size_t D>
template <std::size_t axis>
void Worker<D>::children(int level, std::size_t k, const double* from)
{
  if constexpr (axis == D) {
    admit(level, k, from);
  } else {
    if (!halves(level + 1, axis)) return children<axis + 1>(level, k, from);
    double* const to = stage_[axis + 1];
    for (std::size_t lane = 0; lane < batch; lane += hn::Lanes(Tag()))
      shift_lines<false>(cut(k).lines[axis], from + lane, to + lane);
    children<axis + 1>(level, k, to);
    const double span = std::ldexp(1.0, level);
    for (double& corner : corner_[axis]) corner += span;
    for (std::size_t lane = 0; lane < batch; lane += hn::Lanes(Tag()))
      shift_lines<true>(cut(k).lines[axis], from + lane, to + lane);
    children<axis + 1>(level, k, to);
    for (double& corner : corner_[axis]) corner -= span;
  }
}

/// What becomes of eight children: most are dropped, the others stored for later or decided at once.
template <std::size_t D>
void Worker<D>::admit(int level, std::size_t k, const double* c)
{
  unsigned kept = bound(cut(k), c);
  const int leaf_level = static_cast<int>(plan_.leaf_level);
  if (level < leaf_level) kept = close_cells(level, c, kept);
  if (kept == 0) return;
  k = drop(level, k, kept);
  if (level == leaf_level)
    decide_leaves(k, c, kept);
  else
    append(level, k, c, kept);
}

/// The modified affine bound of eight forms; returns the lanes inside the grid on which zero is not excluded.
template <std::size_t D>
unsigned Worker<D>::bound(const Cut& cut, const double* c)
{
  const Tag tag;
  const Monomial_shape<D>& shape = plan_.shape;
  harvest_.nodes += static_cast<unsigned>(std::popcount(valid_));
  unsigned kept = 0;
  for (std::size_t lane = 0; lane < batch; lane += hn::Lanes(tag)) {
    const auto load = [&](std::size_t i) { return hn::Load(tag, c + i * batch + lane); };
    const Vector centre = load(0);
    const Vector sign = hn::And(centre, hn::SignBit(tag));
    Vector norm = hn::Abs(centre);
    Vector spread = hn::Zero(tag);
    for (unsigned d = 1; d <= cut.degree; ++d) {
      Vector even = hn::Zero(tag);
      Vector odd = hn::Zero(tag);
      std::size_t i = shape.degree_end(d - 1);
      for (; i < shape.even_end(d); ++i) {
        const Vector term = load(i);
        even = hn::Add(even, hn::Abs(term));
        spread = hn::Sub(spread, hn::Min(hn::Xor(term, sign), hn::Zero(tag)));
      }
      for (; i < shape.degree_end(d); ++i) odd = hn::Add(odd, hn::Abs(load(i)));
      spread = hn::Add(spread, odd);
      const Vector sum = hn::Add(even, odd);
      hn::Store(sum, tag, by_degree_.get() + d * batch + lane);
      norm = hn::Add(norm, sum);
    }
    const Rounding& r = plan_.rounding;
    hn::Store(hn::Mul(norm, hn::Set(tag, r.sum)), tag, child_norm_ + lane);
    const Vector remainder = hn::Load(tag, remainder_ + lane);
    hn::Store(remainder, tag, child_remainder_ + lane);
    const Vector limit = hn::Mul(hn::Add(hn::Mul(spread, hn::Set(tag, r.sum)), remainder), hn::Set(tag, r.step));
    auto outside = hn::Gt(hn::Abs(centre), limit);
    for (std::size_t axis = 0; axis < D; ++axis)
      outside = hn::Or(outside, hn::Ge(hn::Load(tag, corner_[axis] + lane),
                                       hn::Set(tag, static_cast<double>(plan_.resolution[axis]))));
    kept |= (~bits_of(tag, outside) & ((1U << hn::Lanes(tag)) - 1)) << lane;
  }
  return kept & valid_;
}

/// Moves the highest degrees into the remainder if, in all lanes, they are small beside what the least gradient in the
/// node changes over one cell.
template <std::size_t D>
std::size_t Worker<D>::drop(int level, std::size_t k, unsigned kept)
{
  const Tag tag;
  const Rounding& r = plan_.rounding;
  const auto& classes = plan_.shape.classes();
  if (classes[k].degree <= 1) return k;
  const double share = std::ldexp(1.0, -13 - std::max(level, 0));
  alignas(64) double small[batch];
  for (std::size_t lane = 0; lane < batch; lane += hn::Lanes(tag)) {
    const auto sum = [&](unsigned d) { return hn::Load(tag, by_degree_.get() + d * batch + lane); };
    Vector gradient = sum(1);
    for (unsigned d = 2; d <= classes[k].degree; ++d)
      gradient = hn::Sub(gradient, hn::Mul(sum(d), hn::Set(tag, static_cast<double>(d))));
    const Vector noise = hn::Mul(hn::Load(tag, child_remainder_ + lane), hn::Set(tag, 0.125));
    hn::Store(hn::Max(hn::Mul(gradient, hn::Set(tag, share)), noise), tag, small + lane);
  }
  while (k + 1 < cuts_ && classes[k + 1].degree >= 1) {
    alignas(64) double lost[batch];
    unsigned fine = 0;
    for (std::size_t lane = 0; lane < batch; lane += hn::Lanes(tag)) {
      Vector sum = hn::Zero(tag);
      for (unsigned d = classes[k].degree; d > classes[k + 1].degree; --d)
        sum = hn::Add(sum, hn::Load(tag, by_degree_.get() + d * batch + lane));
      sum = hn::Mul(sum, hn::Set(tag, r.sum));
      hn::Store(sum, tag, lost + lane);
      fine |= bits_of(tag, hn::Le(sum, hn::Load(tag, small + lane))) << lane;
    }
    if ((kept & ~fine) != 0) break;
    if (r.keep_dropped)
      for (std::size_t lane = 0; lane < batch; ++lane)
        child_remainder_[lane] = (child_remainder_[lane] + lost[lane]) * r.step;
    ++k;
  }
  return k;
}

template <std::size_t D>
void Worker<D>::append(int level, std::size_t k, const double* c, unsigned kept)
{
  const Tag tag;
  Pool<D>& to = pool(level, k);
  to.prepare(cut(k).size);
  for (std::size_t lane = 0; lane < batch; lane += hn::Lanes(tag)) {
    const auto bits = static_cast<std::uint8_t>(kept >> lane & ((1U << hn::Lanes(tag)) - 1));
    if (bits == 0) continue;
    const std::uint8_t bytes[8] = {bits};
    const auto mask = hn::LoadMaskBits(tag, bytes);
    const auto add = [&](std::size_t row, const double* values) {
      hn::StoreU(hn::Compress(hn::Load(tag, values + lane), mask), tag, to.row(row) + to.count);
    };
    add(0, child_remainder_);
    add(1, child_norm_);
    for (std::size_t axis = 0; axis < D; ++axis) add(2 + axis, corner_[axis]);
    add(2 + D, case_);
    for (std::size_t i = 0; i < cut(k).size; ++i) add(header + i, c + i * batch);
    to.count += static_cast<unsigned>(std::popcount(bits));
  }
  level_count_[slot(level)] += static_cast<unsigned>(std::popcount(kept));
  if (stop_level_ != 0 && level == static_cast<int>(stop_level_)) emit_seeds(level);
}

template <std::size_t D>
void Worker<D>::emit_seeds(int level)
{
  for (std::size_t k = 0; k < cuts_; ++k) {
    Pool<D>& from = pool(level, k);
    for (std::size_t lane = 0; lane < from.count; ++lane) {
      Seed<D> seed{k, {}};
      for (std::size_t row = 0; row < header + cut(k).size; ++row) seed.rows.push_back(from.row(row)[lane]);
      harvest_.seeds.push_back(std::move(seed));
    }
    level_count_[slot(level)] -= from.count;
    from.count = 0;
  }
}

/// What corner values must exceed. Along an axis on which f is monotone the extremes lie at corners; along another,
/// f bends away from its chord by at most the second derivative times an eighth of the squared cell width.
template <std::size_t D>
void Worker<D>::leaf_thresholds(std::size_t k, const double* c)
{
  const Tag tag;
  const Rounding& r = plan_.rounding;
  const std::size_t size = cut(k).size;
  for (std::size_t lane = 0; lane < batch; lane += hn::Lanes(tag)) {
    const auto load = [&](std::size_t i) { return i < size ? hn::Load(tag, c + i * batch + lane) : hn::Zero(tag); };
    const Vector noise = hn::Add(hn::Mul(hn::Load(tag, child_norm_ + lane), hn::Set(tag, r.evaluate)),
                                 hn::Load(tag, child_remainder_ + lane));
    const Vector rounded = hn::Mul(hn::Add(noise, hn::Set(tag, r.underflow)), hn::Set(tag, r.step));
    const double limit = exact_below(static_cast<int>(plan_.leaf_level)) * plan_.exact_evaluation;
    const auto exact = hn::Le(hn::Load(tag, child_norm_ + lane), hn::Set(tag, limit));
    const Vector sign = hn::IfThenElse(exact, hn::Load(tag, child_remainder_ + lane), rounded);
    Vector positive = sign;
    Vector negative = sign;
    for (std::size_t axis = 0; axis < D; ++axis) {
      Vector slope = hn::Zero(tag);
      Vector curve = hn::Zero(tag);
      for (const auto& weight : plan_.weights[axis]) {
        if (weight.position >= size) break;
        const Vector term = hn::Abs(load(weight.position));
        slope = hn::Add(slope, hn::Mul(term, hn::Set(tag, weight.slope)));
        if (weight.position != plan_.square[axis]) curve = hn::Add(curve, hn::Mul(term, hn::Set(tag, weight.curve)));
      }
      const Vector square = hn::Mul(load(plan_.square[axis]), hn::Set(tag, 2.0));
      const auto monotone = hn::Ge(hn::Abs(load(plan_.linear[axis])), hn::Mul(slope, hn::Set(tag, r.sum)));
      const auto bend = [&](Vector second) {
        const Vector most =
            hn::Mul(hn::Add(second, hn::Mul(curve, hn::Set(tag, r.sum))), hn::Set(tag, plan_.sag[axis]));
        return hn::IfThenZeroElse(monotone, hn::Max(most, hn::Zero(tag)));
      };
      positive = hn::Add(positive, bend(square));
      negative = hn::Add(negative, bend(hn::Neg(square)));
    }
    hn::Store(sign, tag, threshold_[0] + lane);
    hn::Store(hn::Mul(positive, hn::Set(tag, r.step)), tag, threshold_[1] + lane);
    hn::Store(hn::Mul(negative, hn::Set(tag, r.step)), tag, threshold_[2] + lane);
  }
}

template <std::size_t D>
void Worker<D>::decide_leaves(std::size_t k, const double* c, unsigned kept)
{
  if (harvest_.blocks.size() > plan_.cell_budget) throw_over_budget(plan_.cell_budget);
  leaf_thresholds(k, c);
  for (; kept != 0; kept &= kept - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(kept));
    std::array<std::uint32_t, D> corner;
    for (std::size_t axis = 0; axis < D; ++axis) corner[axis] = static_cast<std::uint32_t>(corner_[axis][lane]);
    const Leaf_masks masks =
        Leaf_block<D>(plan_, cut(k), c + lane)
            .decide({threshold_[0][lane], threshold_[1][lane], threshold_[2][lane]}, powers_.get());
    const std::uint64_t plotted = ~masks.empty & inside(corner);
    if (plotted == 0) continue;
    for (auto& index : corner) index /= block_side<D>;
    const std::uint64_t hit = masks.some_positive & masks.some_negative & plotted;
    harvest_.blocks.push_back({corner, plotted, hit});
    if (plotted != hit) reopen(k, c, lane, masks);
  }
}

/// Queues a leaf block with unknown cells for subdivision down to these cells and further.
template <std::size_t D>
void Worker<D>::reopen(std::size_t k, const double* c, std::size_t lane, const Leaf_masks& masks)
{
  if (!(child_norm_[lane] > 64 * threshold_[0][lane])) return; // rounding errors hide everything
  case_[lane] = static_cast<double>(cases_.size());
  cases_.push_back({harvest_.blocks.size() - 1, masks.some_positive, masks.some_negative});
  append(static_cast<int>(plan_.leaf_level), k, c, 1U << lane);
}

/// The cells of a block that a node below the leaves covers; the cell that it lies in for one below the cells.
template <std::size_t D>
std::uint64_t Worker<D>::covered(int level, std::size_t lane, const Cell_block<D>& block) const
{
  std::array<std::uint32_t, D> first;
  for (std::size_t axis = 0; axis < D; ++axis)
    first[axis] = static_cast<std::uint32_t>(corner_[axis][lane]) - block.index[axis] * block_side<D>;
  std::uint64_t cells = std::uint64_t{1} << bit_of<D>(first);
  if (level <= 0) return cells;
  unsigned stride = 1;
  for (std::size_t axis = D; axis-- > 0; stride *= block_side<D>)
    for (unsigned length = 1; length < plan_.tree.span(static_cast<unsigned>(level), axis); length *= 2)
      cells |= cells << (stride * length);
  return cells;
}

/// Draws conclusions on unknown cells from the bounds of the nodes of this level; returns the nodes to go on with.
///
/// A cell that is subdivided is taken out of the plotted ones and comes back with a node that cannot be dropped.
template <std::size_t D>
unsigned Worker<D>::close_cells(int level, const double* c, unsigned kept)
{
  unsigned open = 0;
  for (unsigned rest = valid_; rest != 0; rest &= rest - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(rest));
    Open_case& open_case = cases_[static_cast<std::size_t>(case_[lane])];
    Cell_block<D>& block = harvest_.blocks[open_case.block];
    const bool dropped = (kept >> lane & 1) == 0;
    std::uint64_t cells = covered(level, lane, block) & ~block.hit;
    if (level >= 0) cells &= block.plotted;
    if (cells == 0) continue;
    if (level <= 0) {
      if (c[lane] >= child_remainder_[lane]) open_case.some_positive |= cells;
      if (c[lane] <= -child_remainder_[lane]) open_case.some_negative |= cells;
      if ((open_case.some_positive & open_case.some_negative & cells) != 0) {
        block.plotted |= cells;
        block.hit |= cells;
        continue;
      }
      if (level == 0 || dropped) block.plotted &= level == 0 ? ~cells : ~std::uint64_t{0};
      if (!dropped && level == -cell_depth) block.plotted |= cells;
      if (!dropped && level > -cell_depth) open |= 1U << lane;
    } else if (dropped) {
      block.plotted &= ~cells;
    } else {
      open |= 1U << lane;
    }
  }
  return open;
}

/// The cells of a leaf block that belong to the grid.
template <std::size_t D>
std::uint64_t Worker<D>::inside(const std::array<std::uint32_t, D>& corner) const
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

template <std::size_t D>
void Worker<D>::run(int level, const Seed<D>* seeds, std::size_t count)
{
  for (std::size_t s = 0; s < count; ++s) {
    const std::size_t k = seeds[s].cut;
    Pool<D>& to = pool(level, k);
    to.prepare(cut(k).size);
    for (std::size_t row = 0; row < seeds[s].rows.size(); ++row) to.row(row)[to.count] = seeds[s].rows[row];
    ++to.count;
    ++level_count_[slot(level)];
  }
  if (level == static_cast<int>(plan_.leaf_level)) { // the whole grid is one block
    Pool<D>& root = pool(level, 0);
    for (std::size_t i = 0; i < cut(0).size; ++i) std::copy_n(root.row(header + i), batch, stage_[0] + i * batch);
    std::copy_n(root.row(0), batch, remainder_);
    for (std::size_t axis = 0; axis < D; ++axis) std::fill_n(corner_[axis], batch, 0.0);
    root.count = 0;
    level_count_[slot(level)] = 0;
    valid_ = 1;
    admit(level, 0, stage_[0]);
  }
  std::size_t k = 0;
  while (next(level, k)) split(level, k);
}

void subdivide_2(const Plan<2>& plan, unsigned level, const Seed<2>* seeds, std::size_t count, unsigned stop_level,
                 Harvest<2>& harvest)
{
  Worker<2>(plan, stop_level, harvest).run(static_cast<int>(level), seeds, count);
}

void subdivide_3(const Plan<3>& plan, unsigned level, const Seed<3>* seeds, std::size_t count, unsigned stop_level,
                 Harvest<3>& harvest)
{
  Worker<3>(plan, stop_level, harvest).run(static_cast<int>(level), seeds, count);
}

} // namespace corral::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace corral::fast {

HWY_EXPORT(subdivide_2);
HWY_EXPORT(subdivide_3);

template <>
void subdivide_seeds<2>(const Plan<2>& plan, unsigned level, const Seed<2>* seeds, std::size_t count,
                        unsigned stop_level, Harvest<2>& harvest)
{
  HWY_DYNAMIC_DISPATCH(subdivide_2)(plan, level, seeds, count, stop_level, harvest);
}

template <>
void subdivide_seeds<3>(const Plan<3>& plan, unsigned level, const Seed<3>* seeds, std::size_t count,
                        unsigned stop_level, Harvest<3>& harvest)
{
  HWY_DYNAMIC_DISPATCH(subdivide_3)(plan, level, seeds, count, stop_level, harvest);
}

} // namespace corral::fast
#endif
