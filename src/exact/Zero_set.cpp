// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Zero_set.h"

#include "Shadows.h"
#include "lift.h"

#include <corral/polynomial/evaluate.h>
#include <corral/polynomial/integer_form.h>
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
constexpr std::size_t max_outline_size = 7 * 7 * 7; // coefficients of a sextic

template <std::size_t D>
Rational_point<D> corner_of(const Rational_box<D>& box, unsigned corner)
{
  Rational_point<D> point;
  for (std::size_t k = 0; k < D; ++k) point[k] = (corner >> k & 1) != 0 ? box[k].upper() : box[k].lower();
  return point;
}

/// Two corners with opposite signs, or one that is a zero. \pre The form crosses.
template <std::size_t D>
Sign_change<D> corner_witness(const Bernstein_form<D>& form, const Rational_box<D>& box)
{
  const int sign = sgn(form.corner(0));
  for (unsigned corner = 0; corner < 1U << D; ++corner) {
    const int other = sgn(form.corner(corner));
    if (other == 0) return {corner_of(box, corner), corner_of(box, corner)};
    if (other != sign) return {corner_of(box, 0), corner_of(box, corner)};
  }
  return {};
}

/// g without the factors that have one variable only: lines along an axis, which cross the boundary of every box they
/// meet.
Polynomial<Integer, 2> without_axis_lines(Polynomial<Integer, 2> g)
{
  for (const std::size_t main : {1U, 0U}) {
    auto by_main = bivariate(g, main);
    const auto divisor = content(by_main);
    if (degree(divisor) == 0) continue;
    for (auto& c : by_main)
      if (!c.empty()) c = exact_quotient(c, divisor);
    g = exact::polynomial(by_main, main);
  }
  return g;
}

template <std::size_t D>
bool vanishes_at(const Polynomial<Integer, D>& g, const Rational_point<D>& point)
{
  if constexpr (D == 1)
    return evaluate(transform<Rational>(g, [](const Integer& c) { return Rational(c); }), point) == 0;
  else {
    Rational_point<D - 1> rest;
    std::copy(point.begin() + 1, point.end(), rest.begin());
    return vanishes_at<D - 1>(restriction(g, 0, point[0]), rest);
  }
}

Cell_decision<1> real_root_in(const Polynomial<Integer, 1>& g, const Rational_interval& side,
                              const Checkpoint& checkpoint)
{
  Integer_polynomial p(g.degree(0) + 1U);
  for (const auto& term : g.terms()) p[term.exponents[0]] = term.coefficient;
  const auto free = std::make_shared<const Integer_polynomial>(square_free_part(p));
  const auto roots = isolate_simple_roots(free, side, checkpoint);
  if (roots.empty()) return {Verdict::empty, Rung::algebra, std::monostate{}, {}};
  const auto& root = roots.front();
  if (root.is_point()) return {Verdict::hit, Rung::algebra, Sign_change<1>{{root.lower()}, {root.lower()}}, {}};
  Triangular_zero<1> zero;
  std::vector<Polynomial<Rational, 1>::Term> terms;
  for (std::size_t i = 0; i < free->size(); ++i)
    if ((*free)[i] != 0) {
      Rational c((*free)[i], free->back());
      c.canonicalize();
      terms.push_back({{static_cast<std::uint16_t>(i)}, c});
    }
  zero.chain[0] = Polynomial<Rational, 1>(std::move(terms));
  zero.box[0] = root.interval();
  return {Verdict::hit, Rung::algebra, std::move(zero), {}};
}

} // namespace

std::vector<Integer> bernstein_weights(std::size_t n)
{
  std::vector<Integer> binomials(n + 1);
  Integer common = 1;
  for (std::size_t k = 0; k <= n; ++k) {
    mpz_bin_uiui(binomials[k].get_mpz_t(), n, k);
    common = lcm(common, binomials[k]);
  }
  for (Integer& b : binomials) b = common / b;
  return binomials;
}

template <std::size_t D>
Polynomial<Integer, D - 1> restriction(const Polynomial<Integer, D>& g, std::size_t axis, const Rational& value)
{
  const std::size_t n = g.degree(axis);
  std::vector<Integer> weights(n + 1); // numerator^e * denominator^(n-e)
  Integer numerator_power = 1;
  for (std::size_t e = 0; e <= n; ++e, numerator_power *= value.get_num()) weights[e] = numerator_power;
  Integer denominator_power = 1;
  for (std::size_t e = n + 1; e-- > 0; denominator_power *= value.get_den()) weights[e] *= denominator_power;
  std::vector<typename Polynomial<Integer, D - 1>::Term> terms;
  for (const auto& term : g.terms()) {
    Exponents<D - 1> exponents{};
    for (std::size_t k = 0, to = 0; k < D; ++k)
      if (k != axis) exponents[to++] = term.exponents[k];
    terms.push_back({exponents, Integer(term.coefficient * weights[term.exponents[axis]])});
  }
  return primitive_part(collect<Integer, D - 1>(std::move(terms)));
}

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
  const auto pattern = sign_pattern(form);
  if (pattern.crosses) return {Verdict::hit, Rung::integers, corner_witness(form, box), {}};
  if (pattern.hull != 0) return {Verdict::empty, Rung::integers, Bounded_away{}, {}};
  Search search{box, pattern.corners, true, {}, 0};
  if (auto decision = decide_facets(form, box, search.boundary_clean)) return *decision;
  if (search.boundary_clean)
    for (std::size_t axis = 0; axis < D; ++axis)
      if (form.size[axis] > 1 && one_sign_inside(derivative(form, axis)))
        return {Verdict::empty, Rung::integers, No_piece_inside<D>{axis, {box}}, {}};
  search.live.push_back({form, {}});
  const bool dear = form.values.size() > 170; // elimination costs more than many boxes
  if (auto decision = subdivide(search, dear ? 24 : 6, dear ? 60 : 20)) return *decision;
  return decide_by_algebra(search);
}

