// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Extreme_points.h"

#include "Fibre.h"
#include "multivariate.h"
#include "on_box.h"

#include <corral/polynomial/arithmetic.h>
#include <corral/polynomial/square_free.h>

#include <algorithm>
#include <set>
#include <utility>

namespace corral::exact {

namespace {

// The highest degrees for which resultants take minutes at most.
constexpr unsigned max_outline_degree = 42; // that of a dense septic surface
constexpr unsigned max_sparse_outline_degree = 128;
constexpr std::size_t max_sparse_terms = 32;

using Space_polynomial = Polynomial<Integer, 3>;
using Plane_polynomial = Polynomial<Integer, 2>;

/// The highest degree in the first two variables together.
unsigned lower_degree(const Space_polynomial& f)
{
  unsigned highest = 0;
  for (const auto& term : f.terms()) highest = std::max<unsigned>(highest, term.exponents[0] + term.exponents[1]);
  return highest;
}

/// A bound for the degree of the resultant with respect to the last variable.
unsigned resultant_degree(const Space_polynomial& f, const Space_polynomial& g)
{
  return std::min(f.total_degree() * g.total_degree(), g.degree(2) * lower_degree(f) + f.degree(2) * lower_degree(g));
}

template <class P>
P renamed(const P& f, const std::array<std::size_t, 3>& from)
{
  auto terms = f.terms();
  for (auto& term : terms) {
    const auto exponents = term.exponents;
    for (std::size_t k = 0; k < 3; ++k) term.exponents[k] = exponents[from[k]];
  }
  return collect<typename P::Coefficient, 3>(std::move(terms));
}

/// The coefficients of the powers of the last variable, those that are not zero.
std::vector<Plane_polynomial> coefficients(const Space_polynomial& f)
{
  std::vector<std::vector<Plane_polynomial::Term>> terms(f.degree(2) + 1U);
  for (const auto& term : f.terms())
    terms[term.exponents[2]].push_back({{term.exponents[0], term.exponents[1]}, term.coefficient});
  std::vector<Plane_polynomial> result;
  for (auto& list : terms)
    if (!list.empty()) result.push_back(collect<Integer, 2>(std::move(list)));
  return result;
}

/// f without the factors in which the last variable does not occur. \pre f is square-free.
Space_polynomial without_cylinders(const Space_polynomial& f)
{
  const auto slope = derivative(f, 2);
  return slope.is_zero() ? constant<Integer, 3>(1) : common_factor(f, slope).f;
}

/// A bound for the degree of F, to choose the variable that is eliminated.
unsigned outline_degree(const std::vector<Space_polynomial>& system)
{
  unsigned sum = 0;
  for (const auto& f : system) {
    sum += resultant_degree(f, derivative(f, 2));
    if (system.size() > 1)
      for (const auto& c : coefficients(f)) sum += c.total_degree();
  }
  return system.size() > 1 ? sum + resultant_degree(system[0], system[1]) : sum;
}

/// The square-free product of all that has to keep its order for the zeros over a piece of the plane to be graphs.
Plane_polynomial outline(const std::vector<Space_polynomial>& system, const Checkpoint& checkpoint)
{
  auto result = constant<Integer, 2>(1);
  const auto include = [&](const Plane_polynomial& factor) {
    if (checkpoint) checkpoint();
    if (factor.is_zero()) throw Wrong_answer("algebra: factors that FLINT gives as irreducible and different are not");
    const auto free = square_free_part(factor);
    result = result * common_factor(free, result).f;
  };
  std::vector<Space_polynomial> free;
  for (const auto& f : system) {
    free.push_back(without_cylinders(f));
    if (system.size() > 1) // one that is zero all over a line is no obstacle for the other
      for (const auto& c : coefficients(f)) include(c);
    if (free.back().degree(2) > 0) include(resultant(free.back(), derivative(free.back(), 2)));
  }
  if (system.size() > 1 && free[0].degree(2) > 0 && free[1].degree(2) > 0) include(resultant(free[0], free[1]));
  return result;
}

/// A part of the box with the conditions on it.
struct Piece
{
  std::vector<Bernstein_form<3>> forms;
  Rational_box<3> box;
};

bool may_vanish(const Piece& piece)
{
  return std::none_of(piece.forms.begin(), piece.forms.end(),
                      [](const Bernstein_form<3>& form) { return sign_pattern(form).closed() != 0; });
}

void split(Piece parent, std::vector<Piece>& kept)
{
  std::vector<Piece> children;
  children.push_back(std::move(parent));
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t c = children.size(); c-- > 0;) {
      Piece lower{{}, children[c].box};
      for (auto& form : children[c].forms) lower.forms.push_back(halve(form, axis));
      const auto& side = children[c].box[axis];
      const Rational middle = (side.lower() + side.upper()) / 2;
      lower.box[axis] = Rational_interval(side.lower(), middle);
      children[c].box[axis] = Rational_interval(middle, side.upper());
      children.push_back(std::move(lower));
    }
  std::copy_if(std::make_move_iterator(children.begin()), std::make_move_iterator(children.end()),
               std::back_inserter(kept), may_vanish);
}

} // namespace

