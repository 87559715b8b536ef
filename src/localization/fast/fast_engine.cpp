// SPDX-License-Identifier: LGPL-3.0-or-later
// The engine proper, compiled once for each instruction set. The order of operations is the same for all of them, and
// no two are fused, so that the results are the same bit for bit. The analysis is in doc/taylor_form.md.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "localization/fast/fast_engine.cpp"
// Vectors whose length is known at run time only cannot be members of arrays and structs.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#include <hwy/foreach_target.h>

#include "Exact_limits.h"
#include "Subdivider.h"
#include "arithmetic-inl.h"
#include "leaf_decision-inl.h"
#include "node_pool-inl.h"
#include "node_tests-inl.h"
#include "octet-inl.h"
#include "taylor_shift-inl.h"

#include <hwy/aligned_allocator.h>
#include <hwy/highway.h>

#include <algorithm>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace corral::fast::HWY_NAMESPACE {

/// Batches of eight nodes, deepest full batch first.
template <std::size_t D>
class Worker final : public Subdivider<D>
{
public:
  Worker(const Plan<D>& plan, Pulse& pulse)
      : plan_(plan), pulse_(pulse), cuts_(plan.shape.classes().size()), pools_((plan.root_level + 1) * cuts_),
        level_count_(plan.root_level + 1), tests_(plan), leaves_(plan)
  {
    const std::size_t rows = plan.shape.size() * batch;
    workspace_ = hwy::AllocateAligned<double>(rows * (D + 1));
    for (std::size_t k = 0; k <= D; ++k) stage_[k] = workspace_.get() + k * rows;
  }

  void run(unsigned level, std::span<const Seed<D>> seeds, unsigned stop_level, Harvest<D>& harvest) override;

private:
  using Cut = typename Monomial_shape<D>::Class;
  using Pool_row = typename Pool<D>::Row;

  static constexpr std::size_t work_of_pulse = 20000; // coefficients of octets: the work of some milliseconds

  [[nodiscard]] const Cut& cut(std::size_t k) const { return plan_.shape.classes()[k]; }
  [[nodiscard]] Pool<D>& pool(unsigned level, std::size_t k) { return pools_[level * cuts_ + k]; }
  bool next(unsigned& level, std::size_t& k) const;
  void split(unsigned level, std::size_t k);
  void take(const Pool<D>& from, unsigned level, std::size_t k);
  template <std::size_t axis>
  void children(unsigned level, std::size_t k, const double* from);
  void admit(unsigned level, std::size_t k, const double* c);
  [[nodiscard]] unsigned inside() const;
  void emit_hidden(unsigned level, unsigned lanes);
  void emit_rough(unsigned level, std::size_t k, const double* c, unsigned lanes);
  void append(unsigned level, std::size_t k, const double* c, unsigned kept);
  void decide_leaves(const Pool<D>& from, std::size_t k);
  void emit_seeds(unsigned level);

  const Plan<D>& plan_;
  Pulse& pulse_;
  std::size_t work_ = 0; // since the pulse was asked
  unsigned stop_level_ = 0;
  Harvest<D>* harvest_ = nullptr;
  Exact_limits exact_;
  std::size_t cuts_;
  std::vector<Pool<D>> pools_;
  std::vector<std::size_t> level_count_; // nodes of one level
  Node_tests<D> tests_;
  Leaf_decision<D> leaves_;
  hwy::AlignedFreeUniquePtr<double[]> workspace_;
  double* stage_[D + 1]; // stage_[k]: coefficients shifted along k axes
  unsigned valid_ = 0;   // the lanes that hold a node
  Arithmetic arithmetic_{[] { return 0U; }};
  alignas(64) double remainder_[batch];
  alignas(64) double norm_[batch];
  alignas(64) double corner_[D][batch];
};

