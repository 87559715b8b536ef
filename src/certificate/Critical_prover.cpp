// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Critical_prover.h"

#include "../algebra/cofactors.h"

#include <corral/errors.h>
#include <corral/polynomial/arithmetic.h>

#include <algorithm>
#include <array>

namespace corral::certificate {
namespace {

constexpr std::size_t max_depth = 1000;
constexpr std::size_t max_factor_boxes = 512;
constexpr double max_effort = 1e10;

/// Whether the format can hold it.
template <std::size_t D>
bool fits(const Polynomial<Integer, D>& f)
{
  double dense = 1;
  for (std::size_t axis = 0; axis < D; ++axis) {
    if (f.degree(axis) > 1000) return false;
    dense *= f.degree(axis) + 1;
  }
  constexpr double digits_of_a_word = 19.3;
  constexpr double max_words = 4194304;
  const double words_of_longest = longest(f);
  return dense <= 65536 && words_of_longest * digits_of_a_word < 100000
         && static_cast<double>(f.terms().size()) * (words_of_longest + 20) < max_words;
}

/// An upper bound for the work of a product of two polynomials, or of a division with this divisor and quotient.
template <std::size_t D>
double product_work(const Polynomial<Integer, D>& f, const Polynomial<Integer, D>& g)
{
  const double word_count = longest(f) + longest(g);
  return static_cast<double>(f.terms().size()) * static_cast<double>(g.terms().size())
         * (fraction_cost(word_count) + fraction_cost(word_count + 2));
}

/// The bytes and values of two polynomials in a file, at most.
template <std::size_t D>
Proof_size text_size(const Polynomial<Integer, D>& f, const Polynomial<Integer, D>& g)
{
  const auto terms = static_cast<double>(f.terms().size() + g.terms().size());
  return {0, terms * (20 * std::max(longest(f), longest(g)) + 6 * D), terms * (D + 2) + 10};
}

} // namespace

template <std::size_t D>
Critical_prover<D>::Critical_prover(std::vector<Polynomial<Integer, D>> given, Checkpoint checkpoint)
    : checkpoint_(std::move(checkpoint))
{
  for (auto& f : given) polynomials_.push_back(std::make_shared<const Polynomial<Integer, D>>(std::move(f)));
}

template <std::size_t D>
std::optional<Proof_part> Critical_prover<D>::prove(Face<D> face, std::size_t boxes)
{
  Search search{boxes, max_effort};
  return prove_tree(std::move(face), search, true);
}

/// A face whose words are already part of its branch.
template <std::size_t D>
std::optional<Proof_part> Critical_prover<D>::prove_tree(Face<D> face, Search& search, bool is_main)
{
  if (checkpoint_) checkpoint_();
  const double size = face.form.size();
  search.effort -= size;
  const auto signs = exact::sign_pattern(face.form.form);
  if (signs.closed() != 0) return Proof_part{"e", {}, size};
  if (signs.crosses || search.effort < 0 || face.depth >= max_depth) return std::nullopt;
  if (face.form.free_axes() > 1)
    for (std::size_t axis = 0; axis < D; ++axis)
      if (face.form.is_free(axis))
        if (auto part = prove_critical(face, axis, search)) {
          part->work += size;
          return part;
        }
  const std::size_t children = std::size_t{1} << (is_main ? D : face.form.free_axes());
  if (children == 1 || search.boxes < children) return std::nullopt;
  search.boxes -= children;
  ++face.depth;
  Counted_form<D> child{{face.form.form.size, {}}, face.form.bit_bound};
  for (const std::size_t n : face.form.form.size) child.bit_bound += static_cast<double>(n - 1);
  face.held += (D + 1) * size * (words(child.bit_bound) + 5);
  if (face.held > max_branch_words) return std::nullopt;
  auto below = prove_split(std::move(face), search, D, is_main);
  if (!below) return std::nullopt;
  Proof_part part{"s", {}, size};
  part.append(std::move(*below));
  return part;
}

template <std::size_t D>
std::optional<Proof_part> Critical_prover<D>::prove_split(Face<D> face, Search& search, std::size_t axes, bool is_main)
{
  if (axes == 0) return prove_tree(std::move(face), search, is_main);
  const std::size_t axis = axes - 1;
  if (!is_main && !face.form.is_free(axis)) return prove_split(std::move(face), search, axis, is_main);
  double work = 0;
  const Rational middle = (face.box[axis].lower() + face.box[axis].upper()) / 2;
  Face<D> lower{halve(face.form, axis, work), face.box, face.polynomial, face.held, face.depth};
  lower.box[axis] = Rational_interval(face.box[axis].lower(), middle);
  face.box[axis] = Rational_interval(middle, face.box[axis].upper());
  search.effort -= work;
  auto first = prove_split(std::move(lower), search, axis, is_main);
  if (!first) return std::nullopt;
  auto second = prove_split(std::move(face), search, axis, is_main);
  if (!second) return std::nullopt;
  first->work += work;
  first->append(std::move(*second));
  return first;
}

template <std::size_t D>
std::optional<Proof_part> Critical_prover<D>::prove_factors(const Face<D>& face, const Critical_entry<D>& entry,
                                                            Search& search)
{
  Proof_part result;
  for (const auto& [number, exponent, polynomial] : entry.factors) {
    double work = 0;
    Face<D> factor{counted_form(*polynomial, face.box, work), face.box, number, face.held, face.depth + 1};
    factor.held += factor.form.held();
    search.effort -= work;
    if (factor.held > max_branch_words) return std::nullopt;
    Search part{std::min(search.boxes, max_factor_boxes), search.effort};
    auto proof = prove_tree(std::move(factor), part, false);
    search.effort = part.effort;
    if (!proof) return std::nullopt;
    result.append(std::move(*proof));
    result.work += work;
  }
  return result;
}

template <std::size_t D>
std::optional<Proof_part> Critical_prover<D>::prove_facet(const Face<D>& face, std::size_t axis, bool upper,
                                                          Search& search)
{
  double work = 0;
  Face<D> side{facet(face.form, axis, upper, work), face.box, face.polynomial, face.held, face.depth + 1};
  side.box[axis] = Rational_interval(upper ? face.box[axis].upper() : face.box[axis].lower());
  side.held += side.form.held();
  if (side.held > max_branch_words) return std::nullopt;
  auto result = prove_tree(std::move(side), search, false);
  if (result) result->work += work;
  return result;
}

/// The factors are tried first, since they fail most often; the file has them last.
template <std::size_t D>
std::optional<Proof_part> Critical_prover<D>::prove_critical(const Face<D>& face, std::size_t axis, Search& search)
{
  const auto index = entry_for(face.polynomial, axis);
  if (!index) return std::nullopt;
  const auto entry = entries_[*index]; // it outlives the vector's growth
  const auto factors = prove_factors(face, *entry, search);
  if (!factors) return std::nullopt;
  const auto lower = prove_facet(face, axis, false, search);
  const auto upper = lower ? prove_facet(face, axis, true, search) : std::nullopt;
  if (!upper) return std::nullopt;
  for (std::size_t h = 0; h < D; ++h) {
    if (h == axis || !face.form.is_free(h)) continue;
    const auto start = prove_facet(face, h, false, search);
    if (!start) continue;
    Proof_part trees;
    if (h < axis) trees.append(*start);
    trees.append(*lower);
    trees.append(*upper);
    if (h > axis) trees.append(*start);
    trees.append(*factors);
    Proof_part result{"c", {{*index, h, std::move(trees.tree)}}, trees.work};
    trees.tree.clear();
    trees.work = 0;
    result.append(std::move(trees));
    return result;
  }
  return std::nullopt;
}

template <std::size_t D>
std::optional<std::size_t> Critical_prover<D>::entry_for(std::size_t polynomial, std::size_t axis)
{
  const auto key = std::pair(polynomial, axis);
  const auto found = known_.find(key);
  if (found != known_.end()) return found->second;
  const auto made = make_entry(polynomial, axis);
  known_.emplace(key, made);
  return made;
}

template <std::size_t D>
std::optional<std::size_t> Critical_prover<D>::make_entry(std::size_t polynomial, std::size_t axis)
{
  const auto& f = *polynomials_[polynomial];
  const auto slope = derivative(f, axis);
  std::optional<exact::Cofactors<D>> found;
  std::vector<std::pair<Polynomial<Integer, D>, unsigned>> factors;
  try {
    found = exact::cofactors(f, slope, axis, checkpoint_);
    if (found) factors = exact::square_free_factors(found->combination);
  } catch (const Budget_exceeded&) {
    return std::nullopt;
  }
  if (!found || found->b.is_zero() || !fits(found->a) || !fits(found->b)) return std::nullopt;
  Critical_entry<D> entry{polynomial, axis, found->a, found->b, {}, {}};
  entry.size = text_size(entry.a, entry.b);
  entry.size.work = product_work(entry.a, f) + product_work(entry.b, slope);
  for (auto& [factor, exponent] : factors) {
    if (!fits(factor)) return std::nullopt;
    const auto size = text_size(factor, factor);
    entry.size.bytes += size.bytes;
    entry.size.values += size.values;
    entry.size.work += exponent * product_work(factor, found->combination);
    entry.factors.push_back({polynomials_.size() + entry.factors.size(), exponent,
                             std::make_shared<const Polynomial<Integer, D>>(std::move(factor))});
  }
  for (const auto& factor : entry.factors) polynomials_.push_back(factor.polynomial);
  entries_.push_back(std::make_shared<const Critical_entry<D>>(std::move(entry)));
  return entries_.size() - 1;
}

template <std::size_t D>
Proof_size Critical_record<D>::size_of(const Proof_part& part, const Critical_entries<D>& entries) const
{
  Proof_size result{part.work, static_cast<double>(part.tree.size()), 4 * static_cast<double>(part.entries.size())};
  const auto add = [&](const Proof_size& more) {
    result.work += more.work;
    result.bytes += more.bytes;
    result.values += more.values;
  };
  std::vector<bool> counted(entries.size());
  for (const auto& proof : part.entries) {
    result.bytes += static_cast<double>(proof.trees.size()) + 30;
    if (!used_.contains(proof.multipliers) && !counted[proof.multipliers]) add(entries[proof.multipliers]->size);
    counted[proof.multipliers] = true;
  }
  return result;
}

template <std::size_t D>
void Critical_record<D>::add(Proof_part part, const Critical_entries<D>& entries)
{
  for (const auto& proof : part.entries) used_.try_emplace(proof.multipliers, entries[proof.multipliers]);
  critical_.insert(critical_.end(), std::make_move_iterator(part.entries.begin()),
                   std::make_move_iterator(part.entries.end()));
}

/// Entries that no proof uses are left out, so that all numbers change.
template <std::size_t D>
void Critical_record<D>::write_to(Certificate<D>& certificate) &&
{
  std::map<std::size_t, std::size_t> number_of; // polynomials
  for (std::size_t k = 0; k < given_; ++k) number_of[k] = k;
  std::map<std::size_t, std::size_t> index_of; // entries
  for (const auto& [index, entry] : used_) {
    index_of[index] = certificate.multipliers.size();
    Multipliers<D> result{number_of.at(entry->of), entry->a, {}, {}};
    result.b[entry->axis] = entry->b;
    for (const auto& factor : entry->factors) {
      const std::size_t next = number_of.size();
      number_of[factor.number] = next;
      result.factors.emplace_back(*factor.polynomial, factor.exponent);
    }
    certificate.multipliers.push_back(std::move(result));
  }
  for (auto& proof : critical_) proof.multipliers = index_of.at(proof.multipliers);
  certificate.critical = std::move(critical_);
}

template class Critical_prover<2>;
template class Critical_prover<3>;
template class Critical_record<2>;
template class Critical_record<3>;

} // namespace corral::certificate