Extreme_points::Extreme_points(std::vector<Space_polynomial> system, Checkpoint checkpoint)
    : system_(std::move(system)), checkpoint_(std::move(checkpoint))
{
  for (std::size_t axis = 0; axis < 3; ++axis)
    cylinder_ = cylinder_ || std::all_of(system_.begin(), system_.end(), [&](const Space_polynomial& f) {
                  return f.degree(axis) == 0;
                });
  constexpr std::array<std::array<std::size_t, 3>, 3> orders = {{{0, 1, 2}, {0, 2, 1}, {1, 2, 0}}};
  unsigned lowest = 0;
  Forms best;
  for (const auto& order : orders) {
    Forms candidate;
    for (const auto& f : system_) candidate.push_back(renamed(f, order));
    const unsigned degree = outline_degree(candidate);
    if (!best.empty() && degree >= lowest) continue;
    lowest = degree;
    order_ = order;
    best = std::move(candidate);
  }
  system_ = std::move(best);
  std::size_t terms = 0;
  for (const auto& f : system_) terms += f.terms().size();
  feasible_ = lowest <= (terms <= max_sparse_terms ? max_sparse_outline_degree : max_outline_degree);
}

/// On a surface the gradient is parallel to the direction d, so d x grad f = 0; on a curve d lies in the plane of the
/// two gradients.
Extreme_points::Forms Extreme_points::conditions(const std::array<long, 3>& direction) const
{
  const auto times = [](long factor, const Space_polynomial& f) { return constant<Integer, 3>(Integer(factor)) * f; };
  const auto& f = system_.front();
  const auto& g = system_.back();
  Forms result = system_;
  auto minors = constant<Integer, 3>(0);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3;
    const std::size_t j = (k + 2) % 3;
    if (system_.size() == 1)
      result.push_back(times(direction[i], derivative(f, j)) - times(direction[j], derivative(f, i)));
    else
      minors = minors + times(direction[k], derivative(f, i) * derivative(g, j) - derivative(f, j) * derivative(g, i));
  }
  if (system_.size() > 1) result.push_back(std::move(minors));
  std::erase_if(result, [](const Space_polynomial& form) { return form.is_zero(); });
  return result;
}

std::vector<Rational_box<3>> Extreme_points::boxes_with_zero(const Forms& forms, const Rational_box<3>& box,
                                                             unsigned max_depth, std::size_t max_live) const
{
  std::vector<Piece> live(1);
  live[0].box = box;
  for (const auto& form : forms) live[0].forms.push_back(bernstein_form(form, box));
  std::erase_if(live, [](const Piece& piece) { return !may_vanish(piece); });
  for (unsigned depth = 0; depth < max_depth && !live.empty() && live.size() <= max_live; ++depth) {
    if (checkpoint_) checkpoint_();
    std::vector<Piece> kept;
    for (Piece& piece : live) split(std::move(piece), kept);
    live = std::move(kept);
  }
  std::vector<Rational_box<3>> result;
  result.reserve(live.size());
  for (const Piece& piece : live) result.push_back(piece.box);
  return result;
}

