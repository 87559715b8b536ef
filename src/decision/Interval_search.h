// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_DECISION_INTERVAL_SEARCH_H
#define CORRAL_SRC_DECISION_INTERVAL_SEARCH_H

#include "Interval_jet.h"
#include "lift.h"

#include <corral/number/Outward_interval.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

/// \file
/// Steps 2 to 5 of the exact decision (doc/exact.md) over an interval number: what they decide where rounding leaves
/// the signs clear.
namespace corral::exact {

/// What a search of the unit box for a zero has found.
template <std::size_t D>
struct Finding
{
  enum class Kind : std::uint8_t { none, crossing, unclear };
  Kind kind = Kind::unclear;
  Rational_point<D> point{};           ///< where the polynomial has the sign opposite to the corners'
  std::vector<Rational_box<D>> left{}; ///< the unclear parts, if the boundary is clear
};

/// How far a search goes.
struct Search_limits
{
  unsigned depth = 10;            ///< halvings of each axis
  std::size_t pieces = 48;        ///< of one level
  bool boundary_suffices = false; ///< whether the polynomial has its least values on the boundary of every box
};

/// The part of a jet on one facet of the box.
template <IntervalNumber I, std::size_t D>
[[nodiscard]] Interval_jet<I, D - 1> facet(const Interval_jet<I, D>& jet, std::size_t axis, bool upper)
{
  Interval_jet<I, D - 1> result;
  for (std::size_t k = 0, to = 0; k < D; ++k)
    if (k != axis) result.size[to++] = jet.size[k];
  for (std::size_t part = 0, to = 0; part <= D; ++part) {
    if (part == axis + 1) continue;
    auto& values = result.values[to++];
    for_each_line(jet.size, axis, [&](std::size_t first, std::size_t stride) {
      values.push_back(jet.values[part][first + (upper ? stride * (jet.size[axis] - 1) : 0)]);
    });
  }
  return result;
}

/// \brief de Casteljau at 1/2 along one axis: `jet` becomes the upper half, the lower one is returned. The derivatives
/// keep their scale. Sums are halved at last, and not at each step.
template <IntervalNumber I, std::size_t D>
[[nodiscard]] Interval_jet<I, D> halve(Interval_jet<I, D>& jet, std::size_t axis, const I& half)
{
  Interval_jet<I, D> lower = jet;
  const std::size_t n = jet.size[axis] - 1;
  std::vector<I> scale{I(1)}; // powers of 1/2
  while (scale.size() <= n) scale.push_back(scale.back() * half);
  for (std::size_t part = 0; part <= D; ++part) {
    if (jet.values[part].empty()) continue; // not asked for
    for_each_line(jet.size, axis, [&](std::size_t first, std::size_t stride) {
      I* c = &jet.values[part][first];
      for (std::size_t k = 1; k <= n; ++k) {
        for (std::size_t i = 0; i + k <= n; ++i) c[i * stride] += c[(i + 1) * stride];
        lower.values[part][first + k * stride] = c[0] * scale[k];
      }
      for (std::size_t i = 0; i < n; ++i) c[i * stride] *= scale[n - i];
    });
  }
  return lower;
}

/// A number near an interval. Only directions to try are made of it.
template <IntervalNumber I>
[[nodiscard]] double roughly(const I& x)
{
  const auto lower = exact_lower(x);
  return lower ? lower->get_d() : 0;
}
[[nodiscard]] inline double roughly(const Outward_interval& x) { return (x.lower() + x.upper()) / 2; }

/// \brief The direction in which the derivative is most likely to keep one sign: the mean of the gradient's
/// coefficients is large there, and their spread small (Fisher's discriminant, by elimination).
/// \param noise  how much of the whole spread is added in every direction.
template <IntervalNumber I, std::size_t D>
[[nodiscard]] std::array<double, D> steadiest_direction(const Interval_jet<I, D>& jet, double noise)
{
  const std::size_t count = jet.values[0].size();
  std::array<double, D> direction{}; // the mean, then the solution of covariance * direction = mean
  std::array<std::array<double, D>, D> covariance{};
  std::vector<std::array<double, D>> gradients(count);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < D; ++k)
      direction[k] += (gradients[i][k] = roughly(jet.values[k + 1][i])) / static_cast<double>(count);
  double trace = 0;
  for (const auto& gradient : gradients)
    for (std::size_t k = 0; k < D; ++k) {
      for (std::size_t l = 0; l < D; ++l)
        covariance[k][l] += (gradient[k] - direction[k]) * (gradient[l] - direction[l]);
      trace += (gradient[k] - direction[k]) * (gradient[k] - direction[k]);
    }
  for (std::size_t k = 0; k < D; ++k) covariance[k][k] += noise * trace;
  for (std::size_t k = 0; k < D; ++k) // positive definite: no pivots
    for (std::size_t l = 0; l < D; ++l) {
      if (l == k) continue;
      const double factor = covariance[l][k] / covariance[k][k];
      for (std::size_t m = k; m < D; ++m) covariance[l][m] -= factor * covariance[k][m];
      direction[l] -= factor * direction[k];
    }
  for (std::size_t k = 0; k < D; ++k) direction[k] /= covariance[k][k];
  return direction;
}

