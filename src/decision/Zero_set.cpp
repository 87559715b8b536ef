// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Zero_set.h"

#include "../algebra/Extreme_points.h"
#include "../algebra/constant_slope.h"
#include "../algebra/definite.h"
#include "../algebra/on_box.h"
#include "../algebra/restriction.h"
#include "../polynomial/to_exponent.h"
#include "corners.h"
#include "lift.h"

#include <corral/polynomial/square_free.h>

#include <algorithm>
#include <cstdint>
#include <mutex>
#include <string>
#include <utility>

namespace corral::exact {

namespace {

constexpr std::size_t max_restrictions = 256; // kept for the neighbours, then forgotten: bounded memory
constexpr std::size_t max_guesses = 16;

/// g without the factors that have one variable only: lines along an axis, which cross the boundary of every box they
/// meet.
Polynomial<Integer, 2> without_axis_lines(Polynomial<Integer, 2> g)
{
  for (const std::size_t main : {1U, 0U}) {
    auto by_main = bivariate(g, main);
    const auto divisor = content(by_main);
    if (degree(divisor) == 0) continue;
    for (auto& c : by_main) c = exact_quotient(c, divisor);
    g = exact::polynomial(by_main, main);
  }
  return g;
}

Cell_decision<1> real_root_in(const Polynomial<Integer, 1>& g, const Rational_interval& side,
                              const Checkpoint& checkpoint)
{
  const auto p = integer_polynomial(transform<Rational>(g, to_rational));
  const auto free = std::make_shared<const Integer_polynomial>(square_free_part(p, checkpoint));
  const auto roots = isolate_simple_roots(free, side, checkpoint);
  if (roots.empty()) return {Verdict::empty, Rung::algebra, std::monostate{}, {}};
  const auto& root = roots.front();
  if (root.is_point()) return {Verdict::hit, Rung::algebra, Sign_change<1>{{root.lower()}, {root.lower()}}, {}};
  Triangular_zero<1> zero;
  std::vector<Polynomial<Rational, 1>::Term> terms;
  for (std::size_t i = 0; i < free->size(); ++i)
    if ((*free)[i] != 0) {
      Rational c((*free)[i], free->lead());
      c.canonicalize();
      terms.push_back({{detail::to_exponent(i)}, c});
    }
  zero.chain[0] = Polynomial<Rational, 1>(std::move(terms));
  zero.box[0] = root.interval();
  return {Verdict::hit, Rung::algebra, std::move(zero), {}};
}

} // namespace

template <std::size_t D>
Zero_set<D>::Zero_set(Source source, Checkpoint checkpoint, Witnesses witnesses)
    : source_(std::move(source)), checkpoint_(std::move(checkpoint)), witnesses_(witnesses)
{}

template <std::size_t D>
Zero_set<D>::~Zero_set() = default;

template <std::size_t D>
const Polynomial<Integer, D>& Zero_set<D>::polynomial()
{
  if (!polynomial_) polynomial_ = source_();
  return *polynomial_;
}

/// Whether it is seen at once that there is no real zero at all.
template <std::size_t D>
bool Zero_set<D>::is_definite()
{
  if constexpr (D > 1) {
    if (checkpoint_) checkpoint_();
    if (!definite_) definite_ = is_square_plus_constant(polynomial());
    return *definite_;
  }
  return false;
}

template <std::size_t D>
bool Zero_set<D>::boundary_suffices()
{
  if (!has_constant_slope_) has_constant_slope_ = D > 1 && has_constant_slope(polynomial());
  return *has_constant_slope_;
}

template <std::size_t D>
Rational_box<D> Zero_set<D>::piece_box(const Search& search, const Piece& piece) const
{
  Rational_box<D> result;
  for (std::size_t k = 0; k < D; ++k) {
    const auto& side = search.box[k];
    const Rational width = (side.upper() - side.lower()) / Rational(Integer(Integer(1) << search.depth));
    const Rational low = side.lower() + width * piece.index[k];
    result[k] = Rational_interval(low, low + width);
  }
  return result;
}

template <std::size_t D>
Cell_decision<D> Zero_set<D>::decide(const Bernstein_form<D>& form, const Rational_box<D>& box)
{
  if (is_known_definite()) return {Verdict::empty, Rung::algebra, std::monostate{}, {}};
  const auto pattern = sign_pattern(form);
  if (pattern.crosses) return {Verdict::hit, Rung::integers, corner_witness(corner_signs(form), box), {}};
  if (pattern.hull != 0) return {Verdict::empty, Rung::integers, Bounded_away{}, {}};
  if (D == 3 && is_definite()) return {Verdict::empty, Rung::algebra, std::monostate{}, {}};
  if (auto zero = zero_on_facets(form, box)) return *zero;
  if (boundary_suffices()) return {Verdict::empty, Rung::integers, Bounded_away{}, {}};
  for (std::size_t axis = 0; axis < D; ++axis)
    if (form.size[axis] > 1 && one_sign_inside(derivative(form, axis)))
      return {Verdict::empty, Rung::integers, No_piece_inside<D>{axis, {box}}, {}};
  Search search{box, pattern.corners, {}, 0};
  search.live.push_back({form, {}});
  const bool dear = form.values.size() > 170; // elimination costs more than many boxes
  if (auto decision = subdivide(search, dear ? 1 : 6, dear ? 20 : 20)) return *decision;
  return decide_by_algebra(search);
}

/// A zero on the boundary. In one and two dimensions a verdict is never unknown, so without one there is none.
template <std::size_t D>
std::optional<Cell_decision<D>> Zero_set<D>::zero_on_facets(const Bernstein_form<D>& form, const Rational_box<D>& box)
{
  if constexpr (D > 1)
    for (std::size_t axis = 0; axis < D; ++axis)
      for (const bool upper : {false, true}) {
        const auto side = facet(form, axis, upper);
        if (sign_pattern(side).hull != 0) continue;
        if (auto zero = zero_in_section(side, axis, upper ? box[axis].upper() : box[axis].lower(), box)) return zero;
      }
  return std::nullopt;
}

/// A zero in the part of a plane (or line) that lies in the box. \param form  the polynomial there.
template <std::size_t D>
std::optional<Cell_decision<D>> Zero_set<D>::zero_in_section(const Bernstein_form<lower_dimension>& form,
                                                             std::size_t axis, const Rational& value,
                                                             const Rational_box<D>& box)
{
  if constexpr (D > 1) {
    if (restrictions_.size() > max_restrictions) restrictions_.clear();
    auto& set = restrictions_[{axis, value}];
    if (!set)
      set = std::make_unique<Zero_set<D - 1>>([this, axis, value] { return restriction(polynomial(), axis, value); },
                                              checkpoint_, witnesses_);
    const auto decision = set->decide(form, side_of<D>(box, axis));
    if (decision.verdict == Verdict::hit)
      return Cell_decision<D>{Verdict::hit, decision.rung, lift<D - 1>(decision.witness, axis, value), {}};
  }
  return std::nullopt;
}

template <std::size_t D>
std::optional<Cell_decision<D>> Zero_set<D>::subdivide(Search& search, unsigned max_depth, std::size_t max_live)
{
  while (search.depth < max_depth && search.live.size() <= max_live) {
    if (checkpoint_) checkpoint_();
    ++search.depth;
    std::vector<Piece> kept;
    for (Piece& parent : search.live) {
      std::vector<Piece> children;
      for (Integer& i : parent.index) i *= 2;
      children.push_back(std::move(parent));
      for (std::size_t axis = 0; axis < D; ++axis)
        for (std::size_t c = children.size(); c-- > 0;) {
          Piece lower{halve(children[c].form, axis), children[c].index};
          ++children[c].index[axis];
          children.push_back(std::move(lower));
        }
      for (Piece& child : children)
        if (auto decision = keep_or_decide(search, std::move(child), kept)) return decision;
    }
    search.live = std::move(kept);
    if (search.live.empty()) return Cell_decision<D>{Verdict::empty, Rung::integers, Bounded_away{}, {}};
    if (auto decision = guess(search)) return decision;
  }
  return std::nullopt;
}

/// A piece can be dropped where the polynomial has no zero, or, as the boundary of the cell has none, where the
/// gradient has none: a zero inside would make the extreme value of the polynomial on the cell a zero or of the other
/// sign, and that value is taken at an inner point, where the gradient vanishes.
template <std::size_t D>
std::optional<Cell_decision<D>> Zero_set<D>::keep_or_decide(Search& search, Piece piece, std::vector<Piece>& kept)
{
  const auto pattern = sign_pattern(piece.form);
  if (pattern.crosses)
    return Cell_decision<D>{
        Verdict::hit, Rung::integers, corner_witness(corner_signs(piece.form), piece_box(search, piece)), {}};
  if (pattern.corners != search.sign)
    return Cell_decision<D>{Verdict::hit,
                            Rung::integers,
                            Sign_change<D>{corner_of(search.box, 0), corner_of(piece_box(search, piece), 0)},
                            {}};
  if (pattern.hull != 0) return std::nullopt;
  for (std::size_t axis = 0; axis < D; ++axis)
    if (piece.form.size[axis] > 1 && sign_pattern(derivative(piece.form, axis)).closed() != 0) return std::nullopt;
  kept.push_back(std::move(piece));
  return std::nullopt;
}

/// An isolated zero is often a simple rational point.
template <std::size_t D>
std::optional<Cell_decision<D>> Zero_set<D>::guess(const Search& search)
{
  if (search.depth < 2 || search.live.size() > max_guesses) return std::nullopt;
  for (const Piece& piece : search.live) {
    const auto box = piece_box(search, piece);
    Rational_point<D> point;
    for (std::size_t k = 0; k < D; ++k) point[k] = simplest_rational(box[k]);
    if (vanishes_at(polynomial(), point))
      return Cell_decision<D>{Verdict::hit, Rung::integers, Sign_change<D>{point, point}, {}};
  }
  return std::nullopt;
}

template <std::size_t D>
Cell_decision<D> Zero_set<D>::decide_by_algebra(Search& search)
{
  if constexpr (D == 1)
    return real_root_in(polynomial(), search.box[0], checkpoint_);
  else if constexpr (D == 2) {
    if (is_definite()) return {Verdict::empty, Rung::algebra, std::monostate{}, {}};
    if (!extremes_) {
      const auto free = without_axis_lines(square_free_part(polynomial()));
      extremes_ = std::make_unique<Plane_system>(free, corral::derivative(free, 1));
    }
    auto zeros = extremes_->zeros_in(search.box, true, witnesses_ == Witnesses::all, checkpoint_);
    if (zeros.empty()) return {Verdict::empty, Rung::algebra, std::monostate{}, {}};
    if (witnesses_ == Witnesses::simple) return {Verdict::hit, Rung::algebra, std::monostate{}, {}};
    return {Verdict::hit, Rung::algebra, std::move(zeros.front()), {}};
  } else {
    if (!pieces_) pieces_ = std::make_unique<Inner_pieces>(std::vector{polynomial()}, checkpoint_);
    if (auto decision = subdivide(search, pieces_->is_feasible() ? 40 : 200, 64)) return *decision;
    if (auto zero = zero_in_middle(search)) return *zero;
    if (!pieces_->is_feasible())
      return {Verdict::unknown, Rung::algebra, std::monostate{},
              "a closed piece inside the cell was neither found nor excluded, and the degree is too high for outlines"};
    auto zero = pieces_->zero_in(search.box);
    if (!zero) return {Verdict::empty, Rung::algebra, std::monostate{}, {}};
    return {Verdict::hit, Rung::algebra, std::move(*zero), {}};
  }
}

/// A zero in the planes through the middle of what subdivision has left, if that is not tiny.
template <std::size_t D>
std::optional<Cell_decision<D>> Zero_set<D>::zero_in_middle(const Search& search)
{
  constexpr int worth = 4; // pieces along an axis
  if constexpr (D == 3)
    for (std::size_t axis = 0; axis < D; ++axis) {
      const auto [first, last] =
          std::minmax_element(search.live.begin(), search.live.end(),
                              [&](const Piece& a, const Piece& b) { return a.index[axis] < b.index[axis]; });
      if (last->index[axis] - first->index[axis] < worth) continue;
      const Rational low = piece_box(search, *first)[axis].upper();
      const Rational high = piece_box(search, *last)[axis].lower();
      const Rational quarter = (high - low) / 4;
      const Rational value = simplest_rational({low + quarter, high - quarter});
      const auto form = bernstein_form(restriction(polynomial(), axis, value), side_of<D>(search.box, axis));
      if (auto zero = zero_in_section(form, axis, value, search.box)) return zero;
    }
  return std::nullopt;
}

template class Zero_set<1>;
template class Zero_set<2>;
template class Zero_set<3>;

} // namespace corral::exact
