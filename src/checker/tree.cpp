// SPDX-License-Identifier: LGPL-3.0-or-later
#include "tree.h"

#include "critical.h"
#include "witness.h"

#include <algorithm>
#include <bit>
#include <set>

namespace corral_check {
namespace {

constexpr int min_level = -1000;

/// A box of the tree. As long as `axis` is not negative it still has to be halved along the axes 0 to `axis`.
struct Node
{
  std::vector<Bernstein_form> forms; ///< one for each g_j
  std::vector<std::uint64_t> corner;
  std::vector<mpz_class> part; ///< below the cells: the index within the cell, in boxes of this level
  int level = 0;
  int axis = -1;
  std::size_t depth = 1;
  double held = 0;
};

/// Goes through the tree with a stack of its own: no depth can overflow the machine's.
class Walk
{
public:
  Walk(const Contents& contents, const std::function<void(const Region&)>& visit)
      : contents_(contents), visit_(visit), critical_(contents, budget_)
  {
    budget_.work(contents.work);
    for (const std::uint64_t n : contents.claims.resolution)
      exponents_.push_back(static_cast<int>(std::bit_width(n - 1)));
  }

  Counts run()
  {
    Items witnesses(contents_.witnesses, "witnesses");
    witnesses_ = &witnesses;
    stack_.push_back(root());
    while (!stack_.empty()) {
      Node node = std::move(stack_.back());
      stack_.pop_back();
      if (node.axis >= 0)
        halve_node(std::move(node));
      else
        read_node(std::move(node));
    }
    require(position_ == contents_.tree.size(), here("tree"), "continues after its end");
    Value left;
    require(!witnesses.next(left), left.place("witnesses"), "has an entry that the tree does not use");
    require(critical_.all_used(), {"critical"}, "has an entry that the tree does not use");
    require(used_reasons_.size() == contents_.reasons, {"reasons"}, "has an entry that the tree does not use");
    return counts_;
  }

private:
  [[nodiscard]] std::size_t dimension() const { return contents_.dimension(); }

  /// A place of the tree, at the character that is read next. The byte is right if the string has no escapes.
  [[nodiscard]] Place here(std::string words) const
  {
    return {std::move(words), contents_.tree_value.byte() + 1 + position_};
  }

  [[nodiscard]] std::uint64_t span(int level, std::size_t axis) const
  {
    return std::uint64_t{1} << std::clamp(level, 0, exponents_[axis]);
  }

  [[nodiscard]] Node root()
  {
    Node node;
    node.level = *std::max_element(exponents_.begin(), exponents_.end());
    node.corner.resize(dimension());
    node.part.resize(dimension());
    const Box box = box_of(node);
    for (std::size_t j = 0; j < contents_.given; ++j) {
      node.forms.push_back(bernstein(contents_.proved[j], box, budget_));
      node.held += held_by(node.forms.back());
    }
    require_branch(node.depth, node.held, here("tree"));
    return node;
  }

  /// The node's box in x coordinates.
  [[nodiscard]] Box box_of(const Node& node) const
  {
    Box result;
    for (std::size_t axis = 0; axis < dimension(); ++axis) {
      const mpq_class& step = contents_.step[axis];
      mpq_class lower = contents_.box[axis].lower + step * mpz_class(node.corner[axis]);
      mpq_class width = step * mpz_class(span(node.level, axis));
      if (node.level < 0) {
        width >>= static_cast<mp_bitcnt_t>(-node.level);
        lower += width * node.part[axis];
      }
      result.push_back({lower, lower + width});
    }
    return result;
  }

  /// Halves a node whose level is already that of its children along its axis, if the tree does so.
  void halve_node(Node node)
  {
    const auto axis = static_cast<std::size_t>(node.axis--);
    if (node.level >= exponents_[axis] && node.level >= 0) {
      stack_.push_back(std::move(node));
      return;
    }
    Node upper{{}, node.corner, node.part, node.level, node.axis, node.depth, node.held};
    for (Bernstein_form& form : node.forms) {
      auto halves = halve(form, axis, budget_);
      form = std::move(halves.first);
      upper.forms.push_back(std::move(halves.second));
    }
    if (node.level >= 0)
      upper.corner[axis] += std::uint64_t{1} << node.level;
    else
      ++upper.part[axis];
    if (upper.corner[axis] < contents_.claims.resolution[axis]) stack_.push_back(std::move(upper));
    stack_.push_back(std::move(node));
  }