/// Whether the derivative along a direction has one strict sign on the box.
template <IntervalNumber I, std::size_t D>
[[nodiscard]] bool has_slope_along(const Interval_jet<I, D>& jet, const std::array<double, D>& direction)
{
  double largest = 0;
  for (const double d : direction) largest = std::max(largest, std::fabs(d));
  if (!(largest > 0 && std::isfinite(largest))) return false;
  std::array<I, D> factor;
  for (std::size_t k = 0; k < D; ++k) factor[k] = enclose<I>(Rational(direction[k] / largest));
  std::vector<I> slope(jet.values[0].size(), I(0));
  for (std::size_t i = 0; i < slope.size(); ++i)
    for (std::size_t k = 0; k < D; ++k) slope[i] += jet.values[k + 1][i] * factor[k];
  return common_sign(slope) != 0;
}

/// Whether a derivative along some direction has one strict sign on the box.
template <IntervalNumber I, std::size_t D>
[[nodiscard]] bool has_slope(const Interval_jet<I, D>& jet)
{
  for (std::size_t k = 0; k < D; ++k)
    if (common_sign(jet.values[k + 1]) != 0) return true;
  if constexpr (D > 1)
    for (const double noise : {1e-9, 1e-14}) // the second where there is no spread at all along the bottom of a valley
      if (has_slope_along(jet, steadiest_direction(jet, noise))) return true;
  return false;
}

/// A box of 2^-depth of the unit box.
template <IntervalNumber I, std::size_t D>
struct Interval_piece
{
  Interval_jet<I, D> jet;
  std::array<unsigned, D> index{};
};

/// A corner with the opposite sign.
template <IntervalNumber I, std::size_t D>
[[nodiscard]] std::optional<Rational_point<D>> opposite_corner(const Interval_piece<I, D>& piece, unsigned depth,
                                                               int sign)
{
  for (unsigned corner = 0; corner < 1U << D; ++corner)
    if (strict_sign(piece.jet.corner(corner)) == -sign) {
      Rational_point<D> point;
      for (std::size_t k = 0; k < D; ++k) {
        point[k] = piece.index[k] + (corner >> k & 1);
        mpq_div_2exp(point[k].get_mpq_t(), point[k].get_mpq_t(), depth);
      }
      return point;
    }
  return std::nullopt;
}

template <IntervalNumber I, std::size_t D>
[[nodiscard]] std::vector<Interval_piece<I, D>> split(Interval_piece<I, D> parent)
{
  const I half = enclose<I>(Rational(1, 2));
  for (unsigned& i : parent.index) i *= 2;
  std::vector<Interval_piece<I, D>> children;
  children.push_back(std::move(parent));
  for (std::size_t axis = 0; axis < D; ++axis) {
    if (children.front().jet.size[axis] == 1) continue; // the same on both halves
    for (std::size_t c = children.size(); c-- > 0;) {
      Interval_piece<I, D> lower{halve(children[c].jet, axis, half), children[c].index};
      ++children[c].index[axis];
      children.push_back(std::move(lower));
    }
  }
  return children;
}

template <IntervalNumber I, std::size_t D>
[[nodiscard]] std::vector<Rational_box<D>> boxes(const std::vector<Interval_piece<I, D>>& pieces, unsigned depth)
{
  const auto at = [depth](unsigned i) {
    Rational result = i;
    mpq_div_2exp(result.get_mpq_t(), result.get_mpq_t(), depth);
    return result;
  };
  std::vector<Rational_box<D>> result(pieces.size());
  for (std::size_t p = 0; p < pieces.size(); ++p)
    for (std::size_t k = 0; k < D; ++k) {
      const bool whole = pieces[p].jet.size[k] == 1;
      result[p][k] =
          whole ? Rational_interval(0, 1) : Rational_interval(at(pieces[p].index[k]), at(pieces[p].index[k] + 1));
    }
  return result;
}

/// \brief Looks for a zero in the closed unit box.
/// \param sign  the strict sign of the polynomial at every corner.
///
/// The boundary first. If it has no zero, the least value times `sign` is taken where the gradient vanishes if it is
/// not positive, so that parts with a slope may be dropped.
template <IntervalNumber I, std::size_t D>
[[nodiscard]] Finding<D> look_for_zero(Interval_jet<I, D> jet, int sign, const Search_limits& limits)
{
  using Kind = typename Finding<D>::Kind;
  if (common_sign(jet.values[0]) == sign) return {Kind::none, {}, {}};
  if constexpr (D > 1)
    for (std::size_t axis = 0; axis < D; ++axis)
      for (const bool upper : {false, true}) {
        const auto side = look_for_zero<I, D - 1>(facet(jet, axis, upper), sign, {limits.depth, limits.pieces});
        if (side.kind == Finding<D - 1>::Kind::unclear) return {};
        if (side.kind == Finding<D - 1>::Kind::crossing)
          return {Kind::crossing, insert<D - 1>(side.point, axis, upper ? 1 : 0), {}};
      }
  if (limits.boundary_suffices && D > 1) return {Kind::none, {}, {}};
  std::vector<Interval_piece<I, D>> live(1);
  live[0].jet = std::move(jet);
  for (unsigned depth = 0;; ++depth) {
    std::erase_if(live, [&](const Interval_piece<I, D>& piece) {
      return common_sign(piece.jet.values[0]) == sign || has_slope(piece.jet);
    });
    if (live.empty()) return {Kind::none, {}, {}};
    if (depth == limits.depth || live.size() > limits.pieces) return {Kind::unclear, {}, boxes(live, depth)};
    std::vector<Interval_piece<I, D>> next;
    for (auto& parent : live)
      for (auto& child : split(std::move(parent))) {
        if (auto point = opposite_corner(child, depth + 1, sign)) return {Kind::crossing, std::move(*point), {}};
        next.push_back(std::move(child));
      }
    live = std::move(next);
  }
}

} // namespace corral::exact

#endif