template <std::size_t D>
bool Worker<D>::next(unsigned& level, std::size_t& k) const
{
  bool found = false;
  for (std::size_t l = stop_level_ == 0 ? 0 : stop_level_ + 1; l < level_count_.size(); ++l) {
    if (level_count_[l] == 0) continue;
    for (std::size_t cut = 0; cut < cuts_; ++cut) {
      const std::size_t count = pools_[l * cuts_ + cut].count;
      if (count == 0) continue;
      found = true;
      level = static_cast<unsigned>(l);
      k = cut;
      if (count >= batch) return true;
    }
  }
  return found; // no full batch: the coarsest level
}

/// Makes the children of up to eight nodes of one pool, or decides them.
template <std::size_t D>
void Worker<D>::split(unsigned level, std::size_t k)
{
  Pool<D>& from = pool(level, k);
  const std::size_t taken = std::min(from.count, batch);
  from.count -= taken;
  level_count_[level] -= taken;
  if ((work_ += cut(k).size) > work_of_pulse) {
    work_ = 0;
    pulse_.ask();
  }
  valid_ = (1U << taken) - 1;
  if (taken < batch) // the other lanes compute with zeros
    for (std::size_t row = 0; row < Pool_row::coefficients + cut(k).size; ++row)
      std::fill(from.row(row) + from.count + taken, from.row(row) + from.count + batch, 0.0);
  if (level == plan_.leaf_level) return decide_leaves(from, k);
  take(from, level, k);
  children<0>(level - 1, k, stage_[0]);
}

/// Scales the variables that are to be halved; the coordinates of the children are these, shifted by one.
template <std::size_t D>
void Worker<D>::take(const Pool<D>& from, unsigned level, std::size_t k)
{
  const auto row = [&](std::size_t i) HWY_ATTR { return load(from.row(i) + from.count); };
  const Rounding& r = plan_.rounding;
  const Octet norm = row(Pool_row::norm);
  const Octet remainder = row(Pool_row::remainder);
  const Octet rounded = (remainder + (norm * set(r.split) + set(r.underflow))) * set(r.step);
  const Octet exact_norm = set(exact_.split(level - 1));
  store(if_at_most(norm, exact_norm, remainder, rounded), remainder_);
  arithmetic_ = Arithmetic([&]() HWY_ATTR { return at_most(norm, exact_norm); });
  store(norm, norm_);
  for (std::size_t axis = 0; axis < D; ++axis) store(row(Pool_row::corner + axis), corner_[axis]);
  unsigned halved = 0;
  for (std::size_t axis = 0; axis < D; ++axis)
    if (plan_.halves(level, axis)) halved |= 1U << axis;
  if (halved + 1 == 1U << D) {
    std::size_t i = 0;
    for (unsigned d = 0; d <= cut(k).degree; ++d) {
      const Octet scale = set(plan_.power_of_half[d]);
      for (; i < plan_.shape.degree_end(d); ++i)
        store(arithmetic_.product(row(Pool_row::coefficients + i), scale), stage_[0] + i * batch);
    }
    return;
  }
  if (level == plan_.leaf_level + 1) {
    for (std::size_t i = 0; i < cut(k).size; ++i)
      store(arithmetic_.product(row(Pool_row::coefficients + i), set(plan_.leaf_scale[i])), stage_[0] + i * batch);
    return;
  }
  for (std::size_t i = 0; i < cut(k).size; ++i) {
    unsigned exponent = 0;
    for (std::size_t axis = 0; axis < D; ++axis)
      if ((halved >> axis & 1) != 0) exponent += plan_.shape.exponents()[i][axis];
    store(arithmetic_.product(row(Pool_row::coefficients + i), set(plan_.power_of_half[exponent])),
          stage_[0] + i * batch);
  }
}

template <std::size_t D>
template <std::size_t axis>
void Worker<D>::children(unsigned level, std::size_t k, const double* from)
{
  if constexpr (axis == D) {
    admit(level, k, from);
  } else {
    if (!plan_.halves(level + 1, axis)) return children<axis + 1>(level, k, from);
    double* const to = stage_[axis + 1];
    if (cut(k).size > work_of_pulse) pulse_.ask();
    shift_lines<false>(arithmetic_, cut(k).lines[axis], from, to);
    children<axis + 1>(level, k, to);
    const Octet lower = load(corner_[axis]);
    store(lower + set(plan_.tree.span(level, axis)), corner_[axis]);
    shift_lines<true>(arithmetic_, cut(k).lines[axis], from, to);
    children<axis + 1>(level, k, to);
    store(lower, corner_[axis]);
  }
}