bool Extreme_points::excluded(const Rational_box<3>& box)
{
  if (cylinder_) return true;
  const Rational_box<3> turned = {box[order_[0]], box[order_[1]], box[order_[2]]};
  constexpr unsigned max_depth = 7;
  constexpr std::size_t max_live = 96;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (along_axis_[axis].empty()) {
      std::array<long, 3> direction{};
      direction[axis] = 1;
      along_axis_[axis] = conditions(direction);
    }
    if (boxes_with_zero(along_axis_[axis], turned, max_depth, max_live).empty()) return true;
  }
  return false;
}

/// F and the derivative along x + t y = const, for the first t for which F has no line in that direction.
void Extreme_points::eliminate()
{
  if (below_) return;
  const auto f = outline(system_, checkpoint_);
  for (long t = 0;; t = t > 0 ? -t : 1 - t) {
    const auto slope = derivative(f, 1) - constant<Integer, 2>(Integer(t)) * derivative(f, 0);
    if (!f.is_constant() && (slope.is_zero() || !common_factor(f, slope).divisor.is_constant())) continue;
    along_t_ = conditions({1, t, 0});
    below_ = std::make_unique<Plane_system>(f, slope);
    return;
  }
}

std::optional<Triangular_zero<3>> Extreme_points::zero_in(const Rational_box<3>& box)
{
  if (cylinder_) return std::nullopt;
  eliminate();
  constexpr unsigned max_depth = 24;
  constexpr std::size_t max_live = 48;
  const Rational_box<3> turned = {box[order_[0]], box[order_[1]], box[order_[2]]};
  std::set<std::array<Rational, 4>> done;
  for (const auto& piece : boxes_with_zero(along_t_, turned, max_depth, max_live)) {
    if (!done.insert({piece[0].lower(), piece[0].upper(), piece[1].lower(), piece[1].upper()}).second) continue;
    for (const auto& point : below_->zeros_in({piece[0], piece[1]}, false, true, checkpoint_)) {
      auto zero = Fibre(point).zero_in(system_, turned[2], checkpoint_);
      if (!zero) continue;
      Triangular_zero<3> result;
      std::array<std::size_t, 3> inverse{};
      for (std::size_t k = 0; k < 3; ++k) inverse[order_[k]] = k;
      for (std::size_t k = 0; k < 3; ++k) {
        result.order[k] = order_[k];
        result.chain[k] = renamed(zero->chain[k], inverse);
        result.box[order_[k]] = zero->box[k];
      }
      return result;
    }
  }
  return std::nullopt;
}

Inner_pieces::Inner_pieces(const std::vector<Space_polynomial>& system, const Checkpoint& checkpoint)
{
  for (const auto& f : irreducible_factors(system.front())) {
    if (system.size() == 1) {
      parts_.emplace_back(std::vector{f}, checkpoint);
      continue;
    }
    for (const auto& g : irreducible_factors(system.back())) parts_.emplace_back(std::vector{f, g}, checkpoint);
  }
}

bool Inner_pieces::excluded(const Rational_box<3>& box)
{
  return std::all_of(parts_.begin(), parts_.end(), [&](Extreme_points& part) { return part.excluded(box); });
}

bool Inner_pieces::is_feasible() const
{
  return std::all_of(parts_.begin(), parts_.end(), [](const Extreme_points& part) { return part.is_feasible(); });
}

std::optional<Triangular_zero<3>> Inner_pieces::zero_in(const Rational_box<3>& box)
{
  for (auto& part : parts_)
    if (auto zero = part.zero_in(box)) return zero;
  return std::nullopt;
}

} // namespace corral::exact
