// SPDX-License-Identifier: LGPL-3.0-or-later
#include "../exact/Bernstein_form.h"
#include "validate.h"

#include <corral/localization/Subdivision.h>
#include <corral/polynomial/integer_form.h>
#include <corral/polynomial/substitution.h>
#include <corral/verification/certificate.h>
#include <corral/verification/ideal_raster.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace corral {
namespace {

using exact::Bernstein_form;

template <std::size_t D>
void require_limits(const Polynomial<Rational, D>& f, const char* what)
{
  double dense = 1;
  for (std::size_t axis = 0; axis < D; ++axis) {
    dense *= f.degree(axis) + 1;
    if (f.degree(axis) > 1000)
      throw Budget_exceeded("certificate: " + std::string(what) + " has the degree " + std::to_string(f.degree(axis))
                            + " in one variable; expected at most 1000");
  }
  if (dense > 65536)
    throw Budget_exceeded("certificate: " + std::string(what)
                          + " has too high a degree; expected (degree + 1) of all variables multiplied to be at most "
                            "65536");
}

template <std::size_t D>
Certificate<D> start(const Polynomial<Rational, D>& f, const Polynomial<Integer, D>& g, const Grid<D>& grid)
{
  constexpr double max_cells = 4611686018427387904.0; // 2^62
  if (grid.cell_count() >= max_cells)
    throw Invalid_input("certificate: the grid has 2^62 cells or more; expected fewer");
  require_limits(f, "the polynomial");
  Certificate<D> result{f, g, 1, grid, {}, {}, {}, 0, 0, 0};
  if (integer_primitive(f) != g) result.power = certificate::highest_multiplicity(f);
  return result;
}

/// Walks the subdivision tree depth first and writes down what it proves.
template <std::size_t D>
class Certifier
{
public:
  using Node = Subdivision_node<D>;
  using Form = Bernstein_form<D>;

  Certifier(const Polynomial<Rational, D>& f, const Grid<D>& grid, const Certify_options& options)
      : options_(options), cell_count_(grid.cell_count()), tree_(grid.resolution()),
        decider_(f, grid, [this] { require_going(); }),
        rational_(transform<Rational>(decider_.square_free(), [](const Integer& c) { return Rational(c); })),
        result_(start(f, decider_.square_free(), grid))
  {}

  Certificate<D> run() &&
  {
    const Node root = tree_.root();
    std::array<Rational, D> offset;
    std::array<Rational, D> scale;
    for (std::size_t axis = 0; axis < D; ++axis) {
      offset[axis] = result_.grid.box()[axis].lower();
      scale[axis] = result_.grid.step(axis) * tree_.span(root.level, axis);
    }
    Form form = exact::dense_power_form(integer_primitive(affine_substitution(rational_, offset, scale)));
    exact::to_bernstein(form);
    exact::drop_twos(form);
    visit(std::move(form), root);
    return std::move(result_);
  }

private:
  /// What an attempt to prove a cell empty came to.
  enum class Attempt { proved, zero, gave_up };

  /// A box inside a cell: [index, index + 1] / 2^depth along each axis of the cell.
  struct Piece
  {
    Form form;
    std::array<Integer, D> index{};
    unsigned depth = 0;
  };

  /// A search below one cell.
  struct Search
  {
    std::size_t boxes_left;
    int sign; ///< of all corners of the cell
    std::string tree{};
    Rational_point<D> zero{}; ///< in the cell's own coordinates, a point where the sign differs
    int zero_sign = 0;
  };

  /// Whether to go on; once stopped, for good.
  bool goes_on()
  {
    if (!stopped_ && options_.progress) {
      stopped_ = !options_.progress(static_cast<double>(settled_) / cell_count_);
    }
    return !stopped_;
  }

  void require_going()
  {
    if (!goes_on()) throw Cancelled("certificate: stopped by the caller");
  }

  void visit(Form form, const Node& node)
  {
    settled_ = result_.empty + result_.hit + result_.unknown;
    if (!goes_on()) return leave_unknown("stopped before it was decided", node);
    const auto pattern = exact::sign_pattern(form);
    if (pattern.hull != 0) {
      result_.tree += 'e';
      result_.empty += cells(node);
    } else if (node.level == 0)
      visit_cell(std::move(form), pattern, node);
    else {
      result_.tree += 's';
      visit_children(std::move(form), {node.level - 1, node.corner}, D);
    }
  }

  /// Visits the children in the order of their numbers: the last axis is halved first, so that it varies slowest.
  void visit_children(Form form, Node child, std::size_t axes)
  {
    if (axes == 0) return visit(std::move(form), child);
    const std::size_t axis = axes - 1;
    if (!tree_.halves(child.level + 1, axis)) return visit_children(std::move(form), child, axis);
    visit_children(exact::halve(form, axis), child, axis);
    child.corner[axis] += tree_.span(child.level, axis);
    if (child.corner[axis] < result_.grid.resolution()[axis]) visit_children(std::move(form), child, axis);
  }