  void read_node(Node node)
  {
    require(position_ < contents_.tree.size(), here("tree"), "ends before all cells are covered");
    const Place place = here(words_for(node));
    const char symbol = contents_.tree[position_++];
    for (const Bernstein_form& form : node.forms) budget_.work(static_cast<double>(form.coefficients.size()));
    if (symbol == 's') return split(std::move(node), place);
    if (symbol == 'e') return read_empty(node, place);
    if (symbol == 'c') return read_critical(std::move(node), place);
    const bool is_digit = symbol >= '0' && symbol <= '9';
    require(is_digit || symbol == 'h' || symbol == 'w', place, "the character is none of s, e, c, h, w, 0 to 9");
    require(node.level >= 0, place, "below a cell there is only s, e or c");
    if (is_digit) return read_unknown(node, static_cast<std::size_t>(symbol - '0'), place);
    require(node.level == 0, place, "h and w belong to cells");
    settle(node, 'h', counts_.hit);
    if (symbol == 'w') return read_witness(node, place);
    require(contents_.given == 1, place, "h proves nothing of several polynomials");
    require(corners_show_zero(node.forms.front()), place, "the corners of the cell have one strict sign");
  }

  void split(Node node, const Place& place)
  {
    if (node.level == 0) settle(node, 'e', counts_.empty); // what follows must prove it
    limit(--node.level >= min_level, place, "deeper than 1000 levels below the cells");
    if (node.level < 0)
      for (mpz_class& part : node.part) part *= 2;
    for (const Bernstein_form& form : node.forms) {
      Bernstein_form child{form.sizes, {}, form.bit_bound};
      for (std::size_t axis = 0; axis < dimension(); ++axis)
        if (node.level < exponents_[axis]) child.bit_bound += static_cast<double>(form.sizes[axis] - 1);
      node.held += static_cast<double>(dimension() + 1) * static_cast<double>(form.coefficients.size())
                   * (words(child.bit_bound) + 5);
    }
    require_branch(++node.depth, node.held, place);
    node.axis = static_cast<int>(dimension()) - 1;
    stack_.push_back(std::move(node));
  }

  void read_empty(const Node& node, const Place& place)
  {
    const bool excluded = std::any_of(node.forms.begin(), node.forms.end(), excludes_zero);
    require(excluded, place, "the Bernstein coefficients do not exclude a zero");
    if (node.level >= 0) settle(node, 'e', counts_.empty);
  }

  void read_critical(Node node, const Place& place)
  {
    const Box box = box_of(node);
    std::vector<Face> faces;
    for (std::size_t j = 0; j < node.forms.size(); ++j)
      faces.push_back({std::move(node.forms[j]), box, j, node.depth, node.held});
    critical_.prove(faces, place);
    if (node.level >= 0) settle(node, 'e', counts_.empty);
  }

  void read_unknown(const Node& node, std::size_t reason, const Place& place)
  {
    require(reason < contents_.reasons, place, "the reason is not in the list");
    used_reasons_.insert(reason);
    settle(node, 'u', counts_.unknown);
  }

  void read_witness(const Node& node, const Place& place)
  {
    Value witness;
    require(witnesses_->next(witness), place, "there is no witness left");
    const std::string where = "witness " + std::to_string(used_witnesses_++) + " (" + place.words + ")";
    check_witness(witness, contents_, box_of(node), where, budget_);
  }

  /// Counts the cells of a node.
  void settle(const Node& node, char verdict, std::uint64_t& count)
  {
    Region region{node.corner, {}, verdict};
    std::uint64_t product = 1;
    for (std::size_t axis = 0; axis < dimension(); ++axis) {
      region.size.push_back(std::min(span(node.level, axis), contents_.claims.resolution[axis] - node.corner[axis]));
      product *= region.size.back();
    }
    count += product;
    if (visit_) visit_(region);
  }

  [[nodiscard]] std::string words_for(const Node& node) const
  {
    std::string result = "leaf " + std::to_string(position_) + " at cell";
    for (std::size_t axis = 0; axis < node.corner.size(); ++axis)
      result.append(axis == 0 ? " " : ",").append(std::to_string(node.corner[axis]));
    return result + " level " + std::to_string(node.level);
  }

  const Contents& contents_;
  const std::function<void(const Region&)>& visit_;
  Budget budget_;
  Critical_proofs critical_;
  Items* witnesses_ = nullptr;
  std::vector<int> exponents_; ///< K_k
  std::vector<Node> stack_;
  std::size_t position_ = 0;
  std::size_t used_witnesses_ = 0;
  std::set<std::size_t> used_reasons_;
  Counts counts_;
};

} // namespace

Counts check_tree(const Contents& contents, const std::function<void(const Region&)>& visit)
{
  return Walk(contents, visit).run();
}

} // namespace corral_check
