// SPDX-License-Identifier: LGPL-3.0-or-later
#include "critical.h"

#include <algorithm>

namespace corral_check {
namespace {

/// A face that still has to be halved along the axes below `axis`, or to be read if that is negative.
struct Pending
{
  Face face;
  int axis = -1;
};

Face facet_of(const Face& face, std::size_t axis, bool is_upper, Budget& budget)
{
  Face result{facet(face.form, axis, is_upper, budget), face.box, face.polynomial, face.depth + 1, face.held};
  auto& side = result.box[axis];
  (is_upper ? side.lower : side.upper) = is_upper ? side.upper : side.lower;
  return result;
}

} // namespace

void require_branch(std::size_t depth, double held, const Place& place)
{
  limit(depth <= max_nodes_of_branch, place, "more than 1100 nodes lie one within another");
  Budget::require_form_words(held);
}

Critical_proofs::Critical_proofs(const Contents& contents, Budget& budget) : contents_(contents), budget_(budget)
{
  if (contents.critical) entries_.emplace(*contents.critical, "critical");
}

bool Critical_proofs::all_used()
{
  Value left;
  return !entries_ || !entries_->next(left);
}

Value Critical_proofs::next(const Place& leaf)
{
  require(entries_.has_value(), leaf, "c has no place in version 1");
  Value entry;
  require(entries_->next(entry), leaf, "there is no entry of critical left");
  ++used_;
  return entry;
}

const Multipliers& Critical_proofs::multipliers(const Value& entry, const std::string& where) const
{
  const auto& all = contents_.multipliers;
  require(!all.empty(), entry.place(where), "there are no multipliers");
  return all[entry.list(3, where)[0].number(0, all.size() - 1, where)];
}

void Critical_proofs::prove(const std::vector<Face>& faces, const Place& leaf)
{
  const Value entry = next(leaf);
  const std::string where = "critical[" + std::to_string(used_ - 1) + "] (" + leaf.words + ")";
  const auto& m = multipliers(entry, where);
  require(m.of < faces.size(), entry.place(where), "the multipliers are of another polynomial");
  prove(faces[m.of], entry, where);
}

/// Another polynomial on the same box.
Face Critical_proofs::face_of(std::size_t polynomial, const Face& face)
{
  Polynomial p = contents_.proved[polynomial];
  const Exponents highest = degrees(p);
  for (std::size_t axis = 0; axis < face.box.size(); ++axis)
    if (face.box[axis].is_flat() && highest[axis] > 0) p = restrict_to(p, axis, face.box[axis].lower, budget_);
  require(!p.empty(), {"critical"}, "a factor is zero on a whole face");
  return {bernstein(p, face.box, budget_), face.box, polynomial, face.depth + 1, face.held};
}

void Critical_proofs::prove(const Face& face, const Value& entry, const std::string& where)
{
  const Place place = entry.place(where);
  const auto parts = entry.list(3, where);
  const Multipliers& m = multipliers(entry, where);
  require(m.of == face.polynomial, place, "the multipliers are of another polynomial");
  const std::size_t h = parts[1].number(0, face.box.size() - 1, where);
  require(!m.slopes[h], place, "the axis is one of a derivative");
  const std::string trees = parts[2].string(where);
  std::size_t position = 0;
  for (std::size_t axis = 0; axis < face.box.size(); ++axis) {
    if (axis != h && !m.slopes[axis]) continue;
    require(face.form.is_free(axis), place, "an axis is not free");
    prove_tree(facet_of(face, axis, false, budget_), trees, position, place);
    if (m.slopes[axis]) prove_tree(facet_of(face, axis, true, budget_), trees, position, place);
  }
  for (const std::size_t factor : m.factors) prove_tree(face_of(factor, face), trees, position, place);
  require(position == trees.size(), place, "a tree continues after its end");
}

void Critical_proofs::prove_tree(Face root, const std::string& tree, std::size_t& position, const Place& place)
{
  root.held += held_by(root.form);
  require_branch(root.depth, root.held, place);
  std::vector<Pending> stack;
  stack.push_back({std::move(root)});
  while (!stack.empty()) {
    Pending pending = std::move(stack.back());
    stack.pop_back();
    Face& face = pending.face;
    if (pending.axis >= 0) {
      const auto axis = static_cast<std::size_t>(pending.axis--);
      if (face.form.is_free(axis)) {
        Pending upper{{{}, face.box, face.polynomial, face.depth, face.held}, pending.axis};
        std::tie(face.form, upper.face.form) = halve(face.form, axis, budget_);
        const mpq_class middle = (face.box[axis].lower + face.box[axis].upper) / 2;
        face.box[axis].upper = upper.face.box[axis].lower = middle;
        stack.push_back(std::move(upper));
      }
      stack.push_back(std::move(pending));
      continue;
    }
    require(position < tree.size(), place, "a tree ends too early");
    const char symbol = tree[position++];
    budget_.work(static_cast<double>(face.form.coefficients.size()));
    if (symbol == 'e') {
      require(excludes_zero(face.form), place, "the Bernstein coefficients do not exclude a zero");
    } else if (symbol == 'c') {
      const Value entry = next(place);
      prove(face, entry, "critical[" + std::to_string(used_ - 1) + "] (within another)");
    } else {
      require(symbol == 's', place, "a character of the tree of a face is none of s, e, c");
      Bernstein_form child{face.form.sizes, {}, face.form.bit_bound};
      bool is_free = false;
      for (std::size_t axis = 0; axis < face.box.size(); ++axis) {
        is_free = is_free || face.form.is_free(axis);
        child.bit_bound += static_cast<double>(face.form.sizes[axis] - 1);
      }
      require(is_free, place, "a point cannot be split");
      face.held += static_cast<double>(face.box.size() + 1) * static_cast<double>(face.form.coefficients.size())
                   * (words(child.bit_bound) + 5);
      require_branch(++face.depth, face.held, place);
      pending.axis = static_cast<int>(face.box.size()) - 1;
      stack.push_back(std::move(pending));
    }
  }
}

} // namespace corral_check
