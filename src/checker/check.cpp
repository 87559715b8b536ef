// SPDX-License-Identifier: LGPL-3.0-or-later
#include "check.h"

#include "bernstein.h"
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
  int level = 0;
  int axis = -1;

  [[nodiscard]] double weight() const
  {
    double sum = 0;
    for (const Bernstein_form& form : forms) sum += form.weight();
    return sum;
  }
};

/// Goes through the tree of section 3 in its order, with a stack of its own: no depth can overflow the machine's.
class Walk
{
public:
  Walk(const Certificate& certificate, Budget& budget) : certificate_(certificate), budget_(budget)
  {
    for (const std::uint64_t n : certificate.resolution) exponents_.push_back(static_cast<int>(std::bit_width(n - 1)));
  }

  Counts run()
  {
    push(root());
    while (!stack_.empty()) {
      Node node = std::move(stack_.back());
      stack_.pop_back();
      held_ -= node.weight();
      if (node.axis >= 0)
        halve_node(std::move(node));
      else
        read_node(std::move(node));
    }
    require(position_ == certificate_.tree.size(), "tree", "continues after its end");
    require(used_witnesses_ == certificate_.witnesses.size(), "witnesses", "has an entry that the tree does not use");
    require(used_reasons_.size() == certificate_.reasons, "reasons", "has an entry that the tree does not use");
    return counts_;
  }

private:
  [[nodiscard]] std::uint64_t span(int level, std::size_t axis) const
  {
    return std::uint64_t{1} << std::clamp(level, 0, exponents_[axis]);
  }

  [[nodiscard]] Node root()
  {
    Node node;
    node.level = *std::max_element(exponents_.begin(), exponents_.end());
    node.corner.resize(certificate_.dimension);
    Box box = certificate_.box;
    for (std::size_t axis = 0; axis < box.size(); ++axis)
      box[axis].upper = box[axis].lower + certificate_.step[axis] * mpz_class(1UL << exponents_[axis]);
    for (const Polynomial& g : certificate_.reduced) node.forms.push_back(bernstein(g, box, budget_));
    return node;
  }

  void push(Node node)
  {
    held_ += node.weight();
    Budget::memory(held_);
    stack_.push_back(std::move(node));
  }

  /// Halves a node whose level is already that of its children along its axis, if the tree does so.
  void halve_node(Node node)
  {
    const auto axis = static_cast<std::size_t>(node.axis--);
    if (node.level >= exponents_[axis] && node.level >= 0) return push(std::move(node));
    Node upper = node;
    for (std::size_t j = 0; j < node.forms.size(); ++j)
      std::tie(node.forms[j], upper.forms[j]) = halve(node.forms[j], axis, budget_);
    if (node.level >= 0) upper.corner[axis] += std::uint64_t{1} << node.level;
    if (upper.corner[axis] < certificate_.resolution[axis]) push(std::move(upper));
    push(std::move(node));
  }

  void read_node(Node node)
  {
    require(position_ < certificate_.tree.size(), "tree", "ends before all cells are covered");
    const char symbol = certificate_.tree[position_++];
    if (symbol == 's') {
      if (node.level == 0) ++counts_.empty; // what follows must prove it
      require(--node.level >= min_level, "tree", "is deeper than 1000 levels below the cells");
      node.axis = static_cast<int>(certificate_.dimension) - 1;
      return push(std::move(node));
    }
    if (symbol == 'e') return read_empty(node);
    const bool is_digit = symbol >= '0' && symbol <= '9';
    if (!is_digit && symbol != 'h' && symbol != 'w') reject(place(node), "the character is none of s, e, h, w, 0 to 9");
    require(node.level >= 0, place(node), "below a cell there is only s or e");
    if (is_digit) return read_unknown(node, static_cast<std::size_t>(symbol - '0'));
    require(node.level == 0, place(node), "h and w belong to cells");
    ++counts_.hit;
    if (symbol == 'w') return read_witness(node);
    require(certificate_.reduced.size() == 1, place(node), "h proves nothing of several polynomials");
    require(corners_show_zero(node.forms.front()), place(node), "the corners of the cell have one strict sign");
  }

  void read_empty(const Node& node)
  {
    const bool excluded = std::any_of(node.forms.begin(), node.forms.end(), excludes_zero);
    require(excluded, place(node), "the Bernstein coefficients do not exclude a zero");
    if (node.level >= 0) counts_.empty += cells(node);
  }

  void read_unknown(const Node& node, std::size_t reason)
  {
    require(reason < certificate_.reasons, place(node), "the reason is not in the list");
    used_reasons_.insert(reason);
    counts_.unknown += cells(node);
  }

  void read_witness(const Node& node)
  {
    require(used_witnesses_ < certificate_.witnesses.size(), place(node), "there is no witness left");
    Box cell;
    for (std::size_t axis = 0; axis < certificate_.dimension; ++axis) {
      const mpq_class& step = certificate_.step[axis];
      const mpq_class lower = certificate_.box[axis].lower + step * mpz_class(node.corner[axis]);
      cell.push_back({lower, lower + step});
    }
    check_witness(certificate_.witnesses[used_witnesses_], certificate_, cell,
                  "witness " + std::to_string(used_witnesses_) + " (" + place(node) + ")", budget_);
    ++used_witnesses_;
  }

  [[nodiscard]] std::uint64_t cells(const Node& node) const
  {
    std::uint64_t product = 1;
    for (std::size_t axis = 0; axis < certificate_.dimension; ++axis)
      product *= std::min(span(node.level, axis), certificate_.resolution[axis] - node.corner[axis]);
    return product;
  }

  [[nodiscard]] std::string place(const Node& node) const
  {
    std::string result = "leaf " + std::to_string(position_ - 1) + " at cell";
    for (std::size_t axis = 0; axis < node.corner.size(); ++axis)
      result.append(axis == 0 ? " " : ",").append(std::to_string(node.corner[axis]));
    return result + " level " + std::to_string(node.level);
  }

  const Certificate& certificate_;
  Budget& budget_;
  std::vector<int> exponents_; ///< K_k
  std::vector<Node> stack_;
  double held_ = 0;
  std::size_t position_ = 0;
  std::size_t used_witnesses_ = 0;
  std::set<std::size_t> used_reasons_;
  Counts counts_;
};

} // namespace

Counts check(std::string_view bytes)
{
  Budget budget;
  const Certificate certificate = read_certificate(bytes, budget);
  const Counts counts = Walk(certificate, budget).run();
  require(counts.empty == certificate.counts.empty, "empty", "is not the number of cells that the tree proves empty");
  require(counts.hit == certificate.counts.hit, "hit", "is not the number of cells that the tree proves hit");
  require(counts.unknown == certificate.counts.unknown, "unknown", "is not the number of cells left unknown");
  return counts;
}

} // namespace corral_check