/// What becomes of eight children: most are dropped, the others stored for later.
template <std::size_t D>
void Worker<D>::admit(unsigned level, std::size_t k, const double* c)
{
  harvest_->nodes += static_cast<unsigned>(std::popcount(valid_));
  unsigned kept = inside() & tests_.bound(cut(k), c, remainder_);
  if (plan_.tells_hidden && kept != 0 && level < plan_.root_level)
    if (const unsigned hidden = kept & tests_.hidden(level); hidden != 0) {
      emit_hidden(level, hidden);
      kept &= ~hidden;
    }
  if (plan_.tells_rough && kept != 0 && level == plan_.rough_level && cut(k).degree > 2)
    if (const unsigned rough = kept & tests_.rough(cut(k)); rough != 0) {
      emit_rough(level, k, c, rough);
      kept &= ~rough;
    }
  if (kept == 0) return;
  append(level, tests_.drop(level, k, kept), c, kept);
}

template <std::size_t D>
void Worker<D>::decide_leaves(const Pool<D>& from, std::size_t k)
{
  const auto copy = [&](std::size_t row, double* to) HWY_ATTR { store(load(from.row(row) + from.count), to); };
  copy(Pool_row::remainder, remainder_);
  copy(Pool_row::norm, norm_);
  for (std::size_t axis = 0; axis < D; ++axis) copy(Pool_row::corner + axis, corner_[axis]);
  for (std::size_t i = 0; i < cut(k).size; ++i) copy(Pool_row::coefficients + i, stage_[0] + i * batch);
  leaves_.decide({cut(k), stage_[0], remainder_, norm_, corner_, exact_, valid_}, harvest_->blocks);
}

/// The lanes that hold a node with cells of the grid.
template <std::size_t D>
unsigned Worker<D>::inside() const
{
  unsigned lanes = valid_;
  for (std::size_t axis = 0; axis < D; ++axis) lanes &= below(load(corner_[axis]), set(plan_.resolution[axis]));
  return lanes;
}

template <std::size_t D>
void Worker<D>::emit_hidden(unsigned level, unsigned lanes)
{
  for (; lanes != 0; lanes &= lanes - 1) {
    Hidden_node<D> node{level, {}};
    for (std::size_t axis = 0; axis < D; ++axis)
      node.corner[axis] = static_cast<std::uint32_t>(corner_[axis][std::countr_zero(lanes)]);
    harvest_->hidden.push_back(node);
  }
}

template <std::size_t D>
void Worker<D>::emit_rough(unsigned level, std::size_t k, const double* c, unsigned lanes)
{
  for (; lanes != 0; lanes &= lanes - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
    Seed<D> seed{k, exact_.quantum(level), tests_.remainder()[lane], tests_.norm()[lane], {}, {}};
    for (std::size_t axis = 0; axis < D; ++axis) seed.corner[axis] = static_cast<std::uint32_t>(corner_[axis][lane]);
    for (std::size_t i = 0; i < cut(k).size; ++i) seed.coefficients.push_back(c[i * batch + lane]);
    harvest_->rough.push_back(std::move(seed));
  }
}

template <std::size_t D>
void Worker<D>::append(unsigned level, std::size_t k, const double* c, unsigned kept)
{
  Pool<D>& to = pool(level, k);
  to.prepare(cut(k).size);
  for (std::size_t p = 0; p < parts; ++p) {
    const unsigned lanes = kept >> (p * part_lanes) & ((1U << part_lanes) - 1);
    if (lanes == 0) continue;
    const auto order = hn::SetTableIndices(Tag(), lanes_of_set[lanes].data());
    const auto add = [&](std::size_t row, const double* values) HWY_ATTR {
      const auto all = hn::LoadU(Tag(), values + p * part_lanes);
      hn::StoreU(hn::TableLookupLanes(all, order), Tag(), to.row(row) + to.count);
    };
    add(Pool_row::remainder, tests_.remainder());
    add(Pool_row::norm, tests_.norm());
    for (std::size_t axis = 0; axis < D; ++axis) add(Pool_row::corner + axis, corner_[axis]);
    for (std::size_t i = 0; i < cut(k).size; ++i) add(Pool_row::coefficients + i, c + i * batch);
    to.count += static_cast<unsigned>(std::popcount(lanes));
  }
  level_count_[level] += static_cast<unsigned>(std::popcount(kept));
  if (stop_level_ != 0 && level == stop_level_) emit_seeds(level);
}

