// SPDX-License-Identifier: LGPL-3.0-or-later
// Included once for each instruction set, by fast_engine.cpp.
#if defined(CORRAL_SRC_FAST_NODE_TESTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CORRAL_SRC_FAST_NODE_TESTS_INL_H
#undef CORRAL_SRC_FAST_NODE_TESTS_INL_H
#else
#define CORRAL_SRC_FAST_NODE_TESTS_INL_H
#endif

#include "Fast_plan.h"
#include "octet-inl.h"

#include <hwy/aligned_allocator.h>

HWY_BEFORE_NAMESPACE();
namespace corral::fast::HWY_NAMESPACE {

/// How large dropped terms may be, beside the change over one cell; smaller shares cost time, larger ones cells.
template <std::size_t D>
inline constexpr double share_of_high_degrees = D == 2 ? 0x1p-13 : 0x1p-8;
inline constexpr double share_of_squares = 0x1p-13;

/// \brief What is to become of eight nodes of one class: answers that come from sums of absolute coefficients.
template <std::size_t D>
class Node_tests
{
public:
  using Cut = typename Monomial_shape<D>::Class;

  explicit Node_tests(const Plan<D>& plan)
      : plan_(plan), by_degree_(hwy::AllocateAligned<double>((plan.shape.degree() + std::size_t{1}) * batch))
  {}

  /// The modified affine bound of eight forms; returns the lanes on which zero is not excluded.
  [[nodiscard]] unsigned bound(const Cut& cut, const double* c, const double* remainder);

  /// The lanes whose remainder is not small beside what the form can change over one cell. \pre `bound` has run.
  [[nodiscard]] unsigned hidden(unsigned level) const
  {
    return at_most(load(norm_) * set(plan_.cell_share[level]), load(remainder_) * set(4));
  }

  /// The lanes in which the terms above degree 2 outweigh the others: a leaf block bounds them coarsely, and smaller
  /// blocks can do better. \pre `bound` has run on this class.
  [[nodiscard]] unsigned rough(const Cut& cut) const
  {
    Octet high = set(0);
    for (unsigned d = 3; d <= cut.degree; ++d) high = high + sum(d);
    return at_most(sum(1) + sum(2), high);
  }

  /// \brief Moves the highest degrees into the remainder if, in all lanes of `kept`, they are small beside what the
  /// least gradient in the node changes over one cell; returns the class that is left.
  [[nodiscard]] std::size_t drop(unsigned level, std::size_t k, unsigned kept);

  /// An octet each.
  [[nodiscard]] const double* remainder() const { return remainder_; }
  [[nodiscard]] const double* norm() const { return norm_; }

private:
  [[nodiscard]] HWY_INLINE Octet sum(unsigned d) const { return load(by_degree_.get() + d * batch); }

  const Plan<D>& plan_;
  hwy::AlignedFreeUniquePtr<double[]> by_degree_; // sums of absolute coefficients of one degree
  alignas(64) double remainder_[batch];
  alignas(64) double norm_[batch];
};

template <std::size_t D>
unsigned Node_tests<D>::bound(const Cut& cut, const double* c, const double* remainder)
{
  const Monomial_shape<D>& shape = plan_.shape;
  const Rounding& r = plan_.rounding;
  const Octet centre = load(c);
  Octet norm = abs(centre);
  Octet spread = set(0);
  std::size_t i = 1;
  for (unsigned d = 1; d <= cut.degree; ++d) {
    Octet even = set(0);
    Octet odd = set(0);
    for (; i < shape.even_end(d); ++i) {
      const Octet term = load(c + i * batch);
      even = even + abs(term);
      spread = spread - min(with_sign_of(term, centre), set(0));
    }
    for (; i < shape.degree_end(d); ++i) odd = odd + abs(load(c + i * batch));
    spread = spread + odd;
    const Octet both_kinds = even + odd;
    store(both_kinds, by_degree_.get() + d * batch);
    norm = norm + both_kinds;
  }
  store(norm * set(r.sum), norm_);
  const Octet error = load(remainder);
  store(error, remainder_);
  return at_most(abs(centre), (spread * set(r.sum) + error) * set(r.step));
}

template <std::size_t D>
std::size_t Node_tests<D>::drop(unsigned level, std::size_t k, unsigned kept)
{
  const Rounding& r = plan_.rounding;
  const auto& classes = plan_.shape.classes();
  if (classes[k].degree <= 1) return k;
  Octet gradient = sum(1);
  for (unsigned d = 2; d <= classes[k].degree; ++d) gradient = gradient - sum(d) * set(d);
  const Octet remainder = load(remainder_);
  const Octet room = gradient * set(plan_.cell_share[level]);
  const Octet noise = remainder * set(0.125);
  Octet lost = set(0);
  std::size_t target = k;
  for (; target + 1 < classes.size(); ++target) {
    Octet more = set(0);
    for (unsigned d = classes[target].degree; d > classes[target + 1].degree; --d) more = more + sum(d);
    more = more * set(r.sum);
    const Octet share = set(classes[target + 1].degree > 1 ? share_of_high_degrees<D> : share_of_squares);
    if ((kept & ~at_most(more, max(room * share, noise))) != 0) break;
    lost = lost + more;
  }
  if (target != k) store((remainder + lost * set(r.dropped)) * set(r.step), remainder_);
  return target;
}

} // namespace corral::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