template <std::size_t D>
std::optional<Cell_decision<D>> Zero_set<D>::decide_facets(const Bernstein_form<D>& form, const Rational_box<D>& box,
                                                           bool& clean)
{
  if constexpr (D > 1) {
    for (std::size_t axis = 0; axis < D; ++axis)
      for (const bool upper : {false, true}) {
        const auto side = facet(form, axis, upper);
        if (sign_pattern(side).hull != 0) continue;
        const Rational value = upper ? box[axis].upper() : box[axis].lower();
        if (restrictions_.size() > max_restrictions) restrictions_.clear();
        auto& set = restrictions_[{axis, value}];
        if (!set)
          set = std::make_unique<Zero_set<D - 1>>(
              [this, axis, value] { return restriction(polynomial(), axis, value); }, checkpoint_, witnesses_);
        Rational_box<D - 1> side_box;
        for (std::size_t k = 0, to = 0; k < D; ++k)
          if (k != axis) side_box[to++] = box[k];
        const auto decision = set->decide(side, side_box);
        if (decision.verdict == Verdict::hit)
          return Cell_decision<D>{Verdict::hit, decision.rung, lift<D - 1>(decision.witness, axis, value), {}};
        clean = clean && decision.verdict == Verdict::empty;
      }
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

/// A piece can be dropped where the polynomial has no zero, or, if the boundary of the cell has none, where the
/// gradient has none: a zero inside would make the extreme value of the polynomial on the cell a zero or of the other
/// sign, and that value is taken at an inner point, where the gradient vanishes.
template <std::size_t D>
std::optional<Cell_decision<D>> Zero_set<D>::keep_or_decide(Search& search, Piece piece, std::vector<Piece>& kept)
{
  const auto pattern = sign_pattern(piece.form);
  if (pattern.crosses)
    return Cell_decision<D>{Verdict::hit, Rung::integers, corner_witness(piece.form, piece_box(search, piece)), {}};
  if (pattern.corners != search.sign)
    return Cell_decision<D>{Verdict::hit,
                            Rung::integers,
                            Sign_change<D>{corner_of(search.box, 0), corner_of(piece_box(search, piece), 0)},
                            {}};
  if (pattern.hull != 0) return std::nullopt;
  if (search.boundary_clean)
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
    if (!extremes_) {
      const auto free = without_axis_lines(square_free_part(polynomial()));
      extremes_ = std::make_unique<Plane_system>(free, corral::derivative(free, 1));
    }
    auto zeros = extremes_->zeros_in(search.box, true, witnesses_ == Witnesses::all, checkpoint_);
    if (zeros.empty()) return {Verdict::empty, Rung::algebra, std::monostate{}, {}};
    if (witnesses_ == Witnesses::simple) return {Verdict::hit, Rung::algebra, std::monostate{}, {}};
    return {Verdict::hit, Rung::algebra, std::move(zeros.front()), {}};
  } else {
    if (auto decision = subdivide(search, 200, 64)) return *decision;
    if (!search.boundary_clean)
      return {Verdict::unknown, Rung::algebra, std::monostate{},
              "a zero on a facet of the cell was neither found nor excluded"};
    if (search.live.front().form.values.size() > max_outline_size)
      return {Verdict::unknown, Rung::algebra, std::monostate{},
              "a closed piece inside the cell was neither found nor excluded, and the degree is too high for outlines"};
    if (!shadows_) shadows_ = std::make_unique<Shadows>(polynomial(), checkpoint_);
    for (const unsigned more_levels : {0U, 6U}) {
      if (auto decision = subdivide(search, search.depth + more_levels, 2000)) return *decision;
      std::erase_if(search.live, [&](const Piece& piece) { return shadows_->exclude(piece_box(search, piece)); });
      if (search.live.empty()) return {Verdict::empty, Rung::algebra, std::monostate{}, {}};
    }
    return {Verdict::unknown, Rung::algebra, std::monostate{},
            "a singular zero inside the cell was neither found nor excluded"};
  }
}

template class Zero_set<1>;
template class Zero_set<2>;
template class Zero_set<3>;

} // namespace corral::exact
