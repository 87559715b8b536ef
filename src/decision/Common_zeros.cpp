// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Common_zeros.h"

#include "../algebra/Extreme_points.h"
#include "../algebra/multivariate.h"
#include "../algebra/on_box.h"
#include "../algebra/restriction.h"
#include "lift.h"
#include "zero_on_segment.h"

#include <corral/polynomial/arithmetic.h>
#include <corral/polynomial/square_free.h>

#include <algorithm>
#include <utility>

namespace corral::exact {

namespace {

constexpr std::size_t max_sections = 256; // kept for the neighbours, then forgotten: bounded memory

template <std::size_t D>
Cell_decision<D> empty(Rung rung)
{
  return {Verdict::empty, rung, std::monostate{}, {}};
}

/// Whether a zero of the polynomial in the closed box is excluded by its coefficients.
template <std::size_t D>
bool away_from_zero(const Polynomial<Integer, D>& f, const Rational_box<D>& box)
{
  return !f.is_zero() && sign_pattern(bernstein_form(f, box)).closed() != 0;
}

} // namespace

template <std::size_t D>
Common_zeros<D>::Common_zeros(const Polynomial<Integer, D>& f, const Polynomial<Integer, D>& g, Checkpoint checkpoint,
                              Witnesses witnesses)
    : checkpoint_(std::move(checkpoint)), witnesses_(witnesses)
{
  if (f.is_zero() || g.is_zero()) { // the common zeros are those of the other
    common_ = square_free_part(f.is_zero() ? g : f);
    f_ = g_ = constant<Integer, D>(1);
  } else {
    auto parts = common_factor(square_free_part(f), square_free_part(g));
    common_ = std::move(parts.divisor);
    f_ = std::move(parts.f);
    g_ = std::move(parts.g);
  }
  if (!common_.is_constant())
    common_zeros_ = std::make_unique<Zero_set<D>>([h = common_] { return h; }, checkpoint_, witnesses_);
  if constexpr (D == 2) points_ = std::make_unique<Plane_system>(f_, g_);
}

template <std::size_t D>
Common_zeros<D>::Common_zeros(Common_zeros&&) noexcept = default;
template <std::size_t D>
Common_zeros<D>::~Common_zeros() = default;

template <std::size_t D>
Cell_decision<D> Common_zeros<D>::decide(const Rational_box<D>& box)
{
  if (common_.is_zero()) { // both polynomials are zero
    Rational_point<D> corner;
    for (std::size_t k = 0; k < D; ++k) corner[k] = box[k].lower();
    return {Verdict::hit, Rung::integers, Sign_change<D>{corner, corner}, {}};
  }
  Cell_decision<D> on_common = empty<D>(Rung::integers);
  if (common_zeros_) {
    on_common = common_zeros_->decide(bernstein_form(common_, box), box);
    // A change of sign proves a zero of the common factor, but not in the words of a system.
    if (const auto* change = std::get_if<Sign_change<D>>(&on_common.witness); change && change->first != change->second)
      on_common.witness = witnesses_ == Witnesses::all ? zero_on_segment(common_, *change) : std::monostate{};
    if (on_common.verdict == Verdict::hit) return on_common;
  }
  auto rest = decide_rest(box);
  return rest.verdict == Verdict::empty && on_common.verdict == Verdict::unknown ? on_common : rest;
}

template <std::size_t D>
Cell_decision<D> Common_zeros<D>::decide_rest(const Rational_box<D>& box)
{
  if (away_from_zero(f_, box) || away_from_zero(g_, box)) return empty<D>(Rung::integers);
  if constexpr (D == 2) {
    auto zeros = points_->zeros_in(box, true, witnesses_ == Witnesses::all, checkpoint_);
    if (zeros.empty()) return empty<D>(Rung::algebra);
    if (witnesses_ == Witnesses::simple) return {Verdict::hit, Rung::algebra, std::monostate{}, {}};
    return {Verdict::hit, Rung::algebra, std::move(zeros.front()), {}};
  } else {
    for (std::size_t axis = 0; axis < D; ++axis)
      for (const auto& value : {box[axis].lower(), box[axis].upper()})
        if (auto decision = decide_section(axis, value, box)) return *decision;
    return decide_inside(box);
  }
}

/// The common zeros in one plane: a hit, or nothing if there is none.
template <std::size_t D>
std::optional<Cell_decision<D>> Common_zeros<D>::decide_section(std::size_t axis, const Rational& value,
                                                                const Rational_box<D>& box)
{
  if constexpr (D == 3) {
    if (checkpoint_) checkpoint_();
    if (sections_.size() > max_sections) sections_.clear();
    auto& section = sections_[{axis, value}];
    if (!section)
      section = std::make_unique<Common_zeros<2>>(restriction(f_, axis, value), restriction(g_, axis, value),
                                                  checkpoint_, witnesses_);
    const auto decision = section->decide(side_of<D>(box, axis));
    if (decision.verdict == Verdict::hit)
      return Cell_decision<D>{Verdict::hit, decision.rung, lift<D - 1>(decision.witness, axis, value), {}};
  }
  return std::nullopt;
}

/// No common zero lies on the boundary, so every piece inside is a closed curve or a point.
template <std::size_t D>
Cell_decision<D> Common_zeros<D>::decide_inside(const Rational_box<D>& box)
{
  if constexpr (D == 3) {
    if (!pieces_) pieces_ = std::make_unique<Inner_pieces>(std::vector{f_, g_}, checkpoint_);
    if (pieces_->excluded(box)) return empty<D>(Rung::integers);
    for (std::size_t axis = 0; axis < D; ++axis)
      if (auto decision = decide_section(axis, (box[axis].lower() + box[axis].upper()) / 2, box)) return *decision;
    if (!pieces_->is_feasible())
      return {Verdict::unknown, Rung::algebra, std::monostate{},
              "a closed curve or an isolated point inside the cell was neither found nor excluded, and the degrees are "
              "too high for outlines"};
    if (auto zero = pieces_->zero_in(box)) return {Verdict::hit, Rung::algebra, std::move(*zero), {}};
  }
  return empty<D>(Rung::algebra);
}

template class Common_zeros<2>;
template class Common_zeros<3>;

} // namespace corral::exact