template <std::size_t D>
void Worker<D>::emit_seeds(unsigned level)
{
  for (std::size_t k = 0; k < cuts_; ++k) {
    Pool<D>& from = pool(level, k);
    for (std::size_t lane = 0; lane < from.count; ++lane) {
      const auto value = [&](std::size_t row) { return from.row(row)[lane]; };
      Seed<D> seed{k, exact_.quantum(level), value(Pool_row::remainder), value(Pool_row::norm), {}, {}};
      for (std::size_t axis = 0; axis < D; ++axis)
        seed.corner[axis] = static_cast<std::uint32_t>(value(Pool_row::corner + axis));
      seed.coefficients.reserve(cut(k).size);
      for (std::size_t i = 0; i < cut(k).size; ++i) seed.coefficients.push_back(value(Pool_row::coefficients + i));
      harvest_->seeds.push_back(std::move(seed));
    }
    from.count = 0;
  }
  level_count_[level] = 0;
}

template <std::size_t D>
void Worker<D>::run(unsigned level, std::span<const Seed<D>> seeds, unsigned stop_level, Harvest<D>& harvest)
{
  stop_level_ = stop_level;
  harvest_ = &harvest;
  exact_.reset(plan_.shape.degree(), level, plan_.leaf_level, common_quantum(seeds));
  if (level == plan_.root_level) {
    const Seed<D>& root = seeds[0];
    for (std::size_t i = 0; i < cut(0).size; ++i) store(set(root.coefficients[i]), stage_[0] + i * batch);
    store(set(root.remainder), remainder_);
    for (std::size_t axis = 0; axis < D; ++axis) store(set(0), corner_[axis]);
    valid_ = 1;
    admit(level, 0, stage_[0]);
  } else {
    for (const Seed<D>& seed : seeds) {
      Pool<D>& to = pool(level, seed.cut);
      to.prepare(cut(seed.cut).size);
      const auto put = [&](std::size_t row, double value) { to.row(row)[to.count] = value; };
      put(Pool_row::remainder, seed.remainder);
      put(Pool_row::norm, seed.norm);
      for (std::size_t axis = 0; axis < D; ++axis) put(Pool_row::corner + axis, seed.corner[axis]);
      for (std::size_t i = 0; i < seed.coefficients.size(); ++i) put(Pool_row::coefficients + i, seed.coefficients[i]);
      ++to.count;
    }
    level_count_[level] = seeds.size();
  }
  std::size_t k = 0;
  while (next(level, k)) split(level, k);
}

std::unique_ptr<Subdivider<2>> make_worker_2(const Plan<2>& plan, Pulse& pulse)
{
  return std::make_unique<Worker<2>>(plan, pulse);
}
std::unique_ptr<Subdivider<3>> make_worker_3(const Plan<3>& plan, Pulse& pulse)
{
  return std::make_unique<Worker<3>>(plan, pulse);
}

} // namespace corral::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace corral::fast {

HWY_EXPORT(make_worker_2);
HWY_EXPORT(make_worker_3);

template <>
std::unique_ptr<Subdivider<2>> make_subdivider<2>(const Plan<2>& plan, Pulse& pulse)
{
  return HWY_DYNAMIC_DISPATCH(make_worker_2)(plan, pulse);
}

template <>
std::unique_ptr<Subdivider<3>> make_subdivider<3>(const Plan<3>& plan, Pulse& pulse)
{
  return HWY_DYNAMIC_DISPATCH(make_worker_3)(plan, pulse);
}

} // namespace corral::fast
#endif