  void visit_cell(Form form, const exact::Sign_pattern& pattern, const Node& node)
  {
    if (pattern.crosses) {
      result_.tree += 'h';
      ++result_.hit;
      return;
    }
    constexpr std::size_t first_boxes = 64; // a cut or two prove most empty cells
    try {
      if (attempt(form, pattern.corners, first_boxes, node)) return;
      const auto decision = decider_.decide(node.corner);
      if (decision.verdict == Verdict::unknown) return leave_unknown("not decided: " + decision.reason, node);
      if (decision.verdict == Verdict::hit) return add_witness(decision.witness, node);
      if (!attempt(form, pattern.corners, options_.max_boxes, node))
        leave_unknown("empty, but a proof would take more boxes than allowed", node);
    } catch (const Cancelled&) {
      leave_unknown("stopped before it was decided", node);
    }
  }

  /// Tries to prove the cell empty by cutting it; whether something was proved and written.
  bool attempt(const Form& form, int sign, std::size_t boxes, const Node& node)
  {
    Search search{boxes, sign};
    const Attempt outcome = search_piece({form, {}, 0}, search);
    if (outcome == Attempt::gave_up) return false;
    if (outcome == Attempt::proved) {
      result_.tree += search.tree;
      ++result_.empty;
      return true;
    }
    const auto box = result_.grid.cell_box(node.corner);
    Rational_point<D> corner;
    Rational_point<D> other;
    for (std::size_t axis = 0; axis < D; ++axis) {
      corner[axis] = box[axis].lower();
      other[axis] = corner[axis] + result_.grid.step(axis) * search.zero[axis];
    }
    add_witness(Sign_change<D>{search.zero_sign == 0 ? other : corner, other}, node);
    return true;
  }

  Attempt search_piece(Piece piece, Search& search)
  {
    constexpr unsigned max_depth = 400;
    if (const auto corner = other_corner(piece, search.sign)) {
      for (std::size_t axis = 0; axis < D; ++axis)
        search.zero[axis] = Rational(piece.index[axis] + (*corner >> axis & 1), Integer(Integer(1) << piece.depth));
      for (Rational& u : search.zero) u.canonicalize();
      search.zero_sign = sgn(piece.form.corner(*corner));
      return Attempt::zero;
    }
    if (exact::sign_pattern(piece.form).hull != 0) {
      search.tree += 'e';
      return Attempt::proved;
    }
    if (search.boxes_left < (1U << D) || piece.depth == max_depth) return Attempt::gave_up;
    search.boxes_left -= 1U << D;
    search.tree += 's';
    ++piece.depth;
    for (Integer& i : piece.index) i *= 2;
    return search_children(std::move(piece), search, D);
  }

  Attempt search_children(Piece piece, Search& search, std::size_t axes)
  {
    if (axes == 0) {
      require_going();
      return search_piece(std::move(piece), search);
    }
    const std::size_t axis = axes - 1;
    Piece lower{exact::halve(piece.form, axis), piece.index, piece.depth};
    ++piece.index[axis];
    const Attempt first = search_children(std::move(lower), search, axis);
    return first == Attempt::proved ? search_children(std::move(piece), search, axis) : first;
  }

  /// A corner of the piece where the sign is not that of the cell's corners.
  static std::optional<unsigned> other_corner(const Piece& piece, int sign)
  {
    for (unsigned corner = 0; corner < 1U << D; ++corner)
      if (sgn(piece.form.corner(corner)) != sign) return corner;
    return std::nullopt;
  }

  void add_witness(const Witness<D>& witness, const Node& node)
  {
    if (!certificate::is_acceptable(witness, rational_, result_.grid.cell_box(node.corner)))
      return leave_unknown("hit, but the decision left no witness that the format can hold", node);
    result_.tree += 'w';
    ++result_.hit;
    result_.witnesses.push_back({node.corner, witness});
  }

  void leave_unknown(const std::string& reason, const Node& node)
  {
    constexpr std::size_t max_reasons = 10;
    auto& reasons = result_.reasons;
    auto found = std::find(reasons.begin(), reasons.end(), reason);
    if (found == reasons.end() && reasons.size() < max_reasons) found = reasons.insert(found, reason);
    if (found == reasons.end()) *--found = "several other reasons";
    result_.tree += static_cast<char>('0' + (found - reasons.begin()));
    result_.unknown += cells(node);
  }

  [[nodiscard]] std::uint64_t cells(const Node& node) const
  {
    std::uint64_t product = 1;
    for (std::size_t axis = 0; axis < D; ++axis) product *= tree_.end(node, axis) - node.corner[axis];
    return product;
  }

  const Certify_options& options_;
  double cell_count_;
  std::uint64_t settled_ = 0; ///< cells
  bool stopped_ = false;
  Subdivision_tree<D> tree_;
  Cell_decider<D> decider_;
  Polynomial<Rational, D> rational_; ///< the square-free part
  Certificate<D> result_;
};

} // namespace

template <std::size_t D>
Certificate<D> certify(const Polynomial<Rational, D>& f, const Grid<D>& grid, const Certify_options& options)
{
  return Certifier<D>(f, grid, options).run();
}

template Certificate<1> certify(const Polynomial<Rational, 1>&, const Grid<1>&, const Certify_options&);
template Certificate<2> certify(const Polynomial<Rational, 2>&, const Grid<2>&, const Certify_options&);
template Certificate<3> certify(const Polynomial<Rational, 3>&, const Grid<3>&, const Certify_options&);

} // namespace corral
