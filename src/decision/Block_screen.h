// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_DECISION_BLOCK_SCREEN_H
#define CORRAL_SRC_DECISION_BLOCK_SCREEN_H

#include "Interval_jet.h"
#include "Interval_search.h"
#include "Tiled_form.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace corral::exact {

/// \brief Excludes zeros from whole parts of a block of cells by intervals, where several of its cells are asked for:
/// that costs less than to move the polynomial to each of them.
template <IntervalNumber I, std::size_t D>
class Block_screen
{
  static_assert(is_guaranteed<I>, "a verdict needs guaranteed intervals");

public:
  /// \param precision  bits that matter of the largest coefficient.
  explicit Block_screen(long precision) : precision_(precision) {}

  /// Whether the polynomial keeps away from zero on the cell; `false` says nothing.
  [[nodiscard]] bool excludes(Tiled_form<D>& form, const Cell<D>& cell)
  {
    Cell<D> block;
    for (std::size_t k = 0; k < D; ++k) block[k] = cell[k] / block_side<D>;
    if (!is_made_ || block != block_) {
      block_ = block;
      is_made_ = true;
      root_ = {};
    }
    if (++root_.asked < worth) return false;
    const Arithmetic_scope<I> scope;
    if (root_.asked == worth) look_at(root_, jet_on(form.on_block(cell)));
    Part* part = &root_;
    for (unsigned level = levels; part->is_open && level-- > 0;) {
      if (part != &root_ && ++part->asked < worth) return false;
      if (part->halves.empty()) cut(*part);
      std::size_t child = 0;
      for (std::size_t k = 0; k < D; ++k)
        if (part->is_cut[k]) child = 2 * child + (cell[k] >> level & 1);
      part = &part->halves[child];
    }
    return !part->is_open;
  }

private:
  static constexpr unsigned levels = std::bit_width(block_side<D>) - 1;
  static constexpr unsigned worth = 2; ///< questions about a part that pay for cutting it

  /// A block, or one of 2^D equal parts of a part.
  struct Part
  {
    Interval_jet<I, D> jet{}; ///< of the polynomial alone
    unsigned asked = 0;
    bool is_open = true; ///< it may hold a zero
    std::array<bool, D> is_cut{};
    std::vector<Part> halves{}; ///< the last axis varies fastest
  };

  static void look_at(Part& part, Interval_jet<I, D> jet)
  {
    part.is_open = common_sign(jet.values[0]) == 0;
    if (part.is_open) part.jet = std::move(jet);
  }

  [[nodiscard]] Interval_jet<I, D> jet_on(Power_form<D> block)
  {
    std::array<std::size_t, D> exponents{};
    for (Integer& c : block.values) {
      std::size_t degree = 0;
      for (const std::size_t e : exponents) degree += e;
      mpz_mul_2exp(c.get_mpz_t(), c.get_mpz_t(), levels * degree);
      for (std::size_t k = D; k-- > 0;) {
        if (++exponents[k] < block.size[k]) break;
        exponents[k] = 0;
      }
    }
    const Jet_maker<I, D> maker(block, binomials_, precision_);
    Interval_jet<I, D> jet;
    jet.size = maker.size();
    jet.values[0] = maker.make(0);
    return jet;
  }

  static void cut(Part& part)
  {
    for (std::size_t k = 0; k < D; ++k) part.is_cut[k] = part.jet.size[k] > 1; // else the same on both halves
    const I half = enclose<I>(Rational(1, 2));
    std::vector<Interval_jet<I, D>> jets;
    jets.push_back(std::move(part.jet));
    for (std::size_t axis = 0; axis < D; ++axis) {
      if (!part.is_cut[axis]) continue;
      std::vector<Interval_jet<I, D>> next;
      for (auto& upper : jets) {
        next.push_back(halve(upper, axis, half));
        next.push_back(std::move(upper));
      }
      jets = std::move(next);
    }
    for (auto& jet : jets) look_at(part.halves.emplace_back(), std::move(jet));
  }

  long precision_;
  Reciprocal_binomials<I> binomials_;
  Cell<D> block_{};
  bool is_made_ = false;
  Part root_;
};

} // namespace corral::exact

#endif
